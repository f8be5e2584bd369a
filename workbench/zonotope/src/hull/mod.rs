//! Problem: the convex hull of a finite set of points in the plane, and for each of its edges the farthest vertex.
//!
//! The hull is given by its vertices in counter-clockwise order, starting from the lexicographically smallest, no three
//! of them on a line; each vertex comes with the index of its first occurrence in the input. Points and segments are
//! hulls too, with one and two vertices. Every decision is exact, so the answer does not depend on the method.
//!
//! | method | time | notes |
//! |---|---|---|
//! | [`brute_force`] | O(n·h) | gift wrapping; the truth |
//! | [`by_discarding`] | O(n + m log m), m ≤ n | m points left after one pass; expected O(n) in ordinary input; the default |
//! | [`by_monotone_chain`] | O(n log n) | sort by x, then one chain below and one above (Andrew) |
//!
//! n points, h of them vertices of the hull. [`convex_hull`] is the default method; [`antipodal`] is a problem of its
//! own, as is [`in_space`]. The crate `verifier` checks a hull without trusting any of the methods.

pub mod antipodal;
pub mod brute_force;
pub mod by_discarding;
pub mod by_monotone_chain;
mod error;
pub mod in_space;
mod method;
mod polygon;
mod sites;

pub use by_discarding::convex_hull;
pub use error::{HullError, MAX_POINTS};
pub use method::Method;
pub use polygon::{ConvexHull, PointIndex, VertexIndex};

#[cfg(test)]
mod tests;
