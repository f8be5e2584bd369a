//! Problem: the zonogon of least area that contains given points of the plane.
//!
//! A zonogon is a centrally symmetric polygon. So with the centre O fixed the smallest one is Z(O) = conv(P ∪ P'),
//! where P' are the points reflected in O. Its area is a convex function of O, piecewise linear over the arrangement of
//! the lines ℓ_t ([`bisectors`](super::bisectors)): up to a constant, a problem for the kernel [`lad`](crate::lad).
//!
//! | method | time | notes |
//! |---|---|---|
//! | [`brute_force`] | O(n log n + h³ log h), exact rationals | every vertex of the arrangement; the truth that the methods are held to |
//! | [`by_kernel`] | O(n log n) for the hull, then the kernel's | the default, with any method of the kernel |
//!
//! Here n is the number of points and h the number of the hull's vertices. [`exact`] gives the optimum in rationals,
//! and the crate `verifier` checks answers without trusting the methods. [`Method`] has the methods by name,
//! [`enclosing::min_area`](super::min_area) asks the default one.

mod answer;
pub mod brute_force;
pub mod by_kernel;
pub mod exact;
mod method;
mod rounded_center;
mod segment;

pub use answer::{AreaProof, MinAreaError, MinAreaZonogon};
pub use method::Method;

#[cfg(test)]
mod tests;
