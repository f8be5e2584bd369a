//! Weighted least absolute deviations in space: the kernel in three variables, or in linear forms over R^4.
//!
//! Minimise linear · x + Σ w_i |a_i · x + b_i| over x in space, w_i ≥ 0. Membership in a zonotope of R^4 reduces to it,
//! and with that the intersection of space-time zonotopes, which the paper leaves open.
//!
//! | method | cost for n planes | what it is |
//! |---|---|---|
//! | [`brute_force`] | O(n⁴), exact rationals | the truth |
//! | [`by_line_search`] (default) | O(n) a step, few steps | exact descent along the arrangement's edges by weighted medians |
//!
//! Every optimum carries a certificate that the crate `verifier` checks on its own. The search works in homogeneous
//! coordinates:
//!
//! | file | what it holds |
//! |---|---|
//! | `problem`, `outcome` | the weighted planes, and the answer with its proof |
//! | `instance`, `vector4` | the problem as linear forms over R^4, with rounded products and their bounds |
//! | `vertex` | a vertex of the arrangement with the subdifferential there |
//! | `line_search` | the lowest vertex along an edge |

pub mod brute_force;
pub mod by_line_search;
mod instance;
mod line_search;
mod outcome;
mod problem;
mod vector4;
mod vertex;

pub use by_line_search::minimize;
pub use outcome::{SpaceCertificate, SpaceOptimum, SpaceOutcome};
pub use problem::{SpaceLadError, SpaceLadProblem, WeightedPlane};

/// The parts of the search, for problems that come as linear forms in four variables.
pub(crate) mod homogeneous {
    pub(crate) use super::by_line_search::{Descent, descend};
    pub(crate) use super::instance::{Instance, Source};
    pub(crate) use super::vector4::Vector4;
}

#[cfg(test)]
mod tests;
