//! Hierarchical collision (Section 5.2): bodies around and within a body, from coarse to fine, and whether two bodies
//! meet by descending through them.
//!
//! A body of many generators meets few others closely. Nested levels, made once, tell bodies that are far apart or deep
//! in each other from a handful of generators: the nearer to touching they are, the more levels are looked at. The
//! decision is exact at every level, since outer bodies contain the body and inner ones are within it, exactly.
//!
//! | file | what it has | cost |
//! |---|---|---|
//! | [`levels`] | the levels of a body: [`Hierarchy`] | O(n log n) |
//! | [`descent`] | how two bodies meet: [`Descent`] | O(k) for the levels that tell, O(n) if none but the last does |
//! | `grid` | cells of directions and their corners, one depth within the next | |
//! | `corner_sums` | outer bodies: the generators of cells in terms of corners | |
//! | `cell_sums` | inner bodies: the sums of the generators of cells | |

mod cell_sums;
mod corner_sums;
pub mod descent;
mod grid;
pub mod levels;

#[cfg(test)]
mod tests;

pub use descent::{Descent, PlacedHierarchy};
pub use levels::Hierarchy;
