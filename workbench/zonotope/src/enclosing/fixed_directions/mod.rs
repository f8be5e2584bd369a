//! Problem: the smallest zonotope along given directions around a set of points.
//!
//! Minimise Σ w_i c_i over centres p and coefficients c_i ≥ 0 such that { p + Σ δ_i c_i v_i : |δ_i| ≤ 1 } contains
//! every point. With unit vectors v_i and unit weights w_i the value is the total length. The problem is a linear
//! program, and it is feasible just when every difference of two points lies in the span of the directions.
//!
//! # Statement
//! Input: points of R^D, at least one, directions v_i and weights w_i ≥ 0. Output of the methods in doubles: a centre p
//! and coefficients c_i ≥ 0 in doubles such that every point lies in { p + Σ δ_i c_i v_i : |δ_i| ≤ 1 } exactly, with Σ
//! w_i c_i and a proven lower bound of it; or the proof that a difference of two points is not in the span of the
//! directions. Zero, parallel and repeated directions are legal; of parallel ones the cheapest is used. The optimum
//! need not be unique.
//!
//! # Shapes
//! `points`: n × D, any order, duplicates allowed; `directions`: k × D of any length; `coefficients`: half-lengths in
//! units of their directions.
//!
//! # Errors
//! [`OutOfRange`](FixedDirectionsError::OutOfRange) ⇔ a coefficient or the value exceeds the largest double. The
//! constructor of the problem refuses all other input.
//!
//! # Checked by
//! [`brute_force`]; the check of such answers in the crate `verifier`.
//!
//! # Methods
//! | method | time | notes |
//! |---|---|---|
//! | [`brute_force`] | criss-cross method on 2 C(k, d − 1) normals in rationals | the truth that all methods are held to |
//! | [`rational`] | simplex method on 2 C(k, d − 1) normals in rationals | the optimum in rationals; the three methods below fall back on it |
//! | [`papers_program`] | O(n k^{d−1}), then the engine on k n' + k + d unknowns | Section 4.2 as printed |
//! | [`support_form`] | O(n k^{d−1}), then the engine on k + d unknowns, 2 C(k, d − 1) rows | all normals at once |
//! | [`by_row_generation`] | a few passes over the points, pivots of O((k + d)²) | normals are added as points violate them; the default |
//!
//! Here n is the number of points, k of directions, d of dimensions, and n' of extreme points. The last three methods
//! are those of [`Method`], in doubles. [`papers_program`] and [`support_form`] need an engine for linear programs; its
//! answer is where they begin, not what they return. [`enclosing::along_directions`](super::along_directions) asks the
//! default method, with the lengths of the directions as weights.
//!
//! # The way from directions to a zonotope
//! 1. `solve` holds the steps that the methods share, in order; it is the file to read first.
//! 2. `departure` finds a point off the directions' span, if there is one; `scaled` takes coordinates of the span, of
//!    ordinary size, and one direction for each line.
//! 3. `row_generation/generation` and `normal_simplex` solve the linear program over the normals found so far, in
//!    doubles.
//! 4. [`zonotope::ray_exit`](crate::zonotope) finds the facet through which the ray to a point outside leaves; its
//!    normal joins the program.
//! 5. `lower_bound` rounds the multipliers so that they add up to zero exactly, and computes the bound that they prove.
//! 6. `contain` enlarges coefficients until every point is inside, exactly.
//!
//! That is all for ordinary input. Four pieces serve the rest, each behind one function: `solve/equilibrated` for
//! directions that are thin along an axis, `contain/flat_center` for directions that do not span the space,
//! `contain/thickened` for flat and needle-shaped bodies, and `solve/refine` for small problems whose bounds do not
//! meet.

#[cfg(feature = "linear-programming")]
mod all_normals;
mod answer;
pub mod brute_force;
pub mod by_row_generation;
mod contain;
mod departure;
mod farthest;
mod lower_bound;
mod method;
#[cfg(feature = "linear-programming")]
pub mod papers_program;
mod problem;
pub mod rational;
mod row_generation;
mod scaled;
mod solve;
#[cfg(feature = "linear-programming")]
pub mod support_form;

pub use answer::{DirectedZonotope, DirectionsProof, Enclosure, ExactOptimum, Multiplier, OPTIMAL_GAP, OffSpan};
pub(crate) use lower_bound::balanced;
pub(crate) use row_generation::generation::Generation;
pub(crate) use solve::{cheapest_center_along, contained};

pub use by_row_generation::min_length_along;
pub use method::Method;
pub use problem::{FixedDirections, FixedDirectionsError};
