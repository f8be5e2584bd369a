//! Problem: the Hausdorff distance of two zonotopes, between two bounds.
//!
//! The Hausdorff distance is the least t such that each body lies within t of the other. Of convex bodies it is the
//! largest difference of their support functions, max |h_A(u) − h_B(u)| over all unit vectors u. If A lies in B that is
//! the largest distance of a point of B from A. The difference of two convex functions may have many local maxima, and
//! none of them need be at a facet normal of either body; so the maximum is bounded from both sides. What is asked for
//! is the ratio of the bounds.
//!
//! Bodies of which one is moved by c against the other: of u and −u one makes u · c positive, so the distance is the
//! largest of |u · c| + h_A(u) − h_B(u) and |u · c| + h_B(u) − h_A(u) for the centred bodies. The displacement is one
//! more generator of the farther body, and half of all directions are enough.
//!
//! What both bodies have counts for nothing, and parallel generators count once.
//!
//! | method | cost | what it is |
//! |---|---|---|
//! | [`brute_force`] | 2^m m^(D − 1) rational operations for m generators in all | the truth, exactly |
//! | [`by_vertices`] | a nearest point for each vertex of either body | rounded once; the default for few vertices |
//! | [`by_branch_and_bound`] | some thousand cones of directions in space, measured; see there | the default for more |

mod answer;
mod ascent;
pub mod brute_force;
pub mod by_branch_and_bound;
pub mod by_vertices;
mod cone;
mod difference;
mod doors;
mod exact_difference;
mod inside;
mod nearest_point;
mod vertex;

pub use answer::Distance;
pub(in crate::reduction) use by_branch_and_bound::Limit;
pub(in crate::reduction) use doors::excess_with_limit;
pub use doors::{excess, hausdorff};
pub(in crate::reduction) use exact_difference::ExactDifference;
pub(in crate::reduction) use inside::lies_inside;

#[cfg(test)]
mod tests;
