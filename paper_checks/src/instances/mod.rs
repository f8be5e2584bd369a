//! Instances for the checks: random instances from a seed, and the degenerate ones that random draws miss.
//!
//! | file | what it draws |
//! |---|---|
//! | [`polygons`] | convex polygons and points of the plane |
//! | [`bodies`] | zonotopes of R^3 |
//! | `sweeps` | zonotopes of R^3 that turn and translate |
//! | `higher` | generators of R^4 and R^5 |

pub mod bodies;
pub(crate) mod higher;
pub mod polygons;
pub(crate) mod sweeps;
