//! The verdict of a check on an answer.

use std::fmt::{self, Display};

/// The verdict of a check on one answer. A right answer comes with what was proved of it.
#[derive(Debug, Clone, PartialEq)]
pub enum Verdict<P = String> {
    /// Every statement of the answer was proved.
    Right(P),
    /// A statement is false, or its certificate does not prove it; the text names the place and the reason.
    Wrong(String),
    /// Nothing was found wrong, but not everything was proved; the text says what is open and why.
    Unchecked(String),
}

impl<P> Verdict<P> {
    /// Whether everything was proved.
    pub fn is_right(&self) -> bool {
        matches!(self, Self::Right(_))
    }

    /// Whether a statement is false or unproved by its own certificate.
    pub fn is_wrong(&self) -> bool {
        matches!(self, Self::Wrong(_))
    }

    /// The proof, or the text of the verdict.
    ///
    /// # Errors
    /// The text of a verdict that is not [`Right`](Self::Right).
    pub fn proof(self) -> Result<P, String> {
        match self {
            Self::Right(proof) => Ok(proof),
            Self::Wrong(text) | Self::Unchecked(text) => Err(text),
        }
    }
}

impl<P: Display> Verdict<P> {
    /// The verdict with the proof in words.
    pub fn in_words(self) -> Verdict {
        match self {
            Self::Right(proof) => Verdict::Right(proof.to_string()),
            Self::Wrong(reason) => Verdict::Wrong(reason),
            Self::Unchecked(reason) => Verdict::Unchecked(reason),
        }
    }
}

/// Why a check stops before its end.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Stop {
    Wrong(String),
    Unchecked(String),
}

impl From<String> for Stop {
    fn from(reason: String) -> Self {
        Self::Wrong(reason)
    }
}

impl From<&str> for Stop {
    fn from(reason: &str) -> Self {
        Self::Wrong(reason.to_owned())
    }
}

impl<P> From<Result<P, Stop>> for Verdict<P> {
    fn from(checked: Result<P, Stop>) -> Self {
        match checked {
            Ok(proof) => Self::Right(proof),
            Err(Stop::Wrong(reason)) => Self::Wrong(reason),
            Err(Stop::Unchecked(reason)) => Self::Unchecked(reason),
        }
    }
}

impl<P> From<Result<P, String>> for Verdict<P> {
    fn from(checked: Result<P, String>) -> Self {
        checked.map_err(Stop::Wrong).into()
    }
}

/// A proof that has nothing to say but a sentence.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Proved(pub(crate) &'static str);

impl Display for Proved {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.0)
    }
}
