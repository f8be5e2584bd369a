//! The findings of experiments, in sentences that are made from the records of a run: each number and each word of
//! comparison comes from the numbers, so that a sentence cannot say what the records do not.
//!
//! | file | its sentences |
//! |---|---|
//! | [`words`] | the forms that sentences share: extremes, courses over the sizes, ratios of two methods |
//! | `plane` | sections 4 and 4.1 |
//! | `lengths` | sections 4.2 and 4.3, and the questions of section 7 |
//! | `collision` | section 5.1, and the explicit faces |
//! | `repeated` | section 5.2 |
//! | `motion` | section 6 |
//! | [`meshes`] | hierarchies over meshes, and zonotopes of little volume: section 7 |

mod collision;
mod finding;
mod lengths;
pub mod meshes;
mod motion;
mod plane;
mod repeated;
pub mod words;

pub use self::finding::{Findings, Sentence};
use crate::measured::Measured;

/// All sentences.
static FINDINGS: &[&[Findings]] =
    &[plane::FINDINGS, lengths::FINDINGS, collision::FINDINGS, repeated::FINDINGS, motion::FINDINGS, meshes::FINDINGS];

/// The sentences about operation counts and values of an experiment.
pub fn counted(experiment: &str, found: &Measured<'_>) -> Vec<String> {
    of(experiment).flat_map(|findings| findings.counted).filter_map(|sentence| sentence(found)).collect()
}

/// The sentences about the times of an experiment.
pub fn timed(experiment: &str, found: &Measured<'_>) -> Vec<String> {
    of(experiment).flat_map(|findings| findings.timed).filter_map(|sentence| sentence(found)).collect()
}

/// The number of sentences about the counts of an experiment that a run has no numbers for. After a whole run it is
/// none, or a sentence asks for what is not recorded.
pub fn unsaid(experiment: &str, found: &Measured<'_>) -> usize {
    of(experiment).flat_map(|findings| findings.counted).filter(|sentence| sentence(found).is_none()).count()
}

fn of(experiment: &str) -> impl Iterator<Item = &'static Findings> {
    FINDINGS.iter().copied().flatten().filter(move |findings| findings.experiment == experiment)
}

#[cfg(test)]
mod tests;
