//! Queries about a body that stays, for the experiments on structures that are built once.

use crate::question::{PLACEMENTS, Question};
use crate::seed;

/// A question for each placement that a body of some generators around the origin admits, but for touching: a point on
/// the boundary is a difference of two doubles, and the centre of a body that stays is fixed.
pub(super) fn questions(generators: &[[f64; 3]], instance_seed: u64) -> impl Iterator<Item = Question> {
    let placements = PLACEMENTS.into_iter().filter(|placement| !placement.is_touching());
    placements.filter_map(move |placement| {
        Question::about(generators.to_vec(), placement, seed::seed_of(instance_seed, "repeated queries"))
    })
}
