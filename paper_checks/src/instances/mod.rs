//! What the checks are run on: random instances from a seed, and the degenerate ones that random draws miss.
//!
//! | file | what it draws |
//! |---|---|
//! | [`polygons`] | convex polygons and points of the plane |
//! | [`bodies`] | zonotopes of R^3 |
//! | `sphere` | unit vectors, spread evenly |

pub mod bodies;
pub mod polygons;
pub(crate) mod sphere;
