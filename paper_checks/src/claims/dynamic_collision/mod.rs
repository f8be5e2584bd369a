//! Section 5.2: repeated intersection tests.

pub(crate) mod arrangement_trade_off;
pub(crate) mod ball_approximation;
pub(crate) mod closest_pair;
pub(crate) mod convex_approximation;
pub(crate) mod corollary_5_4;
pub(crate) mod cutting_size;
pub(crate) mod diameter;
pub(crate) mod lemma_5_3;
pub(crate) mod lemma_5_5;
pub(crate) mod lemma_5_5_containment;
pub(crate) mod lemma_5_6;
pub(crate) mod local_walk;
pub(crate) mod pseudo_lines;
pub(crate) mod rotations;
pub(crate) mod small_motions;
pub(crate) mod translation_by_point_location;
pub(crate) mod zonoid_approximation;
