//! The methods for the distance by name.

use std::ops::RangeInclusive;

use super::{brute_force, by_support_simplex};
use crate::numeric::Rational;
use crate::tables::methods;
use crate::tally::Tally;
use crate::zonotope::query::Query;

methods! {
    /// A method that finds how far a displacement is from a zonotope.
    pub enum Method;
    /// The cost of a question with n generators in R^D.
    fn cost;

    /// [`by_support_simplex`], the default.
    BySupportSimplex => "by_support_simplex", "Simplices of extreme vertices, then the exact face",
        "O(n) a step, few steps";
    /// [`brute_force`].
    BruteForce => "brute_force", "Every parallelotope of the body in rationals", "O(2^n n^D) in rationals";
}

impl Method {
    /// The dimensions that the method works in.
    pub fn dimensions(self) -> RangeInclusive<usize> {
        match self {
            Self::BySupportSimplex => 1..=3,
            Self::BruteForce => 1..=usize::MAX,
        }
    }

    /// The square of the distance, exactly, in space.
    pub fn exact_squared_distance(self, query: &Query<'_, 3>, tally: &mut dyn Tally) -> Rational {
        match self {
            Self::BySupportSimplex => by_support_simplex::proximity(query, tally).exact_squared_distance(),
            Self::BruteForce => brute_force::nearest_point(query).squared_distance,
        }
    }
}
