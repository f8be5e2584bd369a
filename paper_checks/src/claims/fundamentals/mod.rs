//! Section 3: definitions and the duality with line arrangements.

pub(crate) mod center_and_generators;
pub(crate) mod dual_diagram;
pub(crate) mod face_count;
pub(crate) mod figure_1;
pub(crate) mod tiling;
