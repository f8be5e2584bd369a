//! The list of figures. Adding one is one file in [`gallery`](crate::gallery) and one entry here.

use crate::figure::Figure;
use crate::gallery::{
    arrangement_and_level_sets, certificates_of_intersection, coherence, control_zonotopes, country_outlines,
    cutting_and_image, directions_needed, dual_zonotope, duality_family, facet_walk, few_generators, gap_curve,
    least_volume, length_ratio, mesh_cost_against_fit, mesh_in_hierarchy, mesh_in_zonohedra, mesh_node_tests,
    motion_time_bar, named_zonohedra, nested_hierarchy, paper_figure_1, paper_figure_2, paper_figure_3,
    polygon_and_reflection, query_trade_off, reduction_error, reductions, scaling_collision_operations,
    scaling_collision_times, scaling_face_counts, scaling_kernel_operations, scaling_kernel_times,
    scaling_min_area_operations, scaling_min_area_times, scaling_program_rows, scaling_program_times,
    search_of_theorem_4_5, search_of_theorem_5_2, separators, swept_volumes, tracked_features, walk_steps,
    zonogons_along_directions,
};

/// Every figure, in the order of reports.
pub static FIGURES: &[Figure] = &[
    named_zonohedra::FIGURE,
    paper_figure_1::FIGURE,
    duality_family::FIGURE,
    separators::FIGURE,
    search_of_theorem_5_2::FIGURE,
    certificates_of_intersection::FIGURE,
    paper_figure_2::FIGURE,
    polygon_and_reflection::FIGURE,
    arrangement_and_level_sets::FIGURE,
    search_of_theorem_4_5::FIGURE,
    country_outlines::FIGURE,
    scaling_min_area_operations::FIGURE,
    scaling_min_area_times::FIGURE,
    scaling_kernel_operations::FIGURE,
    scaling_kernel_times::FIGURE,
    zonogons_along_directions::FIGURE,
    mesh_in_zonohedra::FIGURE,
    dual_zonotope::FIGURE,
    length_ratio::FIGURE,
    gap_curve::FIGURE,
    few_generators::FIGURE,
    directions_needed::FIGURE,
    scaling_program_rows::FIGURE,
    scaling_program_times::FIGURE,
    scaling_face_counts::FIGURE,
    scaling_collision_operations::FIGURE,
    scaling_collision_times::FIGURE,
    cutting_and_image::FIGURE,
    query_trade_off::FIGURE,
    reductions::FIGURE,
    reduction_error::FIGURE,
    nested_hierarchy::FIGURE,
    facet_walk::FIGURE,
    tracked_features::FIGURE,
    walk_steps::FIGURE,
    coherence::FIGURE,
    paper_figure_3::FIGURE,
    swept_volumes::FIGURE,
    control_zonotopes::FIGURE,
    motion_time_bar::FIGURE,
    mesh_in_hierarchy::FIGURE,
    mesh_node_tests::FIGURE,
    mesh_cost_against_fit::FIGURE,
    least_volume::FIGURE,
];

/// The figure called `id`, if there is one.
pub fn find(id: &str) -> Option<&'static Figure> {
    FIGURES.iter().find(|figure| figure.id == id)
}
