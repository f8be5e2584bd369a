//! The shape of an answer to every enclosing problem: a body around the points, and how far it may be from the best
//! one.

use crate::zonotope::Zonotope;

/// A zonotope around points with a proven distance from the smallest one, in the measure that the problem minimises.
#[derive(Debug, Clone, PartialEq)]
pub struct Enclosing<const D: usize, Proof> {
    /// The zonotope, which contains every point exactly.
    pub body: Zonotope<D>,
    /// An upper bound of the measure that is minimised: the body's area or total length, or the weighted sum of the
    /// coefficients along given directions. Infinite where an area leaves the range of doubles.
    pub value: f64,
    /// A number that the measure is not below for any zonotope around the points that the problem admits.
    pub lower_bound: f64,
    /// What proves the lower bound to a reader who does not trust the method.
    pub proof: Proof,
    /// The work that the method did.
    pub effort: Effort,
}

/// The work that a method did for an answer; zero or empty where a method has nothing of the kind.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Effort {
    /// The size of the last program: lines ℓ_t for the least area, normals or equations and bounds along given
    /// directions, the directions or sets of vertices that were tried for the least total length.
    pub rows: usize,
    /// How often a program was solved.
    pub rounds: usize,
    /// Passes over all points.
    pub passes: usize,
    /// Whether rational arithmetic had to find the optimum.
    pub exact: bool,
    /// The value of the best zonotope and the lower bound after each round.
    pub progress: Vec<[f64; 2]>,
}

impl<const D: usize, Proof> Enclosing<D, Proof> {
    /// How far the value may exceed the least possible one, relative to the lower bound; zero when both are equal.
    pub fn relative_gap(&self) -> f64 {
        relative_gap(self.value, self.lower_bound)
    }

    /// The value divided by the lower bound, rounded up; 1 when the value is zero.
    pub fn ratio(&self) -> f64 {
        if self.value == 0.0 { 1.0 } else { (self.value / self.lower_bound).next_up() }
    }
}

/// How far a value is above a lower bound, relative to the bound; zero when they are equal.
pub(super) fn relative_gap(value: f64, lower_bound: f64) -> f64 {
    if value == lower_bound { 0.0 } else { (value - lower_bound) / lower_bound }
}
