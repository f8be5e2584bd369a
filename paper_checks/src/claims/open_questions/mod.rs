//! Section 7: the questions that the paper leaves open.

pub(crate) mod approximation_quality;
pub(crate) mod four_dimensional_intersection;
pub(crate) mod generator_count;
pub(crate) mod hierarchies;
pub(crate) mod optimal_volume;
