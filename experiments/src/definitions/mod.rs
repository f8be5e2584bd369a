//! The experiments, one a file, and the families and sizes that several of them share.

pub mod area_ratio;
pub mod coherence;
mod collision_methods;
pub mod collision_scaling;
pub mod directions_scaling;
pub mod enclosing_quality;
pub mod faces_scaling;
pub mod fallback_rate;
pub mod few_generators;
mod fixed_directions_methods;
pub mod gap_curve;
pub mod gauge_passes;
pub mod hierarchy_levels;
pub mod hull_scaling;
mod kernel_methods;
pub mod lad_race;
pub mod lad_scaling;
pub mod least_volume;
pub mod length_ratio;
pub mod mesh_node_tests;
pub mod methods_agree;
pub mod min_area_scaling;
pub mod min_area_stages;
pub mod motion_clearance;
pub mod motion_misses;
pub mod net_points;
pub mod net_scaling;
pub mod patches_error;
pub mod patches_scaling;
pub mod points_scaling;
pub mod pruning_passes;
pub mod query_growth;
pub mod query_trade_off;
pub mod reduction_error;
mod repeated_queries;
pub mod rung_shares;
pub mod scan_race;
pub mod slope_selection_scaling;
pub mod swept_volumes;
pub mod tree_queries;
pub mod walk_steps;
pub mod wrong_answers;

use crate::definition::PerProfile;

/// Families of every hull size for the scaling experiments of 4.1.
pub const SCALING_FAMILIES: &[&str] =
    &["circle", "ellipse", "random_convex", "regular_polygon", "gaussian", "clustered"];

/// Those of them with (nearly) all points on the hull.
pub const HULL_FAMILIES: &[&str] = &["circle", "ellipse", "random_convex", "regular_polygon"];

/// Every real input.
pub const REAL_INPUTS: &[&str] = &[
    "airports",
    "australia",
    "canada",
    "chile",
    "croatia",
    "france",
    "iceland",
    "italy",
    "new_zealand",
    "norway",
    "vietnam",
];

/// 2^first, 2^(first + 1), …
const fn powers_of_two<const COUNT: usize>(first: usize) -> [usize; COUNT] {
    let mut powers = [0; COUNT];
    let mut at = 0;
    while at < COUNT {
        powers[at] = 1 << (first + at);
        at += 1;
    }
    powers
}

/// 2^6, 2^7, … 2^20.
const POWERS_OF_TWO: [usize; 15] = powers_of_two(6);

/// Powers of two from 2^6: to 2^14 in the quick profile, to 2^20 in the full one.
pub const SCALING_SIZES: PerProfile<&[usize]> = PerProfile { quick: POWERS_OF_TWO.split_at(9).0, full: &POWERS_OF_TWO };

/// Powers of two from 2^6: to 2^18 in the quick profile, as the operation counts of pruning are quickly had, to 2^20 in
/// the full one.
pub const PRUNING_SIZES: PerProfile<&[usize]> =
    PerProfile { quick: POWERS_OF_TWO.split_at(13).0, full: &POWERS_OF_TWO };

/// The same for the kernel's other methods and for times: to 2^17 in the quick profile.
pub const KERNEL_SIZES: PerProfile<&[usize]> = PerProfile { quick: POWERS_OF_TWO.split_at(12).0, full: &POWERS_OF_TWO };

/// Every family of bodies in space whose questions can be asked at every size.
pub const BODY_FAMILIES: &[&str] = &[
    "random_bodies",
    "box_sums",
    "polar_bodies",
    "sorted_bodies",
    "heavy_tailed_bodies",
    "lattice_bodies",
    "parallel_bodies",
    "noisy_directions_bodies",
    "near_plane_bodies",
    "flat_bodies",
];

/// 2^4, 2^5, … 2^20.
const BODY_POWERS_OF_TWO: [usize; 17] = powers_of_two(4);

/// Powers of two from 2^4: to 2^14 in the quick profile, to 2^20 in the full one.
pub const BODY_SIZES: PerProfile<&[usize]> =
    PerProfile { quick: BODY_POWERS_OF_TWO.split_at(11).0, full: &BODY_POWERS_OF_TWO };

/// Powers of two from 2^10, where lower-order terms have become small: to 2^14 in the quick profile, to 2^18 in the
/// full one.
pub const LINEAR_SIZES: PerProfile<&[usize]> = PerProfile {
    quick: BODY_POWERS_OF_TWO.split_at(6).1.split_at(5).0,
    full: BODY_POWERS_OF_TWO.split_at(6).1.split_at(9).0,
};

/// The powers of four among them, for times: to 2^12 in the quick profile.
pub const TIMED_BODY_SIZES: PerProfile<&[usize]> = PerProfile {
    quick: &[1 << 4, 1 << 6, 1 << 8, 1 << 10, 1 << 12],
    full: &[1 << 4, 1 << 6, 1 << 8, 1 << 10, 1 << 12, 1 << 14, 1 << 16, 1 << 18, 1 << 20],
};

/// From this many generators on the kernel prunes; it evaluates all of a smaller body at once.
pub const PRUNED_BODIES: usize = 1 << 10;

/// Powers of two from the size on at which the kernel prunes: to 2^14 in the quick profile, to 2^20 in the full one.
pub const PRUNED_BODY_SIZES: PerProfile<&[usize]> =
    PerProfile { quick: BODY_POWERS_OF_TWO.split_at(6).1.split_at(5).0, full: BODY_POWERS_OF_TWO.split_at(6).1 };
