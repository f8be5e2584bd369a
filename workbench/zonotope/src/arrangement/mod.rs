//! Arrangements of lines in the plane.
//!
//! | problem | what is asked |
//! |---|---|
//! | [`slope_selection`] | the k-th leftmost vertex |

mod exact_sort;
pub(crate) mod fraction;
mod line;
pub(crate) mod lines;
mod rows;
pub mod slope_selection;

pub use line::{ExactLine, LineIndex};
pub use lines::LineArrangement;
pub use rows::ArrangementError;
