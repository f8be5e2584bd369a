//! Cells of directions, and the generators whose sign is fixed in them.

pub(crate) mod direction_cone;
pub(crate) mod nested;
pub(crate) mod reduced;
