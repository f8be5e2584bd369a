//! Problem: the convex hull of a finite set of points of space.
//!
//! The hull of points that span space is given by triangles, counter-clockwise as seen from outside; a facet that holds
//! more than three vertices, or other points, may come in several of them. Every decision is exact.
//!
//! | method | time | notes |
//! |---|---|---|
//! | [`brute_force`] | O(n⁴) | the planes through three points with no points on one side; the truth |
//! | [`by_quickhull`] | O(n log n) in ordinary input, O(n²) at worst | points beside a facet wait there; the default |
//!
//! [`solid_hull`] is the default method. [`hull_corners`] also takes points that lie in a plane, on a line or in one
//! place, and says which of them have the hull of all. That is what a body around millions of points needs to know of
//! them: a convex set contains all if it contains these.

pub mod brute_force;
pub mod by_quickhull;
mod corners;
mod simplex;
mod triangulated;

pub use by_quickhull::solid_hull;
pub use corners::hull_corners;
pub use triangulated::SolidHull;

#[cfg(test)]
mod tests;
