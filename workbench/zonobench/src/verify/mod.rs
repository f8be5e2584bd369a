//! An exact check of answers, by code that shares nothing with the solvers but the big integers.
//!
//! Every double is a whole multiple of a power of two. So all the numbers of one question and its answer are laid on one
//! `grid`: integers, in which sums and products are exact. What is proved on the grid holds for the numbers as written.
//! Distances between a rounded figure and the exact one are measured in the same integers.

mod combinatorics;
mod cone;
mod containment;
mod dual_reach;
mod facets;
mod gauge;
mod grid;
mod length;
mod linear;
mod location;
mod member_batch;
mod min_area;
mod min_length_all;
mod min_length_dirs;
mod pencil;
mod polygon;
mod proportion;
mod separator;
mod slope_selection;
mod subsets;
mod support;
mod transcript;
mod turns;
mod upper_hull;

pub use combinatorics::{CombinatoricsAnswer, CombinatoricsProof, check_combinatorics};
pub use gauge::{GaugeAnswer, GaugeProof, check_gauge};
pub use location::{Displaced, LocationAnswer, LocationCertificate, check_location};
pub use member_batch::check_member_batch;
pub use min_area::{Certificate, ExactMinArea, MinAreaAnswer, MinAreaProof, check_exact_min_area, check_min_area};
pub use min_length_all::{MinLengthAnswer, MinLengthProof, check_min_length_all};
pub use min_length_dirs::{Directed, DirectedAnswer, DirectedProof, check_min_length_dirs};
pub use separator::check_separator;
pub use slope_selection::{Fraction, check_slope_selection};
pub use support::{SupportAnswer, check_support};
pub use transcript::{Verdict, check};
pub use upper_hull::check_upper_hull;

/// The largest relative difference that is accepted between a figure of an answer and its exact value.
pub const RELATIVE_ERROR: f64 = 1e-12;
