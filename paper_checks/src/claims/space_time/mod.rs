//! Section 6: bounding volumes of moving zonotopes.

pub(crate) mod any_schedule;
pub(crate) mod arc_count;
pub(crate) mod arcs_in_circle;
pub(crate) mod bisection;
pub(crate) mod disjoint_volumes;
pub(crate) mod farthest_vertex;
pub(crate) mod figure_3;
pub(crate) mod missed_between_steps;
pub(crate) mod placements;
pub(crate) mod projected_vertices;
pub(crate) mod theorem_6_1;
pub(crate) mod translation;
