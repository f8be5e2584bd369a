//! Few coefficients that absorb what all others leave of the displacement, and the generators that they belong to.
//!
//! | file | what it has |
//! |---|---|
//! | [`triple`] | the coefficients of three vectors, over doubles or pairs of them with bounds, or exact numbers |
//! | [`choice`] | three generators that are far from lying in one plane |
//! | [`any_rest`] | three generators that absorb a rest of which only the size is known |
//! | [`basis`] | linearly independent generators, and exact coefficients in terms of them |
//! | [`solve`] | the coefficients of a basis in rationals, in any dimension |
//! | [`nearest`] | the coefficients of a basis as doubles beside their exact values |

pub(crate) mod any_rest;
pub(crate) mod basis;
pub(crate) mod choice;
pub(crate) mod nearest;
pub(crate) mod solve;
pub(crate) mod triple;
