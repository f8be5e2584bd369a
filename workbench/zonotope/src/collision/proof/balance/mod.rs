//! Few coefficients that absorb what all others leave of the displacement, and the generators that they belong to.
//!
//! | file | what it has |
//! |---|---|
//! | [`well_spread`] | three generators that are far from lying in one plane |
//! | [`basis`] | linearly independent generators, and exact coordinates in terms of them |
//! | [`solve`] | the coefficients of a basis in rationals, in any dimension |
//! | [`nearest`] | the coefficients of a basis as doubles beside their exact values |
//! | [`from_exact_rest`] | the same, where the last places need the exact rest |

pub(crate) mod basis;
mod from_exact_rest;
pub(crate) mod nearest;
pub(crate) mod solve;
pub(crate) mod well_spread;
