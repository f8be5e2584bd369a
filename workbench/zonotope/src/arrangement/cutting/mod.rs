//! Problem: a (1/r)-cutting of lines in the plane, with the lines that cross each trapezoid, and location in it.
//!
//! A (1/r)-cutting of n lines covers the plane with trapezoids, each of them crossed in its interior by at most n / r
//! lines. Section 5.2 cuts the dual arrangement of n generators so and maps the trapezoids into the tiling of Q: a
//! query is located among O(r²) cells, and only the n / r generators whose lines cross its cell are left to look at
//! (Lemma 5.3). For that the sides of trapezoids lie along lines of the arrangement and walls go through its vertices,
//! which have their counterparts in the tiling; the lines along the sides are named beside those that cross.
//!
//! Trapezoids are closed on the left and at the bottom, open on the right and at the top, so that each point of the
//! plane lies in exactly one.
//!
//! | method | cost for n lines | what it is |
//! |---|---|---|
//! | [`brute_force`] | O(n) rational operations a trapezoid or a point, O(N²) for a cover by N | the truth, and a check |
//! | [`by_hierarchy`] | O(n r) time and space, O(r²) trapezoids, measured; O(log r) a query | cells cut in two, the default |

pub mod brute_force;
pub mod by_hierarchy;
mod cell;
mod outline;
mod parts;
mod plane;
mod search;
mod split_choice;
mod subdivision;
mod trapezoid;

pub use by_hierarchy::cutting;
pub(crate) use parts::{Part, SearchStep};
pub use subdivision::Cutting;
pub use trapezoid::{Boundary, Trapezoid, TrapezoidIndex, Wall};

#[cfg(test)]
mod tests;
