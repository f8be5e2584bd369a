//! The sentences about one experiment, as values.

use crate::measured::Measured;

/// A sentence about what was measured; none where a run has no such records.
pub type Sentence = fn(&Measured<'_>) -> Option<String>;

/// The sentences about one experiment.
#[derive(Clone, Copy, Debug)]
pub struct Findings {
    /// The experiment's id.
    pub experiment: &'static str,
    /// Sentences about operation counts and values, which are the same on every machine.
    pub counted: &'static [Sentence],
    /// Sentences about times.
    pub timed: &'static [Sentence],
}
