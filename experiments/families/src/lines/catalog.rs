//! The list of the families of lines.

use super::family::LineFamily;
use super::{concurrent, lattice, near_parallel, random, symmetric};

/// Every line family, in the order in which reports list them.
pub static LINE_FAMILIES: &[LineFamily] = &[
    random::RANDOM_LINES,
    lattice::LATTICE_LINES,
    near_parallel::NEAR_PARALLEL_LINES,
    concurrent::CONCURRENT_LINES,
    symmetric::SYMMETRIC_LINES,
];

/// The line family called `id`, if there is one.
pub fn find(id: &str) -> Option<&'static LineFamily> {
    LINE_FAMILIES.iter().find(|family| family.id == id)
}
