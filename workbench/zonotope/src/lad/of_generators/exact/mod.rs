//! The optimum in exact arithmetic.

pub(crate) mod direction_signs;
pub(crate) mod longest_first;
pub(crate) mod solve;
