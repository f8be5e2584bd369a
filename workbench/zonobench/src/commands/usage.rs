//! Command lines that parse but make no sense.

use std::io::{self, Write};
use std::path::{Path, PathBuf};

use batch::{Line, did_you_mean};
use thiserror::Error;

use crate::input::{InputError, PointSource, Reading, Wanted, json_losses, on_one_line};

/// Why a command line that parses makes no sense.
#[derive(Debug, Error, PartialEq, Eq)]
#[non_exhaustive]
pub enum Usage {
    /// An option does not apply to what is asked, or contradicts another one.
    #[error("{option}: {reason}")]
    DoesNotApply {
        /// The option as it is written.
        option: &'static str,
        /// Why it does not apply.
        reason: &'static str,
    },
    /// An id names nothing that there is.
    #[error(
        "'{0}': there is no experiment or figure of this name; `zonobench list` names those that there are{near}",
        near = near_id(.0)
    )]
    UnknownId(String),
    /// The id of an experiment stands where that of a figure is wanted.
    #[error("'{0}' is an experiment, not a figure; `zonobench reproduce --only {0}` runs it")]
    NoFigure(&'static str),
    /// There is no command of the name.
    #[error("'{name}': there is no command of this name; `zonobench help` names those that there are{near}")]
    UnknownCommand {
        /// The name.
        name: String,
        /// The nearest one as the end of the sentence, if there is a near one.
        near: String,
    },
    /// Options tell what was asked of a data file, but there is a file of questions.
    #[error(
        "{}: read as questions, which tell themselves what is asked; other options are for a data file, whose format \
         --format tells where the name does not",
        .0.display()
    )]
    OptionsForQuestions(PathBuf),
    /// An answer stands beside two files, but is not about two.
    #[error(
        "two files stand before the answer, but it is not about two bodies, or a body and points; zonobench verify \
         FILE ANSWER checks an answer about one file, and QUESTIONS ANSWERS those of `solve`, and of `mesh` with the \
         question that --question writes"
    )]
    NotAboutTwoFiles,
    /// The name of a result ends as that of a file in another format.
    #[error(
        "{}: the name is that of another format; {format} is written here, so name it .{extension}",
        .file.display()
    )]
    OtherFormat {
        /// The file.
        file: PathBuf,
        /// The format that is written.
        format: &'static str,
        /// The extension of this format.
        extension: &'static str,
    },
    /// Two inputs would be read from standard input, which can be read once.
    #[error("-: two inputs cannot both be read from standard input; give the name of a file for one of them")]
    StandardInputTwice,
}

/// The nearest id of an experiment or a figure as the end of a sentence; of a claim the experiments that it rests on.
fn near_id(id: &str) -> String {
    let Some(claim) = paper_checks::catalog::find(id) else {
        let experiments = experiments::catalog::EXPERIMENTS.iter().map(|experiment| experiment.id);
        return did_you_mean(id, experiments.chain(figures::catalog::FIGURES.iter().map(|figure| figure.id)));
    };
    match claim.experiments() {
        none if none.is_empty() => "; it is a claim that rests on no experiment".to_owned(),
        some => format!("; it is a claim that rests on the experiments {}", some.join(", ")),
    }
}

impl Usage {
    /// The complaint about an option that does not apply.
    pub(super) fn not_applicable(option: &'static str, reason: &'static str) -> Self {
        Self::DoesNotApply { option, reason }
    }
}

/// The formats of results with the extensions that they may have, the usual one first.
const WRITTEN: [(&str, &[&str]); 6] = [
    ("SVG", &["svg"]),
    ("OBJ", &["obj"]),
    ("PLY", &["ply"]),
    ("STL", &["stl"]),
    ("JSON", &["json"]),
    ("CSV", &["csv", "tsv", "txt"]),
];

/// Extensions of formats that are read, or that pictures have elsewhere.
const OTHER_EXTENSIONS: [&str; 12] =
    ["geojson", "npy", "off", "png", "jpg", "jpeg", "gif", "webp", "tif", "tiff", "pdf", "html"];

/// Refuses results whose names end like files of another known format, each given with the format that is written.
pub(super) fn check_names(results: &[(&'static str, Option<&PathBuf>)]) -> Result<(), Usage> {
    for &(format, file) in results {
        let Some(file) = file else { continue };
        let Some(named) = file.extension().map(|named| named.to_string_lossy().to_ascii_lowercase()) else { continue };
        let own = WRITTEN.iter().find(|(written, _)| *written == format).map_or(&[][..], |(_, own)| own);
        let is_known = OTHER_EXTENSIONS.contains(&&*named) || WRITTEN.iter().any(|(_, all)| all.contains(&&*named));
        if is_known && !own.contains(&&*named) {
            let extension = own.first().copied().unwrap_or_default();
            return Err(Usage::OtherFormat { file: file.clone(), format, extension });
        }
    }
    Ok(())
}

/// Tells a person on standard error what is wrong, or what was understood where something else may have been meant.
pub(crate) fn tell(line: &str) {
    // A person who has gone away needs no message.
    let _ = writeln!(io::stderr(), "zonobench: {line}");
}

/// Reads points, and tells in one line which of their numbers doubles do not hold.
pub(super) fn read_telling(source: &PointSource, wanted: Wanted) -> Result<Reading, InputError> {
    let reading = source.read(wanted)?;
    if let Some(losses) = &reading.losses {
        tell(&on_one_line(&format!("{}: {losses}", source.file.display())));
    }
    Ok(reading)
}

/// Tells in one line which numbers of a question doubles do not hold.
pub(super) fn tell_losses(number: u64, line: &Line) {
    let Line::Content(text) = line else { return };
    if let Some(losses) = json_losses(text, number) {
        tell(&on_one_line(&losses));
    }
}

/// Refuses inputs of which more than one is standard input.
pub(super) fn check_inputs(inputs: &[&Path]) -> Result<(), Usage> {
    match inputs.iter().filter(|input| input.as_os_str() == "-").count() {
        0 | 1 => Ok(()),
        _ => Err(Usage::StandardInputTwice),
    }
}

/// The id of the question that a data file stands for.
pub(super) fn question_name(file: &Path) -> String {
    file.file_name().map_or_else(|| "points".to_owned(), |name| name.to_string_lossy().into_owned())
}
