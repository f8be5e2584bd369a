//! Arrangements of lines in the plane.
//!
//! | problem | what is asked |
//! |---|---|
//! | [`slope_selection`] | the k-th leftmost vertex |
//! | [`separator`] | the chain with k tiles of the dual tiling on its left |
//! | [`cutting`] | trapezoids that few lines cross, with the lines that cross each, and where a point is among them |
//! | [`dynamic_hull`] | the envelopes of lines that come and go: what a walk over an arrangement needs |
//! | [`facet_walk`] | the neighbours of a facet: of a vertex of the dual arrangement, one step after another |
//! | [`tiling`] | the tiling that is dual to the arrangement of generators in space, with the isomorphism |
//!
//! [`DualArrangement`] is the arrangement that Section 3 attaches to the generators of a zonotope in space.

pub mod cutting;
pub(crate) mod dual;
pub mod dynamic_hull;
mod exact_sort;
pub mod facet_walk;
pub(crate) mod fraction;
mod line;
pub(crate) mod lines;
mod rows;
pub mod separator;
pub mod slope_selection;
pub mod tiling;

pub use dual::{DualArrangement, GeneratorError};
pub use line::{ExactLine, LineIndex};
pub use lines::LineArrangement;
pub use rows::ArrangementError;
