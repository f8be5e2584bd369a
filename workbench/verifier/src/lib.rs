//! An exact check of answers about zonotopes, by code that shares nothing with the solvers but the big integers.
//!
//! Every double is a whole multiple of a power of two. So all the numbers of one question and its answer are laid on one
//! `grid`: integers, in which sums and products are exact. What is proved on the grid holds for the numbers as written.
//! Distances between a rounded figure and the exact one are measured in the same integers.

mod arrangement;
mod bodies;
mod collision;
mod enclosing;
mod exact;
mod faces;
mod verdict;

pub use arrangement::separator::{SeparatorProof, check_separator};
pub use arrangement::slope_selection::{SlopeSelectionProof, check_slope_selection};
pub use arrangement::upper_hull::check_upper_hull;
pub use bodies::combinatorics::{CombinatoricsAnswer, check_combinatorics};
pub use bodies::support::{SupportAnswer, SupportProof, check_support};
pub use collision::displaced::{Body, Displaced, Pose};
pub use collision::gauge::{GaugeAnswer, GaugeProof, check_gauge};
pub use collision::location::{LocationAnswer, LocationCertificate, LocationProof, Status, check_location};
pub use collision::member_batch::{MemberBatchProof, check_member_batch};
pub use enclosing::min_area::{
    Certificate, ExactMinArea, MinAreaAnswer, MinAreaProof, check_exact_min_area, check_min_area,
};
pub use enclosing::min_length_all::{
    MinLengthAnswer, MinLengthProof, check_min_length_all, check_min_length_all_bounds,
};
pub use enclosing::min_length_dirs::{
    Directed, DirectedAnswer, DirectedProof, check_min_length_dirs, check_min_length_dirs_bounds,
};
pub use exact::fraction::Fraction;
pub use exact::whole_direction;
pub use verdict::{Proved, Verdict};

/// The largest relative difference that is accepted between a figure of an answer and its exact value.
pub const RELATIVE_ERROR: f64 = 1e-12;
