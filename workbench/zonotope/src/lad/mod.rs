//! The kernel: weighted least absolute deviations, min linear · x + Σ w_i |a_i · x + b_i|.
//!
//! Half of the paper reduces to it: the minimum-area enclosing zonogon (4.1) and membership in a zonotope in space
//! (5.1).
//!
//! | form | minimise over | methods, with their costs for n terms |
//! |---|---|---|
//! | [`of_lines`] | x in the plane: n weighted lines | [`by_pruning`], O(n) expected, the default; [`by_slope_selection`], O(n log² n) expected, the paper's search; [`by_line_search`], O(n) a step |
//! | `of_generators` | a direction of R^3: n generators | reduced to lines by a chart; expected O(n) |
//! | [`of_forms`] | x in space: n weighted planes, or linear forms in four variables | [`of_forms::by_line_search`], O(n) a step |
//!
//! Every form has its truth in exact rationals, and every optimum a certificate that a verifier checks on its own.
//! [`line_fit`](crate::line_fit) is the kernel as a statistician knows it: the line of least absolute deviations
//! through points.

pub mod of_forms;
pub(crate) mod of_generators;
pub mod of_lines;

pub use crate::arrangement::{ExactLine, LineIndex};
pub(crate) use of_lines::kernel_input;
pub use of_lines::{
    LadCertificate, LadError, LadOptimum, LadOutcome, LadProblem, Method, Minimizer, WeightedLine, brute_force,
    by_line_search, by_pruning, by_slope_selection, minimize,
};
