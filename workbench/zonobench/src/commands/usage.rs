//! Command lines that parse but make no sense.

use std::path::{Path, PathBuf};

use thiserror::Error;

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
    #[error("'{0}': there is no experiment or figure of this name; `zonobench list` names those that there are")]
    UnknownId(String),
    /// There is no command of the name.
    #[error("'{0}': there is no command of this name; `zonobench help` names those that there are")]
    UnknownCommand(String),
    /// Options tell what was asked of a data file, but there is a file of questions.
    #[error(
        "{}: read as questions, which tell themselves what is asked; other options are for a data file, whose format \
         --format tells where the name does not",
        .0.display()
    )]
    OptionsForQuestions(PathBuf),
    /// Two inputs would be read from standard input, which can be read once.
    #[error("-: two inputs cannot both be read from standard input; give the name of a file for one of them")]
    StandardInputTwice,
}

impl Usage {
    /// The complaint about an option that does not apply.
    pub(super) fn not_applicable(option: &'static str, reason: &'static str) -> Self {
        Self::DoesNotApply { option, reason }
    }
}

/// Refuses inputs of which more than one is standard input.
pub(super) fn check_inputs(inputs: &[&Path]) -> Result<(), Usage> {
    match inputs.iter().filter(|input| input.as_os_str() == "-").count() {
        0 | 1 => Ok(()),
        _ => Err(Usage::StandardInputTwice),
    }
}
