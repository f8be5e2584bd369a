//! A vertex proved to be the optimum, or near it, by bounds on every rounding error.

pub(crate) mod facet_coefficients;
pub(crate) mod gauge_interval;
pub(crate) mod rounded_optimum;
pub(crate) mod unit_gauge_bound;
