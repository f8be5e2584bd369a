//! The answer: a zonotope along the directions with what proves it small, or the proof that there is none.

use super::problem::{FixedDirections, FixedDirectionsError};
use crate::enclosing::answer::{Effort, Enclosing, relative_gap};
use crate::numeric::Rational;
use crate::numeric::dyadic::Dyadic;
use crate::numeric::outward::Loss;
use crate::zonotope::Zonotope;

/// The outcome: a zonotope, or the proof that there is none.
#[derive(Debug, Clone, PartialEq)]
pub enum Enclosure<const D: usize, Found = DirectedZonotope<D>> {
    /// A zonotope that contains every point exactly.
    Optimal(Found),
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

/// What proves a lower bound along given directions, and how far each direction is taken.
#[derive(Debug, Clone, PartialEq)]
pub struct DirectionsProof<const D: usize> {
    /// The coefficients c_i ≥ 0, one for each direction, whose weighted sum is the value.
    pub coefficients: Vec<f64>,
    /// What proves the lower bound.
    pub multipliers: Vec<Multiplier<D>>,
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

/// A value that exceeds its lower bound by at most this part of it is called the least.
///
/// The centre is a point of doubles, so its rounding alone costs as many digits of the value as the points are farther
/// from the origin than from each other: there a zonotope that contains them is near the least one, and not it.
pub const OPTIMAL_GAP: f64 = 1e-11;

impl<const D: usize, Found> Enclosure<D, Found> {
    /// The zonotope, if there is one.
    pub fn optimal(&self) -> Option<&Found> {
        match self {
            Self::Optimal(zonotope) => Some(zonotope),
            Self::Infeasible(_) => None,
        }
    }
}

impl<const D: usize> Enclosure<D> {
    /// The same outcome with generators in doubles: those of [`DirectedZonotope::zonotope`], whose body contains the
    /// zonotope of the exact products. The value stays that of the coefficients. O(k D).
    ///
    /// # Errors
    /// [`FixedDirectionsError::OutOfRange`] if a generator leaves the range of doubles.
    pub fn in_doubles(
        self,
        problem: &FixedDirections<'_, D>,
    ) -> Result<Enclosure<D, Enclosing<D, DirectionsProof<D>>>, FixedDirectionsError> {
        Ok(match self {
            Self::Infeasible(proof) => Enclosure::Infeasible(proof),
            Self::Optimal(found) => {
                let body = found.zonotope(problem).ok_or(FixedDirectionsError::OutOfRange)?;
                let DirectedZonotope { coefficients, value, lower_bound, multipliers, effort, .. } = found;
                let proof = DirectionsProof { coefficients, multipliers };
                Enclosure::Optimal(Enclosing { body, value, lower_bound, proof, effort })
            }
        })
    }
}

impl<const D: usize> DirectedZonotope<D> {
    /// Whether the bounds differ by no more than rounding.
    pub(super) fn is_tight(&self) -> bool {
        self.value - self.lower_bound <= TIGHT_RELATIVE_GAP * self.lower_bound
    }

    /// Whether the value is the least one but for [`OPTIMAL_GAP`].
    pub fn is_optimal(&self) -> bool {
        self.value - self.lower_bound <= OPTIMAL_GAP * self.lower_bound
    }

    /// How far the value may exceed the least possible one, relative to the lower bound; zero when both are zero.
    pub fn relative_gap(&self) -> f64 {
        relative_gap(self.value, self.lower_bound)
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
