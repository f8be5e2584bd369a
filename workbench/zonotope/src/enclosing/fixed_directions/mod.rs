//! Problem: the smallest zonotope along given directions around a set of points.
//!
//! Minimise Σ w_i c_i over centres p and coefficients c_i ≥ 0 such that { p + Σ δ_i c_i v_i : |δ_i| ≤ 1 } contains every point. With
//! unit vectors and unit weights that is the total length. It is a linear program, and feasible just when no difference of two points
//! leaves the span of the directions.
//!
//! | method | time | notes |
//! |---|---|---|
//! | [`brute_force`] | criss-cross method on 2 C(k, d − 1) normals in rationals | the truth |
//! | [`rational`] | simplex method on C(k, d − 1) normals in rationals | the optimum in rationals; the fallback of the three below |
//! | [`papers_program`] | O(n k^{d−1}), then the engine on k n' + k + d unknowns | Section 4.2 as printed |
//! | [`support_form`] | O(n k^{d−1}), then the engine on k + d unknowns, 2 C(k, d − 1) rows | all normals at once |
//! | [`by_row_generation`] | a few passes over the points, pivots of O((k + d)²) | normals as they are needed; the default |
//!
//! n points, k directions, d dimensions, n' extreme points. The last three are those of [`Method`]: their answers contain the points
//! exactly and prove their lower bounds, which [`verify`] checks. The two in the middle need an engine for
//! linear programs, whose answer is only where they begin.
//!
//! # The way from directions to a zonotope
//! 1. `solve`: the steps that the methods share, in order; read it first.
//! 2. `span`, `scaled`: coordinates of the span, of ordinary size, and one direction for each line.
//! 3. `by_row_generation/generation` and `normal_simplex`: the linear program over the normals found so far, in doubles.
//! 4. [`zonotope::ray_exit`](crate::zonotope): the facet that a point outside sees, whose normal joins the program.
//! 5. `lower_bound`: multipliers that add up to zero exactly.
//! 6. `contain`: every point inside, exactly.
//!
//! That is all for ordinary input. Three pieces serve the rest, each behind one function: `contain/flat_center` (directions that do not
//! span the space), `contain/thickened` (flat and needle-shaped bodies) and `rational/refine` (small problems whose bounds do not meet).

#[cfg(feature = "linear-programming")]
mod all_normals;
mod answer;
pub mod brute_force;
pub mod by_row_generation;
mod contain;
mod farthest;
mod lower_bound;
mod method;
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

pub use by_row_generation::{min_length_along, min_length_along_counted};
pub use method::Method;
pub use problem::{FixedDirections, FixedDirectionsError};

#[cfg(test)]
mod tests;
