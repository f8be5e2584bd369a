//! The plane.

mod best_center;
mod by_golden_section;

pub(super) use best_center::least_in_plane;
pub use by_golden_section::least_length;
