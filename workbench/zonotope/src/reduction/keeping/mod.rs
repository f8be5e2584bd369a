//! Problem: which generators of a zonotope to keep as they are, and along which directions to put a parallelepiped
//! around the others.
//!
//! These are the rules in use in reachability analysis, where a few generators are added in each step and as many taken
//! away. They differ in what they keep and in the box. Each keeps k − D generators of k, and the others contribute to
//! the error with all their lengths: of bodies with many generators the error does not fall until k nears n.
//!
//! # Statement
//! Input: a zonotope in R^D and a count k ≥ D. Output: a zonotope with the same centre and at most k generators that
//! contains it exactly, with a proof by [`Shares`](super::Shares). A body of at most k generators is its own answer.
//! Flat bodies, zero and parallel generators are ordinary input; of equally good generators the first are kept.
//!
//! # Shapes
//! `generators`: n × D, half-segments, any order.
//!
//! # Errors
//! [`OutOfRange`](super::ReductionError::OutOfRange) ⇔ a generator of the answer exceeds the largest double.
//!
//! # Checked by
//! [`brute_force`](super::brute_force) and the check of the shares, in rationals.
//!
//! # Methods
//! | method | keeps | the others go into |
//! |---|---|---|
//! | [`by_girard`] | the generators farthest from the axes | the smallest box |
//! | [`by_combastel`] | the longest | the smallest box |
//! | [`by_pca`] | as [`by_girard`] | a box along their principal axes |
//! | [`by_scott`] | those that a parallelepiped can least take | a parallelepiped along D of them |
//! | [`by_adaptive`] | as [`by_girard`], fewer where the error stays the same | the smallest box |

pub mod by_adaptive;
pub mod by_combastel;
pub mod by_girard;
pub mod by_pca;
pub mod by_scott;
pub(super) mod order;
pub(super) mod principal_axes;
