//! The dual arrangement of generators of space: its vertices from the left, the tilings of Q, the upper hull.

pub(crate) mod separator;
pub(crate) mod slope_selection;
pub(crate) mod tiling;
pub(crate) mod upper_hull;
pub(crate) mod walk;
