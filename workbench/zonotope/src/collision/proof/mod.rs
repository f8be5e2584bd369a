//! Proofs of a location: a direction that separates, or coefficients in [−1, 1] that combine to the displacement.
//!
//! | file or folder | what it proves from |
//! |---|---|
//! | [`at_vertex`] | two generators that a search in doubles found, of which nothing is known |
//! | [`of_optimum`] | an optimum of the kernel, rounded or exact |
//! | [`balance`] | few coefficients that absorb what all others leave of the displacement |
//! | [`sign_rule`] | coefficients that are a factor with signs, written for whoever reads them |
//! | [`separation`] | a direction in doubles with room for its rounding, or an exact one |
//! | [`direction_of_doubles`] | doubles near the normal of a facet that separate as the normal does |
//! | [`tightest_facet`] | the facet that bounds a gauge, found by trying every normal |
//! | [`vectors`] | the generators in doubles, with bounds of their rounding and of their sums'; the coefficients of three of them |
//! | [`to_doubles`] | rational coefficients, of which all but those of a basis become doubles |

pub(crate) mod at_vertex;
pub(crate) mod balance;
mod direction_of_doubles;
pub(crate) mod of_optimum;
pub(crate) mod separation;
pub(crate) mod sign_rule;
pub(crate) mod tightest_facet;
pub(crate) mod to_doubles;
pub(crate) mod vectors;
