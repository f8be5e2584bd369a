//! Zonotopes of least total length.

use ::verifier::{MinLengthAnswer, MinLengthProof, Verdict};

use crate::enclosing::min_total_length::{MinLengthZonotope, Outcome};

/// Checks that a zonotope contains the points and is within 1 + ε of the shortest.
pub fn check_min_length_all<const D: usize>(
    points: &[[f64; D]],
    epsilon: f64,
    answer: &MinLengthZonotope<D>,
) -> Verdict<MinLengthProof> {
    ::verifier::check_min_length_all(&rows(points), epsilon, &written(answer))
}

/// Checks the same; a ratio above 1 + ε may be right if the answer says that it is.
pub fn check_min_length_all_at_any_ratio<const D: usize>(
    points: &[[f64; D]],
    epsilon: f64,
    answer: &MinLengthZonotope<D>,
) -> Verdict<MinLengthProof> {
    ::verifier::check_min_length_all_at_any_ratio(&rows(points), epsilon, &written(answer))
}

fn written<const D: usize>(answer: &MinLengthZonotope<D>) -> MinLengthAnswer {
    MinLengthAnswer {
        length: answer.value,
        center: answer.body.center().to_vec(),
        generators: rows(answer.body.generators()),
        lower_bound: answer.lower_bound,
        ratio: answer.ratio(),
        within_epsilon: Some(answer.proof.outcome == Outcome::WithinEpsilon),
        forces: answer.proof.multipliers.iter().map(|force| (force.point, force.vector.to_vec())).collect(),
    }
}

fn rows<const D: usize>(vectors: &[[f64; D]]) -> Vec<Vec<f64>> {
    vectors.iter().map(|vector| vector.to_vec()).collect()
}
