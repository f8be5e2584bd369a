//! What is generic over the dimension, compiled for the dimensions that programs ask about.
//!
//! rustc compiles a generic function anew in each crate that calls it, and each of these functions brings thousands
//! with it: whole linear programs in two kinds of arithmetic. One that is never inlined is taken from the crate that
//! defines it, if that crate has compiled it. So the functions below are marked so, and compiled here, once for all
//! programs and tests.

use crate::collision::{self, distance};
use crate::enclosing::{self, fixed_directions, min_total_length};
use crate::reduction::{self, hausdorff};
use crate::zonotope::pose::Pose;
use crate::zonotope::{AtRest, combinatorics};

/// The addresses of the functions in each dimension.
pub fn instances() -> [Vec<*const ()>; 4] {
    [of_dimension::<1>(), of_dimension::<2>(), of_dimension::<3>(), of_dimension::<4>()]
}

fn of_dimension<const D: usize>() -> Vec<*const ()> {
    #[allow(unused_mut, reason = "a feature adds some")]
    let mut instances = vec![
        collision::Method::locate::<D> as *const (),
        collision::Method::gauge::<D> as *const (),
        collision::Method::nearest_gauge::<D> as *const (),
        collision::by_lad::located::<D, AtRest> as *const (),
        collision::by_lad::nearly_measured::<D, AtRest> as *const (),
        collision::brute_force::locate::<D, AtRest> as *const (),
        collision::brute_force::gauge::<D, AtRest> as *const (),
        distance::penetration::of_query::<D> as *const (),
        enclosing::along_directions::<D> as *const (),
        enclosing::min_length::<D> as *const (),
        enclosing::min_length_of_few::<D> as *const (),
        fixed_directions::Method::solve::<D> as *const (),
        fixed_directions::min_length_along::<D> as *const (),
        fixed_directions::brute_force::least_length::<D> as *const (),
        fixed_directions::rational::min_length_in_rationals::<D> as *const (),
        min_total_length::Method::solve::<D> as *const (),
        min_total_length::by_direction_net::min_length_by_net::<D> as *const (),
        min_total_length::few_generators::fewest::<D> as *const (),
        min_total_length::few_generators::shortest_of_few::<D> as *const (),
        reduction::Method::reduce::<D> as *const (),
        reduction::by_patches::patches_within::<D> as *const (),
        reduction::contains::<D> as *const (),
        reduction::Reduced::<D>::distance as *const (),
        hausdorff::hausdorff::<D> as *const (),
        hausdorff::by_vertices::hausdorff_at_vertices::<D> as *const (),
        hausdorff::by_branch_and_bound::hausdorff_by_cones::<D> as *const (),
        hausdorff::excess::<D> as *const (),
        combinatorics::<D> as *const (),
    ];
    #[cfg(feature = "linear-programming")]
    instances.extend([
        fixed_directions::support_form::min_length_by_support_form::<D> as *const (),
        fixed_directions::papers_program::min_length_by_papers_program::<D> as *const (),
    ]);
    instances
}

/// The addresses of the functions about bodies under poses.
pub fn instances_under_poses() -> Vec<*const ()> {
    vec![
        collision::by_lad::locate::<3, Pose> as *const (),
        collision::by_lad::gauge::<3, Pose> as *const (),
        collision::by_lad::nearest_gauge::<3, Pose> as *const (),
        distance::by_support_simplex::proximity::<3, Pose> as *const (),
        distance::penetration::by_inner_polytope::penetration::<Pose> as *const (),
    ]
}
