//! The kernel: weighted least absolute deviations in the plane.
//!
//! Minimise linear · x + Σ w_i |a_i · x + b_i| over x in the plane, w_i ≥ 0. The objective is convex and linear on each
//! cell of the arrangement of the lines a_i · x + b_i = 0. Half of the paper reduces to it: the minimum-area enclosing zonogon (4.1) and
//! membership in a zonotope in space (5.1).
//!
//! | method | cost for n lines | what it is |
//! |---|---|---|
//! | [`brute_force`] | O(n³), exact rationals | the truth |
//! | [`by_line_search`] | O(n) a step, few steps | exact descent by weighted medians |
//! | [`by_slope_selection`] | O(n log² n) expected | the paper's search (Theorem 4.5) |
//! | [`by_pruning`] | O(n) expected | the default |
//!
//! [`line_fit`](crate::line_fit) is the kernel as a statistician knows it: the line of least absolute deviations through points;
//! [`in_space`] is the same problem in three variables.
//!
//! Every method but the truth returns a minimiser named by its defining lines with a certificate that
//! [`verify`] checks on its own.

pub mod brute_force;
pub mod by_line_search;
pub mod by_pruning;
pub mod by_slope_selection;
mod cell;
mod cone;
mod decide;
mod exact_lines;
pub mod in_space;
mod instance;
mod line_search;
mod method;
pub(crate) mod of_generators;
mod optimum;
mod problem;
mod rounded_lines;
mod sides;
mod solution;
mod solve;
pub mod verify;
mod vertex;

pub use crate::arrangement::{ExactLine, LineIndex};
pub use by_pruning::{minimize, minimize_counted};
pub use method::Method;
pub use optimum::{LadCertificate, LadOptimum, LadOutcome, Minimizer};
pub use problem::{LadError, LadProblem, WeightedLine};

/// What a problem is made of when its lines come from elsewhere than a slice of doubles.
pub(crate) mod kernel_input {
    pub(crate) use super::exact_lines::ExactLines;
    pub(crate) use super::rounded_lines::{Columns, LineError, MadeLines};
    pub(crate) use crate::arrangement::ExactLine;
}

#[cfg(test)]
mod tests;
