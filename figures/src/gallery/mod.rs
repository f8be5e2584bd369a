//! The figures, one a file.

pub mod arrangement_and_level_sets;
pub mod certificates_of_intersection;
pub mod country_outlines;
pub mod directions_needed;
pub mod dual_zonotope;
pub mod duality_family;
pub mod gap_curve;
pub mod length_ratio;
pub mod mesh_in_zonohedra;
pub mod named_zonohedra;
pub mod paper_figure_1;
pub mod paper_figure_2;
pub mod polygon_and_reflection;
pub mod scaling_collision_operations;
pub mod scaling_collision_times;
pub mod scaling_face_counts;
pub mod scaling_kernel_operations;
pub mod scaling_kernel_times;
pub mod scaling_min_area_operations;
pub mod scaling_min_area_times;
pub mod scaling_program_rows;
pub mod scaling_program_times;
pub mod search_of_theorem_4_5;
pub mod search_of_theorem_5_2;
pub mod separators;
pub mod zonogons_along_directions;
