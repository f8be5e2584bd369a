//! The interior-point method for the vertex sets: a primal–dual predictor–corrector method for a second-order cone
//! program.
//!
//! # The program
//! With Q the second-order cone { (x_0, x') : x_0 ≥ |x'| }, p_0 the first point and λ_j the multipliers of the others:
//!
//! - maximise Σ λ_j · (p_j − p_0) such that the slack s_T = (1, w_T), w_T = 2 Σ_{j ∈ T} λ_j, lies in Q for every set T;
//! - its dual: minimise Σ t_T such that Σ_{T ∋ j} 2 g_T = p_j − p_0 for every j and z_T = (t_T, −g_T) lies in Q. The
//!   g_T are the generators of a zonotope of which every p_j is a vertex, and Σ t_T bounds its total length.
//!
//! The duality gap is Σ s_T · z_T. On the central path s_T ∘ z_T = (μ, 0) for every T, where ∘ is the Jordan product of
//! the cone. The head τ_T of a slack may begin above 1, so that the slack of a new set is inside Q even if its
//! constraint is violated; the steps bring τ_T to 1.
//!
//! # A step
//! The Nesterov–Todd scaling W of a set ([`scaling`]) maps its slack and its dual variable to the same point, so that
//! neither is preferred. The predictor is the Newton step for μ = 0. The duality gap after the part of it that stays in
//! the cone determines the μ to aim at, and the corrector adds the second-order term that the predictor neglects.
//! Elimination of slacks and dual variables leaves equations in the λ_j with the Schur complement H = Σ_T a_T
//! a_Tᵀ ⊗ W_T⁻², where a_T is the vector with 2 for the points of T and 0 for the others ([`schur`]). H is factored by
//! Cholesky's method.
//!
//! # Source
//! Y. Nesterov and M. Todd, Self-scaled barriers and interior-point methods for convex programming, 1997, and
//! Primal–dual interior-point methods for self-scaled cones, 1998, for the scaling; S. Mehrotra, On the implementation
//! of a primal–dual interior point method, 1992, for predictor and corrector; the formulas for the second-order cone
//! are those of L. Vandenberghe, The CVXOPT linear and quadratic cone program solvers, 2010. There are two departures.
//! First, the variables begin off the equations τ_T = 1, and satisfy them after the first whole step of the slacks.
//! Second, after each step the residuals of the generators are removed directly ([`residuals`]), since these
//! generators, and not the dual variables of the iteration, become the zonotope.
//!
//! # Exactness
//! The method need not be exact: its multipliers are proved by the vertices of their zonotope, and its generators by
//! containment. But it needs precision. Near the optimum H is ill-conditioned, for needles and clusters of points
//! beyond what doubles resolve. So the method is generic in its [`Scalar`], and can be run again with pairs of doubles.
//!
//! | file | what it holds |
//! |---|---|
//! | [`scaling`] | the Nesterov–Todd scaling |
//! | [`schur`] | the Schur complement |
//! | [`cholesky`] | the Cholesky factor of the Schur complement |
//! | [`newton`] | the equations of a step and their solution |
//! | [`residuals`] | generators without residuals |
//!
//! Vectors of the cone and the scalar stand beside it ([`cone`](super::cone), [`scalar`](super::scalar)), as the sets
//! keep them.

mod cholesky;
mod newton;
mod residuals;
mod scaling;
mod schur;

use super::cone::{ConeVector, jordan};
use super::scalar::{Scalar, values};
use super::vertex_sets::{VertexSets, doubled_sum};
use super::work;
use newton::{Equations, Step};
use scaling::Scaling;

/// A step that would leave the cone ends before its boundary, by this share of the way to the boundary.
const BOUNDARY_SHARE: f64 = 0.02;

/// The residual that the generators may keep, as a share of the least duality gap that a step may aim at.
const RESIDUAL_SHARE: f64 = 0.01;

/// No step aims at a μ below this share of the present one.
const GREATEST_REDUCTION: f64 = 1e-4;

/// The generators and the gap after a step; the multipliers are in the [`VertexSets`].
pub(super) struct Stepped<const D: usize> {
    /// Generators with Σ_{T ∋ j} 2 g_T = p_j − p_0 but for small residuals.
    pub(super) generators: Vec<[f64; D]>,
    /// The magnitude of the largest residual of a point along each axis.
    pub(super) missed: [f64; D],
    /// The average of slack · dual over the sets: the duality gap divided by their number.
    pub(super) mu: f64,
}

impl<R: Scalar, const D: usize> VertexSets<'_, R, D> {
    /// One predictor–corrector step towards the optimum for the present sets, which aims at no μ below `least_mu`.
    /// `None` if rounding has taken a slack or a dual variable out of the cone, or the equations of the step have no
    /// finite solution.
    pub(super) fn step(&mut self, least_mu: f64) -> Option<Stepped<D>> {
        let scalings: Vec<Scaling<R, D>> =
            self.sets.iter().map(|set| Scaling::new(&set.slack, &set.dual)).collect::<Option<_>>()?;
        let matrix = self.schur_complement(&scalings);
        let (points, memberships, changes) = (self.points.len(), self.memberships(), self.changes());
        let [dense, sums] = work::of_step(self.rank, points, self.sets.len(), memberships, changes);
        self.work += R::RELATIVE_COST * dense + R::RELATIVE_COST_OF_SUMS * sums;
        self.work += work::of_vertices(self.rank, points);
        let equations = Equations { sets: self, scalings, factor: matrix.factor()? };
        let residual = self.residual(self.sets.iter().map(|set| set.dual.rest));
        let count = self.sets.len() as f64;
        let mu = self.sets.iter().map(|set| set.slack.dot(&set.dual).value()).sum::<f64>() / count;

        // The predictor aims at μ = 0. The gap after the part of it that stays in the cone says what μ the corrector
        // can aim at.
        let aims: Vec<ConeVector<R, D>> = self.sets.iter().map(|set| ConeVector::zero().minus(&set.dual)).collect();
        let first = equations.solve(&residual, &aims)?;
        let [of_slack, of_dual] = self.reach(&first).map(R::from);
        let after: f64 = self
            .sets
            .iter()
            .zip(&first.variables)
            .map(|(set, (slack, dual))| set.slack.plus(of_slack, slack).dot(&set.dual.plus(of_dual, dual)).value())
            .sum::<f64>()
            / count;
        let ratio = (after / mu).clamp(0.0, 1.0);
        let target_mu = (ratio * ratio * ratio).max(GREATEST_REDUCTION).max((least_mu / mu).min(1.0)) * mu;

        let aims: Vec<ConeVector<R, D>> = equations
            .scalings
            .iter()
            .zip(&first.variables)
            .map(|(scaling, (slack, dual))| {
                let neglected = jordan(&scaling.undo(slack), &scaling.apply(dual));
                let square = jordan(&scaling.both, &scaling.both);
                let mut right = ConeVector::zero().minus(&square).minus(&neglected);
                right.head = right.head + R::from(target_mu);
                scaling.undo(&scaling.divided(&right))
            })
            .collect();
        let second = equations.solve(&residual, &aims)?;
        let parts = self.reach(&second);
        let [of_slack, of_dual] = parts.map(R::from);
        let duals: Vec<ConeVector<R, D>> =
            self.sets.iter().zip(&second.variables).map(|(set, (_, dual))| set.dual.plus(of_dual, dual)).collect();
        let left = self.residual(duals.iter().map(|dual| dual.rest));
        let generators = equations.corrected(&left, &duals)?;
        self.multipliers = self.stepped_multipliers(of_slack, &second.multipliers);
        for ((set, (slack, _)), dual) in self.sets.iter_mut().zip(&second.variables).zip(duals) {
            let head = if parts[0] == 1.0 { R::from(1.0) } else { set.slack.head + of_slack * slack.head };
            set.slack = ConeVector { head, rest: doubled_sum(&set.points, &self.multipliers) };
            set.dual = dual;
        }
        let mu = self.sets.iter().map(|set| set.slack.dot(&set.dual).value()).sum::<f64>() / count;
        self.mu = mu;
        let (generators, missed) = self.without_residual(generators, RESIDUAL_SHARE * least_mu * count);
        Some(Stepped { generators: generators.iter().map(values).collect(), missed, mu })
    }

    /// The part of a step that keeps all slacks inside the cone, and the part that keeps all dual variables inside;
    /// each is at most 1.
    fn reach(&self, step: &Step<R, D>) -> [f64; 2] {
        let mut reach = [f64::INFINITY; 2];
        for (set, (slack, dual)) in self.sets.iter().zip(&step.variables) {
            reach = [reach[0].min(set.slack.reach(slack)), reach[1].min(set.dual.reach(dual))];
        }
        reach.map(|reach| ((1.0 - BOUNDARY_SHARE) * reach).min(1.0))
    }
}
