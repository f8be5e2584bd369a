//! The places where the paper is wrong, leaves out a condition, or asks for a note; the statement is the paper's own.

pub(crate) mod area_formula_third_line;
pub(crate) mod axis_sum;
pub(crate) mod coefficient_at_line_minimum;
pub(crate) mod erosion;
pub(crate) mod exact_difference;
pub(crate) mod extreme_points_off_span;
pub(crate) mod flat_and_ambiguous;
pub(crate) mod independent_generators;
pub(crate) mod loose_containment;
pub(crate) mod rotation_radius;
pub(crate) mod separator_conventions;
pub(crate) mod star_shape;
pub(crate) mod straddling_tiles;
pub(crate) mod ties;
pub(crate) mod total_length;
pub(crate) mod translation_factor;
pub(crate) mod unimodality;
pub(crate) mod unstated_walks;
pub(crate) mod wide_patches;
