//! The answer: a zonotope around the points with a proven ratio to the best one.

use thiserror::Error;

use crate::enclosing::answer::Enclosing;
use crate::numeric::non_finite::NonFinite;

/// Why points or a precision are refused.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
#[non_exhaustive]
pub enum MinLengthError {
    /// A coordinate of a point is NaN or infinite.
    #[error(transparent)]
    NonFinite(#[from] NonFinite),
    /// There are no points.
    #[error("there are no points")]
    Empty,
    /// The precision is not between 0 and 1.
    #[error("epsilon is {0}, not between 0 and 1")]
    BadEpsilon(f64),
    /// The net would have more directions than the method takes.
    #[error("a net this fine has {0} directions")]
    TooManyDirections(usize),
    /// So few generators cannot span what the points do.
    #[error("at most {count} generators are asked for, and at least {needed} are needed around these points")]
    TooFewGenerators {
        /// The number of generators that was asked for.
        count: usize,
        /// The number of generators that are needed at least.
        needed: usize,
    },
    /// The length of the answer exceeds the largest double.
    #[error("the length leaves the range of doubles")]
    OutOfRange,
}

/// Whether the ratio that was asked for is proven.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Outcome {
    /// The ratio is at most 1 + ε.
    WithinEpsilon,
    /// The search ended before the ratio fell to 1 + ε. The answer's ratio is proven all the same.
    EndedBefore,
}

/// A zonotope that contains every point exactly, its total length within a stated ratio of the least possible; its
/// value is an upper bound of Σ |g_i|, the half-lengths of its generators.
pub type MinLengthZonotope<const D: usize> = Enclosing<D, LengthProof<D>>;

/// What proves a lower bound of the total length, and whether it is near enough.
#[derive(Debug, Clone, PartialEq)]
pub struct LengthProof<const D: usize> {
    /// What proves the lower bound.
    pub multipliers: Vec<LengthMultiplier<D>>,
    /// Whether the ratio of the value to the lower bound is what was asked for.
    pub outcome: Outcome,
}

/// The multiplier λ_j of a point j in the dual program: if Σ λ_j = 0 and Σ_j |λ_j · v| ≤ 1 for every unit vector v, no
/// zonotope around the points has a total length below Σ λ_j · p_j. The second condition says that no vertex Σ ± λ_j of
/// the zonotope Σ [−1, 1] λ_j is farther than 1 from the origin.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LengthMultiplier<const D: usize> {
    /// The point, from 0.
    pub point: usize,
    /// The vector λ_j, feasible up to rounding. A proof needs no more: multipliers whose farthest vertex is at distance
    /// ρ prove the bound Σ λ_j · p_j / ρ.
    pub vector: [f64; D],
}
