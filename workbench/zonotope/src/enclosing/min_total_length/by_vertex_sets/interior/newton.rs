//! The linear equations of a Newton step and their solution.
//!
//! A step (Δλ, Δs, Δz) satisfies three equations: it makes the residuals p_j − p_0 − Σ_{T ∋ j} 2 g_T zero, it brings
//! every τ_T to 1, and Δz + W⁻² Δs is a given vector, the aim. The last equation is the central path's, linearised and
//! multiplied by W⁻¹: for the predictor the aim is −z, for the corrector it also holds μ and the second-order term. Δs
//! and Δz follow from Δλ, which solves H Δλ = right side.

use super::cholesky::Factor;
use super::scaling::Scaling;
use crate::enclosing::min_total_length::by_vertex_sets::cone::ConeVector;
use crate::enclosing::min_total_length::by_vertex_sets::scalar::{Scalar, plus, zero};
use crate::enclosing::min_total_length::by_vertex_sets::vertex_sets::{VertexSets, doubled_sum_after_first};

/// The equations of a step: the sets, their scalings, and the factored Schur complement.
pub(super) struct Equations<'a, R, const D: usize> {
    pub(super) sets: &'a VertexSets<'a, R, D>,
    pub(super) scalings: Vec<Scaling<R, D>>,
    pub(super) factor: Factor<R>,
}

/// A Newton step: the change of the multiplier of each point after the first, and of the variables of each set.
pub(super) struct Step<R, const D: usize> {
    pub(super) multipliers: Vec<[R; D]>,
    /// The change of the slack and of the dual variable of each set.
    pub(super) variables: Vec<(ConeVector<R, D>, ConeVector<R, D>)>,
}

impl<R: Scalar, const D: usize> Equations<'_, R, D> {
    /// The step that makes a residual zero and brings every τ_T to 1, with Δz = aim − W⁻² Δs for each set. `None` if it
    /// is not finite.
    pub(super) fn solve(&self, residual: &[[R; D]], aims: &[ConeVector<R, D>]) -> Option<Step<R, D>> {
        let aims: Vec<ConeVector<R, D>> = self
            .sets
            .sets
            .iter()
            .zip(aims)
            .zip(&self.scalings)
            .map(|((set, aim), scaling)| {
                let stretch = ConeVector { head: R::from(1.0) - set.slack.head, rest: zero() };
                aim.minus(&scaling.undo_twice(&stretch))
            })
            .collect();
        let mut right = residual.to_vec();
        self.add_to_members(&mut right, aims.iter().map(|aim| aim.rest));
        let multipliers = self.solve_schur(&right)?;
        let variables = self.sets.sets.iter().zip(&aims).zip(&self.scalings).map(|((set, aim), scaling)| {
            let rest = doubled_sum_after_first(&set.points, &multipliers);
            let slack = ConeVector { head: R::from(1.0) - set.slack.head, rest };
            (slack, aim.minus(&scaling.undo_twice(&headless(rest))))
        });
        let variables = variables.collect();
        Some(Step { multipliers, variables })
    }

    /// H⁻¹ times a right side, refined once by its residual; `None` if it is not finite.
    fn solve_schur(&self, right: &[[R; D]]) -> Option<Vec<[R; D]>> {
        let rank = self.sets.rank;
        let solved = |right: &[[R; D]]| -> Vec<[R; D]> {
            let flat: Vec<R> = right.iter().flat_map(|r| r[..rank].to_vec()).collect();
            let x = self.factor.solve(&flat);
            x.chunks_exact(rank).map(|x| std::array::from_fn(|c| x.get(c).copied().unwrap_or(R::from(0.0)))).collect()
        };
        let first = solved(right);
        let mut left = right.to_vec();
        let answered = self.sets.sets.iter().zip(&self.scalings).map(|(set, scaling)| {
            let rest = doubled_sum_after_first(&set.points, &first);
            scaling.undo_twice(&headless(rest)).rest.map(|c| -c)
        });
        self.add_to_members(&mut left, answered);
        let second = solved(&left);
        let sum: Vec<[R; D]> = first.iter().zip(&second).map(|(a, b)| plus(a, R::from(1.0), b)).collect();
        sum.iter().flatten().all(|c| c.value().is_finite()).then_some(sum)
    }

    /// Adds twice the vector of each set T to the sums of the points of T.
    fn add_to_members(&self, sums: &mut [[R; D]], vectors: impl Iterator<Item = [R; D]>) {
        for (set, vector) in self.sets.sets.iter().zip(vectors) {
            for j in set.points.members() {
                sums[j - 1] = plus(&sums[j - 1], R::from(2.0), &vector);
            }
        }
    }

    /// The generators of dual variables, changed so that a residual becomes zero; of all such changes Δz this has the
    /// least Σ |W Δz|². `None` if it is not finite.
    pub(super) fn corrected(&self, residual: &[[R; D]], duals: &[ConeVector<R, D>]) -> Option<Vec<[R; D]>> {
        let multipliers = self.solve_schur(residual)?;
        let sets = self.sets.sets.iter().zip(&self.scalings).zip(duals);
        let generators = sets.map(|((set, scaling), dual)| {
            let rest = doubled_sum_after_first(&set.points, &multipliers);
            plus(&scaling.undo_twice(&headless(rest)).rest, R::from(-1.0), &dual.rest)
        });
        Some(generators.collect())
    }
}

/// The vector with a head of zero.
fn headless<R: Scalar, const D: usize>(rest: [R; D]) -> ConeVector<R, D> {
    ConeVector { head: R::from(0.0), rest }
}
