//! One statement of the paper in each file, gathered by section.

pub(crate) mod corrections;
pub(crate) mod dynamic_collision;
pub(crate) mod fixed_directions;
pub(crate) mod fundamentals;
pub(crate) mod introduction;
pub(crate) mod min_area;
pub(crate) mod min_total_length;
pub(crate) mod open_questions;
pub(crate) mod space_time;
pub(crate) mod static_collision;
pub(crate) mod summary;
