//! A vertex proved to be the optimum, or near it, by bounds on every rounding error.
//!
//! | file | what it proves |
//! |---|---|
//! | [`rounded_optimum`] | a vertex is the optimum, or so near to it that the gauge is between two bounds, and on which side of 1 it is |
//! | [`residual`] | what the vertex leaves of λ p, for coefficients in [−1, 1] |
//! | [`near_generators`] | the sum of the generators whose sign at the vertex is not certain |
//! | [`unit_gauge_bound`] | how thick the body is at least |

mod near_generators;
mod residual;
pub(crate) mod rounded_optimum;
pub(crate) mod unit_gauge_bound;
