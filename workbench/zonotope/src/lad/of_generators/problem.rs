//! The kernel's problem for one query: minimise h(u) = Σ |v_i · u| over the plane of directions u with u · p = 1.

use std::ops::Range;

use super::certify::gauge_interval::compare;
use super::certify::rounded_optimum::RoundedOptimum;
use super::plane::rounded_chart::RoundedChart;
use crate::lad::of_generators::generators::KernelQuery;
use crate::numeric::bounded::{Bounded, BoundedVector};
use crate::numeric::exact_sum::exact_sum;
use crate::numeric::tolerance::UNIT;

/// The sizes between which nothing overflows in the searches and underflow is below the floor of every error bound.
pub(crate) const MODERATE: Range<f64> = f64::from_bits((1023 - 200) << 52)..f64::from_bits((1023 + 200) << 52);

/// What a caller wants to know; the less it is, the earlier the search may end.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Goal {
    /// The gauge, to the accuracy of [`compare`].
    Gauge,
    /// Only whether the gauge is below, at or above 1: a separating direction ends the search.
    Location,
}

/// A query with what every stage needs of it: the rounded displacement and coordinates of the plane of directions.
pub(crate) struct Problem<'q> {
    pub(crate) query: &'q dyn KernelQuery,
    /// The displacement, rounded, with a bound of each coordinate's error.
    pub(crate) p: BoundedVector,
    pub(crate) chart: RoundedChart,
    pub(crate) goal: Goal,
}

impl<'q> Problem<'q> {
    /// The problem of a query whose displacement is not zero.
    pub(crate) fn new(query: &'q dyn KernelQuery, goal: Goal) -> Self {
        let p = query.rounded_displacement();
        Self { query, p, chart: RoundedChart::new(p.map(|c| c.value)), goal }
    }

    /// Whether an optimum that doubles prove answers what the caller wants to know.
    pub(crate) fn is_answered_by(&self, optimum: &RoundedOptimum) -> bool {
        compare(self.query, optimum, self.goal).is_some()
    }
}

/// The difference `to` − `from` in doubles, each coordinate with a bound of its error.
pub(crate) fn rounded_difference(from: [f64; 3], to: [f64; 3]) -> BoundedVector {
    [0, 1, 2].map(|i| {
        let (value, rest) = exact_sum(to[i], -from[i]);
        Bounded { value, error: if rest == 0.0 { 0.0 } else { UNIT * value.abs() } }
    })
}
