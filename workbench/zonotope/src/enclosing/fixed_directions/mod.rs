//! Problem: the smallest zonotope along given directions around a set of points.
//!
//! Minimise Σ w_i c_i over centres p and coefficients c_i ≥ 0 such that { p + Σ δ_i c_i v_i : |δ_i| ≤ 1 } contains every point. With unit
//! vectors and unit weights that is the total length. A linear program; it has a solution just when no difference of two points leaves the
//! span of the directions.
//!
//! | method | time | notes |
//! |---|---|---|
//! | [`brute_force`] | rational pivots over C(k, d − 1) normals | the truth |
//! | [`papers_program`] | O(n k^{d−1}), then the engine on k n' + k + d unknowns | Section 4.2 as printed |
//! | [`support_form`] | O(n k^{d−1}), then the engine on k + d unknowns, 2 C(k, d − 1) rows | all normals at once |
//! | [`by_row_generation`] | a few passes over the points, pivots of O((k + d)²) | normals as they are needed; the default |
//!
//! n points, k directions, d dimensions, n' extreme points; the two in the middle need an engine for
//! [linear programs](crate::linear_program), whose answer is only where they begin to prove their own. Every answer but the truth's contains the points exactly and proves its lower bound;
//! [`verify`] checks both on its own.

#[cfg(feature = "linear-programming")]
mod all_normals;
mod answer;
pub mod brute_force;
pub mod by_row_generation;
mod contain;
mod farthest;
mod lower_bound;
#[cfg(feature = "linear-programming")]
pub mod papers_program;
mod problem;
pub mod rational;
mod scaled;
mod solve;
mod span;
#[cfg(feature = "linear-programming")]
pub mod support_form;
pub mod verify;

pub use answer::{DirectedZonotope, Effort, Enclosure, ExactOptimum, Multiplier, OffSpan};
pub(crate) use by_row_generation::Generation;
pub(crate) use lower_bound::balanced;
pub(crate) use problem::first_non_finite;

pub use by_row_generation::{min_length_along, min_length_along_counted};
pub use problem::{FixedDirections, FixedDirectionsError};

#[cfg(test)]
mod tests;
