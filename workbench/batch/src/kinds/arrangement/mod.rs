//! Kinds about the dual arrangement of generators.

pub(super) mod separator;
pub(super) mod slope_selection;
pub(super) mod upper_hull;
pub(super) mod walk;
