//! Generators without residuals: Σ_{T ∋ j} 2 g_T = p_j − p_0 up to rounding.
//!
//! To first order it does not matter which generators make up for the residuals r_j: as every generator g_T points
//! along its w_T, the change adds Σ λ_j · r_j to their total length in any case. So the generators are changed in
//! proportion to their lengths, which leaves short ones short.

use super::cholesky::Cholesky;
use crate::enclosing::min_total_length::by_vertex_sets::scalar::{Scalar, plus, values, zero};
use crate::enclosing::min_total_length::by_vertex_sets::vertex_sets::{VertexSets, doubled_sum_after_first};
use crate::numeric::linear::dot;

/// The residuals are removed at most this many times in sequence.
const CORRECTION_LIMIT: usize = 4;

/// A generator's weight in a correction is its length, but no less than this share of the longest one's.
const LEAST_WEIGHT: f64 = 1e-6;

impl<R: Scalar, const D: usize> VertexSets<'_, R, D> {
    /// The residual p_j − p_0 − Σ_{T ∋ j} 2 g_T of each point after the first, for the negated generators −g_T.
    pub(super) fn residual(&self, negated: impl Iterator<Item = [R; D]>) -> Vec<[R; D]> {
        let mut left = self.points[1..].to_vec();
        for (set, vector) in self.sets.iter().zip(negated) {
            for j in set.points.members() {
                left[j - 1] = plus(&left[j - 1], R::from(2.0), &vector);
            }
        }
        left
    }

    /// The generators, changed in proportion to their lengths if their residuals exceed a tolerance, and the magnitude
    /// of the largest residual that is left along each axis.
    pub(super) fn without_residual(&self, mut generators: Vec<[R; D]>, tolerance: f64) -> (Vec<[R; D]>, [f64; D]) {
        let count = self.points.len() - 1;
        let mut factor = None;
        let mut best: Option<(f64, [f64; D], Vec<[R; D]>)> = None;
        for _ in 0..=CORRECTION_LIMIT {
            let left = self.residual(generators.iter().map(|g| g.map(|c| -c)));
            let missed = left
                .iter()
                .map(values)
                .fold([0.0; D], |most: [f64; D], v| std::array::from_fn(|c| most[c].max(v[c].abs())));
            let size: f64 = missed.iter().sum();
            if best.as_ref().is_some_and(|(least, ..)| size >= *least) {
                break;
            }
            best = Some((size, missed, generators.clone()));
            if size <= tolerance {
                break;
            }
            let weights = || {
                let lengths = || generators.iter().map(|g| dot(g, g).sqrt().value());
                let longest = lengths().fold(0.0, f64::max);
                lengths().map(|length| length.max(LEAST_WEIGHT * longest)).collect::<Vec<f64>>()
            };
            if factor.is_none() {
                let weights = weights();
                factor = self.weighted_gram(&weights).factor().map(|factor| (factor, weights));
            }
            let Some((factor, weights)) = &factor else { break };
            let mut solution = vec![zero(); count];
            for axis in 0..self.rank {
                let right: Vec<R> = left.iter().map(|v| v[axis]).collect();
                for (solution, x) in solution.iter_mut().zip(factor.solve(&right)) {
                    solution[axis] = x;
                }
            }
            for ((set, generator), weight) in self.sets.iter().zip(&mut generators).zip(weights) {
                *generator = plus(generator, R::from(*weight), &doubled_sum_after_first(&set.points, &solution));
            }
        }
        let (_, missed, generators) = best.expect("there is a first one");
        (generators, missed)
    }

    /// The matrix Σ weight_T a_T a_Tᵀ, where a_T is the vector with 2 for the points of T and 0 for the others.
    fn weighted_gram(&self, weights: &[f64]) -> Cholesky<R> {
        let count = self.points.len() - 1;
        let mut sums = vec![R::from(0.0); count * count];
        for (set, weight) in self.sets.iter().zip(weights) {
            for j in set.points.members() {
                for k in set.points.members().take_while(|&k| k <= j) {
                    let entry = &mut sums[(j - 1) * count + k - 1];
                    *entry = *entry + R::from(4.0 * weight);
                }
            }
        }
        let mut matrix = Cholesky::zero(count);
        for (j, row) in sums.chunks_exact(count.max(1)).enumerate() {
            row[..=j].iter().enumerate().for_each(|(k, &entry)| matrix.set(j, k, entry));
        }
        matrix
    }
}
