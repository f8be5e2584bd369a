//! Weighted least absolute deviations in the plane: the kernel in affine form.
//!
//! Minimise linear · x + Σ w_i |a_i · x + b_i| over x in the plane, w_i ≥ 0. The objective is convex, and it is linear
//! on each cell of the arrangement of the lines a_i · x + b_i = 0. The minimum-area enclosing zonogon of Section 4.1
//! reduces to it.
//!
//! # Statement
//! Input: lines with weights and a linear term ([`LadProblem`]). Output: an exact minimiser, named by its defining
//! lines, with a certificate, or a direction along which the objective falls without bound. When the minimiser is not
//! unique, the output is one vertex of the set of minimisers and the dimension of that set. Parallel, equal,
//! concurrent, vertical and zero lines are ordinary input.
//!
//! # Shapes
//! `problem`: n lines in any order, duplicates allowed.
//!
//! # Checked by
//! [`brute_force`], and the crate `verifier` on every answer.
//!
//! # Methods
//! | method | cost for n lines | what it is |
//! |---|---|---|
//! | [`brute_force`] | O(n³), exact rationals | the truth |
//! | [`by_line_search`] | O(n) a step, few steps | exact descent by weighted medians |
//! | [`by_slope_selection`] | O(n log² n) expected | the paper's search (Theorem 4.5) |
//! | [`by_pruning`] | O(n) expected | the default |
//!
//! The methods but the truth share four stages, each resting on those before it:
//!
//! | stage | what it holds |
//! |---|---|
//! | `input` | the validated problem, its lines in floating point and exactly |
//! | `subproblem` | some of the lines with a linear term that stands for the others; the subdifferential at a vertex by one pass |
//! | `cells` | a parallelogram around a guess, and the lines that certainly miss it |
//! | `descent` | the minimum on one line, the optimality of a vertex, the descent from vertex to vertex |
//!
//! What comes out is in `optimum` and `certificate`; `sign_vectors` answers on which side of each line other points
//! lie.

pub mod brute_force;
pub mod by_line_search;
pub mod by_pruning;
pub mod by_slope_selection;
mod cells;
mod certificate;
mod descent;
mod input;
mod method;
mod optimum;
mod sign_vectors;
mod subproblem;

pub use by_pruning::minimize;
pub use certificate::LadCertificate;
pub use input::{LadError, LadProblem, WeightedLine};
pub use method::Method;
pub use optimum::{LadOptimum, LadOutcome, Minimizer};

/// The parts of a problem whose lines do not come from a slice of doubles.
pub(crate) mod kernel_input {
    pub(crate) use super::input::exact_lines::ExactLines;
    pub(crate) use super::input::rounded_lines::{Columns, LineError, MadeLines};
    pub(crate) use crate::arrangement::ExactLine;
}

#[cfg(test)]
mod tests;
