//! The methods for the distance by name.

use std::ops::RangeInclusive;

use super::{brute_force, by_support_simplex};
use crate::numeric::Rational;
use crate::tally::Tally;
use crate::zonotope::query::Query;

/// A method that finds how far a displacement is from a zonotope.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Default)]
#[non_exhaustive]
pub enum Method {
    /// [`by_support_simplex`], the default.
    #[default]
    BySupportSimplex,
    /// [`brute_force`].
    BruteForce,
}

impl Method {
    /// Every method, better ones first.
    pub const ALL: [Self; 2] = [Self::BySupportSimplex, Self::BruteForce];

    /// The name of the method's file.
    pub const fn id(self) -> &'static str {
        match self {
            Self::BySupportSimplex => "by_support_simplex",
            Self::BruteForce => "brute_force",
        }
    }

    /// The method with a name.
    pub fn from_id(id: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|method| method.id() == id)
    }

    /// The name for people.
    pub fn title(self) -> &'static str {
        match self {
            Self::BySupportSimplex => "Simplices of extreme vertices, then the exact face",
            Self::BruteForce => "Every parallelotope of the body in rationals",
        }
    }

    /// The cost of a question with n generators in R^D.
    pub fn cost(self) -> &'static str {
        match self {
            Self::BySupportSimplex => "O(n) a step, few steps",
            Self::BruteForce => "O(2^n n^D) in rationals",
        }
    }

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
            Self::BySupportSimplex => by_support_simplex::proximity_counted(query, tally).exact_squared_distance(),
            Self::BruteForce => brute_force::nearest_point(query).squared_distance,
        }
    }
}
