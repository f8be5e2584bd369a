//! Section 4.2: enclosing zonotopes along given directions.

pub(crate) mod extreme_points;
pub(crate) mod linear_program;
pub(crate) mod structure_from_directions;
pub(crate) mod theorem_4_6;
