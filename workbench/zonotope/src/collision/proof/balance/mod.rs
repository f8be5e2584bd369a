//! Few coefficients that absorb what all others leave of the displacement, and the generators that they belong to.
//!
//! | file | what it has |
//! |---|---|
//! | [`well_spread`] | three generators that are far from lying in one plane |
//! | [`basis`] | linearly independent generators, and exact coordinates in terms of them |
//! | [`solve`] | the coefficients of a basis in rationals, in any dimension |
//! | [`nearest`] | the coefficients of a basis as doubles beside their exact values |

pub(crate) mod basis;
pub(crate) mod nearest;
pub(crate) mod solve;
pub(crate) mod well_spread;
