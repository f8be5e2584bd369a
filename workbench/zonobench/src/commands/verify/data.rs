//! An answer about a data file: the question that it answers, and what can be said of it.
//!
//! The question is the one that the answer records. Options on the command line may repeat it; if they ask something
//! else, or the answer records nothing, an answer that is wrong for the question at hand may be right for its own, so
//! it is left unchecked. An answer that is right for the question at hand is right, wherever it comes from.

use std::path::Path;

use batch::json::Tree;

use super::about::{AboutData, NO_RECORD, OTHER_DATA, cannot_be_asked};
use super::documents::{first_document, standard_input_holds_questions};
use crate::commands::asking::{Asking, Recorded};
use crate::commands::usage::question_name;
use crate::input::Format;

/// The question that `enclose` was asked about the file, if the file holds data and no questions.
pub(super) fn question(file: &Path, asking: &Asking, answer: Option<&Tree>) -> anyhow::Result<Option<AboutData>> {
    let recorded = answer.and_then(Recorded::of);
    let recorded_format = recorded.as_ref().and_then(|recorded| recorded.as_ref().ok()?.asking.points.format);
    let format = asking.points.source(file)?.known_format().or(recorded_format);
    // The content tells the format where the name does not.
    let is_named = Format::of_extension(file).is_some_and(|format| format != Format::Json);
    if format.is_none() || (asking.points.format.is_none() && !is_named && holds_lines(file)?) {
        return Ok(None);
    }
    // Options that contradict each other are a mistake of the command line, whatever the answer says.
    asking.stated_objective(file)?;
    Ok(Some(match recorded {
        None => without_record(asking, file)?,
        Some(Err(error)) => AboutData::without_question(error.to_string()),
        Some(Ok(recorded)) => with_record(asking, &recorded, file)?,
    }))
}

fn without_record(asking: &Asking, file: &Path) -> anyhow::Result<AboutData> {
    let (question, _) = asking.question(&question_name(file), file)?;
    Ok(AboutData { question: Ok(question), doubt: Some(NO_RECORD), unknown: None })
}

fn with_record(asking: &Asking, recorded: &Recorded, file: &Path) -> anyhow::Result<AboutData> {
    let name = question_name(file);
    let (question, reading) = match recorded.asking.question(&name, file) {
        Ok(question) => question,
        Err(error) => {
            let files = [(file, Some(recorded.sha256.as_str()))];
            let reason = cannot_be_asked(files, " of this file", &error);
            return Ok(AboutData::without_question(reason));
        }
    };
    let wanted = asking.or(&recorded.asking);
    // Standard input can be read once, so options that repeat what is recorded do not read the data again.
    if wanted != recorded.asking {
        let asked = wanted.question(&name, file).map(|(question, _)| question);
        if !asked.is_ok_and(|asked| asked == question) {
            let reason = "the options ask for something else than the answer records".to_owned();
            return Ok(AboutData::without_question(reason));
        }
    }
    let has_changed = reading.sha256 != recorded.sha256;
    let doubt = has_changed.then_some(OTHER_DATA);
    Ok(AboutData { question: Ok(question), doubt, unknown: recorded.unknown.clone() })
}

/// Whether the first line of a file is a question or an answer: data have no kind.
fn holds_lines(file: &Path) -> anyhow::Result<bool> {
    if file.as_os_str() == "-" {
        return Ok(standard_input_holds_questions());
    }
    Ok(first_document(file)?.is_some_and(|first| first.field("kind").is_some()))
}
