//! The kernel's problem for one query: minimise h(u) = Σ |v_i · u| over the plane of directions u with u · p = 1.

use super::certify::gauge_interval::compare;
use super::certify::rounded_optimum::RoundedOptimum;
use super::goal::Goal;
use super::plane::rounded_chart::RoundedChart;
use crate::lad::of_generators::generators::KernelQuery;
use crate::numeric::bounded::BoundedVector;

/// A query with what every stage needs of it: the rounded displacement and coordinates of the plane of directions.
pub(crate) struct Problem<'q> {
    pub(crate) query: &'q dyn KernelQuery,
    /// The displacement, rounded, with a bound of each coordinate's error.
    pub(crate) p: BoundedVector,
    pub(crate) chart: RoundedChart,
    pub(crate) goal: Goal,
}

impl<'q> Problem<'q> {
    /// The problem of a query whose displacement, here in doubles, is not zero.
    pub(crate) fn new(query: &'q dyn KernelQuery, p: BoundedVector, goal: Goal) -> Self {
        Self { query, p, chart: RoundedChart::new(p.map(|c| c.value)), goal }
    }

    /// Whether an optimum that doubles prove answers what the caller wants to know.
    pub(crate) fn is_answered_by(&self, optimum: &RoundedOptimum) -> bool {
        compare(self.query, optimum, self.goal).is_some()
    }
}
