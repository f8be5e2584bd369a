//! An answer about a data file: the question that it answers, and what can be said of it.
//!
//! The question is the one that the answer records. Options on the command line may repeat it; if they ask something
//! else, or the answer records nothing, an answer that is wrong for the question at hand may be right for its own, so
//! it is left unchecked. An answer that is right for the question at hand is right, wherever it comes from.

use std::io::BufRead;
use std::path::Path;

use super::{Options, question_name};
use crate::commands::asking::{Asking, Recorded};
use crate::commands::{Ending, open};
use crate::input::Format;
use crate::lines::Lines;
use batch::Line;
use batch::MAX_LINE_BYTES;
use batch::json::{self, MAX_VALUES, Tree};
use batch::{Verdict, check};

/// What is said of an answer to another question than the one at hand, as far as anyone knows.
const NO_RECORD: &str = "the answer does not record what was asked, and as an answer to these options it fails";
const OTHER_DATA: &str = "the data are not those that the answer was computed from, and for these it fails";

/// A question about a data file.
pub(super) struct AboutData {
    question: Result<Tree, String>,
    /// Why an answer that fails the check may be right for another question, or for other data.
    doubt: Option<&'static str>,
    /// A field of the answer's request that says nothing to this program.
    unknown: Option<String>,
}

/// The question that `enclose` was asked about the file, if the file holds data and no questions.
pub(super) fn question(options: &Options, answer: Option<&Tree>) -> anyhow::Result<Option<AboutData>> {
    let (file, asking) = (&options.questions, &options.asking);
    let recorded = answer.and_then(Recorded::of);
    let recorded_format = recorded.as_ref().and_then(|recorded| recorded.as_ref().ok()?.asking.points.format);
    let is_standard_input = file.as_os_str() == "-";
    let format = asking.points.source(file)?.known_format().or(recorded_format.filter(|_| !is_standard_input));
    // What the name does not tell, the content does.
    let is_named = Format::of_extension(file).is_some_and(|format| format != Format::Json);
    if format.is_none() || (asking.points.format.is_none() && !is_named && holds_questions(file)?) {
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
            let reason = format!("the question that the answer records cannot be asked: {error:#}");
            return Ok(AboutData::without_question(reason));
        }
    };
    if !asking.is_empty() {
        let asked = asking.or(&recorded.asking).question(&name, file).map(|(question, _)| question);
        if !asked.is_ok_and(|asked| asked == question) {
            let reason = "the options ask for something else than the answer records".to_owned();
            return Ok(AboutData::without_question(reason));
        }
    }
    let has_changed = reading.sha256 != recorded.sha256;
    let doubt = has_changed.then_some(OTHER_DATA);
    Ok(AboutData { question: Ok(question), doubt, unknown: recorded.unknown.clone() })
}

impl AboutData {
    /// Nothing can be judged, for the given reason.
    fn without_question(reason: String) -> Self {
        Self { question: Err(reason), doubt: None, unknown: None }
    }

    /// The question, if it can be asked.
    pub(super) fn question(&self) -> Option<&Tree> {
        self.question.as_ref().ok()
    }

    /// What is to be said of an answer, and whether the command has done what it was asked to: it has not where
    /// nothing could be judged.
    pub(super) fn judge(&self, answer: &Tree) -> (Verdict, Ending) {
        let question = match &self.question {
            Ok(question) => question,
            Err(reason) => return (Verdict::Unchecked(reason.clone()), Ending::Bad),
        };
        match (check(&named_after(question, answer), answer), &self.doubt) {
            (Verdict::Wrong(complaint), Some(doubt)) => {
                (Verdict::Unchecked(format!("{doubt}: {complaint}")), Ending::Bad)
            }
            (verdict @ Verdict::Wrong(_), None) => (verdict, Ending::Bad),
            (Verdict::Right(proved), _) => (self.beside_what_is_unknown(proved), Ending::Good),
            (verdict @ Verdict::Unchecked(_), _) => (verdict, Ending::Good),
        }
    }

    /// What is said of an answer for which something has been proved.
    fn beside_what_is_unknown(&self, proved: String) -> Verdict {
        match &self.unknown {
            None => Verdict::Right(proved),
            Some(name) => Verdict::Unchecked(format!("the field `request, {name}` is not checked; the rest: {proved}")),
        }
    }
}

/// The question under the name that the answer has: data are asked about under whatever name.
fn named_after(question: &Tree, answer: &Tree) -> Tree {
    let mut question = question.clone();
    if let (Tree::Object(fields), Some(id)) = (&mut question, answer.field("id")) {
        fields.iter_mut().filter(|(name, _)| name == "id").for_each(|(_, own)| *own = id.clone());
    }
    question
}

/// Whether the first line of a file is a question: data have no kind.
fn holds_questions(file: &Path) -> anyhow::Result<bool> {
    let source: Box<dyn BufRead> = open(Some(file))?;
    let first = Lines::new(source, MAX_LINE_BYTES).next().transpose()?;
    let Some((_, Line::Content(text))) = first else { return Ok(false) };
    Ok(json::read(&text, MAX_VALUES).is_ok_and(|first| first.field("kind").is_some()))
}
