//! A vertex proved to be the optimum, or near it, by bounds on every rounding error.
//!
//! | file | what it proves |
//! |---|---|
//! | [`rounded_optimum`] | a vertex is the optimum, or so near to it that the gauge is between two bounds |
//! | [`residual`] | what the vertex leaves of λ p, for coefficients in [−1, 1] |
//! | [`near_generators`] | the sum of the generators whose sign at the vertex is not certain |
//! | [`facet_of_pair`] | where the displacement lies, from a vertex of which nothing is known |
//! | [`facet_in_pairs`] | the same near the boundary, in pairs of doubles |
//! | [`direction_of_doubles`] | doubles near the normal of a facet separate as the normal does |
//! | [`touching_facet`] | the displacement is exactly on the facet of such a vertex |
//! | [`three_coefficients`] | three generators make up for what the others leave |
//! | [`unit_gauge_bound`] | how thick the body is at least |
//! | [`gauge_interval`] | on which side of the boundary the displacement ends |

pub(crate) mod direction_of_doubles;
mod facet_in_pairs;
pub(crate) mod facet_of_pair;
pub(crate) mod gauge_interval;
mod near_generators;
mod residual;
pub(crate) mod rounded_optimum;
mod three_coefficients;
mod touching_facet;
pub(crate) mod unit_gauge_bound;
