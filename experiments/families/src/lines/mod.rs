//! Families of lines a·x + b = 0 in the plane: inputs of the least absolute deviations kernel and of slope selection.
//!
//! | family | what is hard about it |
//! | --- | --- |
//! | `random_lines` | nothing: the reference |
//! | `lattice_lines` | few directions, many concurrent and parallel lines |
//! | `near_parallel_lines` | directions agree to 1e-12: vertices are far away or badly conditioned |
//! | `concurrent_lines` | all vertices are one point |
//! | `symmetric_lines` | vertices come in pairs with one x; the optimum is not unique |

mod catalog;
mod concurrent;
mod family;
mod lattice;
mod near_parallel;
mod random;
mod symmetric;

pub use catalog::{LINE_FAMILIES, find};
pub use family::{LineFamily, LineRow};
