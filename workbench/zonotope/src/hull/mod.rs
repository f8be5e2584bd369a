//! Problem: the convex hull of a finite set of points in the plane, and for each of its edges the farthest vertex.
//!
//! # Statement
//! Input: points with finite coordinates, at least one, in any order, duplicates allowed. Output: the vertices of their
//! convex hull, strictly convex, counter-clockwise from the lexicographically smallest, each with its first occurrence
//! in the input. Equal points give one vertex, collinear points two. Every decision is exact, so the answer does not
//! depend on the method.
//!
//! # Shapes
//! `points`: n × 2.
//!
//! # Errors
//! [`HullError::Empty`] ⇔ no points; [`HullError::NonFinite`] ⇔ a coordinate is NaN or infinite; [`HullError::TooMany`]
//! ⇔ more than [`MAX_POINTS`] points.
//!
//! # Methods
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
