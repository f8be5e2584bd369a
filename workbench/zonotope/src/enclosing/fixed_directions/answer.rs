//! The answer: a zonotope along the directions with what proves it small, or the proof that there is none.

use super::problem::FixedDirections;
use crate::numeric::Rational;
use crate::numeric::dyadic::Dyadic;
use crate::numeric::outward::Loss;
use crate::zonotope::Zonotope;

/// The outcome: a zonotope, or the proof that there is none.
#[derive(Debug, Clone, PartialEq)]
pub enum Enclosure<const D: usize> {
    /// A zonotope that contains every point exactly.
    Optimal(DirectedZonotope<D>),
    /// No zonotope along the directions contains the points.
    Infeasible(OffSpan<D>),
}

/// The zonotope { p + Σ δ_i c_i v_i : |δ_i| ≤ 1 } around the points, the products c_i v_i taken exactly.
#[derive(Debug, Clone, PartialEq)]
pub struct DirectedZonotope<const D: usize> {
    /// The centre p.
    pub center: [f64; D],
    /// The coefficients c_i ≥ 0, one for each direction of the problem.
    pub coefficients: Vec<f64>,
    /// Σ w_i c_i, rounded up.
    pub value: f64,
    /// A lower bound of Σ w_i c_i for all zonotopes along the directions that contain the points.
    pub lower_bound: f64,
    /// The multipliers that prove the lower bound.
    pub multipliers: Vec<Multiplier<D>>,
    /// The effort that the method took.
    pub effort: Effort,
}

/// The multiplier λ_j of a point j in the dual program. Multipliers with Σ λ_j = 0 and Σ_j |λ_j · v_i| ≤ w_i for each
/// direction prove Σ w_i c_i ≥ Σ λ_j · p_j.
///
/// For if p_j = p + Σ b_ij v_i with |b_ij| ≤ c_i, then Σ λ_j · p_j = Σ_ij b_ij λ_j · v_i ≤ Σ_i c_i Σ_j |λ_j · v_i|.
#[derive(Debug, Clone, PartialEq)]
pub struct Multiplier<const D: usize> {
    /// The point, from 0.
    pub point: usize,
    /// The vector, exactly.
    pub vector: [Rational; D],
}

/// The effort that a method took.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct Effort {
    /// Rows of the last linear program: normals, or equations and bounds.
    pub rows: usize,
    /// The number of times that a linear program was solved.
    pub rounds: usize,
    /// The number of passes over all points.
    pub passes: usize,
    /// Whether rational arithmetic had to find the optimum.
    pub exact: bool,
}

/// The proof that two points differ by a vector outside the span of the directions.
#[derive(Debug, Clone, PartialEq)]
pub struct OffSpan<const D: usize> {
    /// The two points, from 0.
    pub points: [usize; 2],
    /// A vector orthogonal to every direction, but not to the difference of the two points.
    pub functional: [Rational; D],
}

/// An optimum in rationals.
#[derive(Debug, Clone, PartialEq)]
pub struct ExactOptimum<const D: usize> {
    /// The least Σ w_i c_i.
    pub value: Rational,
    /// The centre p.
    pub center: [Rational; D],
    /// The coefficients c_i, none negative.
    pub coefficients: Vec<Rational>,
    /// The multipliers that prove that no value is smaller: points j with vectors λ_j such that Σ λ_j = 0,
    /// Σ_j |λ_j · v_i| ≤ w_i for every direction, and Σ λ_j · p_j is the value.
    pub multipliers: Vec<(usize, [Rational; D])>,
}

/// Bounds whose relative gap is at most this are tight: rounding a sum of coefficients alone may cost as much.
pub(super) const TIGHT_RELATIVE_GAP: f64 = 1e-13;

impl<const D: usize> Enclosure<D> {
    /// The zonotope, if there is one.
    pub fn optimal(&self) -> Option<&DirectedZonotope<D>> {
        match self {
            Self::Optimal(zonotope) => Some(zonotope),
            Self::Infeasible(_) => None,
        }
    }
}

impl<const D: usize> DirectedZonotope<D> {
    /// Whether the bounds differ by no more than rounding.
    pub(super) fn is_tight(&self) -> bool {
        self.value - self.lower_bound <= TIGHT_RELATIVE_GAP * self.lower_bound
    }

    /// How far the value may exceed the least possible one, relative to the lower bound; zero when both are zero.
    pub fn relative_gap(&self) -> f64 {
        if self.value == self.lower_bound { 0.0 } else { (self.value - self.lower_bound) / self.lower_bound }
    }

    /// A zonotope with generators in doubles that contains this one: the products c_i v_i rounded, and up to D
    /// generators along the axes that make up for the rounding. O(k D).
    ///
    /// `None` where a product leaves the range of doubles.
    pub fn zonotope(&self, problem: &FixedDirections<'_, D>) -> Option<Zonotope<D>> {
        let mut generators = Vec::new();
        let mut loss = Loss::none();
        for (v, &c) in problem.directions().iter().zip(&self.coefficients) {
            let exact = v.map(|v| &Dyadic::from_f64(v) * &Dyadic::from_f64(c));
            let rounded = loss.round(&exact);
            if rounded.iter().any(|r| !r.is_finite()) {
                return None;
            }
            if rounded.iter().any(|r| *r != 0.0) {
                generators.push(rounded);
            }
        }
        generators.extend(loss.generators());
        Zonotope::new(self.center, generators).ok()
    }
}
