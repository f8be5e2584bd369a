//! Section 2: the summary of the results.

pub(crate) mod approximate_length;
pub(crate) mod fixed_directions;
pub(crate) mod intersection;
pub(crate) mod min_area;
pub(crate) mod repeated_tests;
pub(crate) mod space_time;
