//! The kernel's problem for one query: minimise h(u) = Σ |v_i · u| over the plane of directions u with u · p = 1.

use super::certify::rounded_optimum::{RoundedOptimum, compare};
use super::goal::{AtVertex, Goal};
use super::plane::in_doubles::RoundedChart;
use super::seam::kernel_query::KernelQuery;
use crate::numeric::bounded::BoundedVector;

/// Of more generators than this, a vertex is certified before the caller sees it: to prove a separating direction takes
/// a pass more than the certificate.
const PROOF_LIMIT: usize = 1024;

/// A query with what every stage needs of it: the rounded displacement and coordinates of the plane of directions.
pub(crate) struct Problem<'q> {
    pub(crate) query: &'q dyn KernelQuery,
    /// The displacement, rounded, with a bound of each coordinate's error.
    pub(crate) p: BoundedVector,
    pub(crate) chart: RoundedChart,
    pub(crate) goal: Goal,
    /// The function that is given each vertex, if the caller wants to see those of the search.
    pub(crate) at_vertex: Option<AtVertex<'q>>,
    /// A vertex at which a search among all generators has ended, and from which nothing was proved.
    pub(crate) vertex: Option<[usize; 2]>,
}

impl<'q> Problem<'q> {
    /// The problem of a query whose displacement, here in doubles, is not zero.
    pub(crate) fn new(query: &'q dyn KernelQuery, p: BoundedVector, goal: Goal) -> Self {
        Self { query, p, chart: RoundedChart::new(p.map(|c| c.value)), goal, at_vertex: None, vertex: None }
    }

    /// Whether the search among all generators has ended at this vertex already.
    pub(crate) fn is_known(&self, [first, second]: [usize; 2]) -> bool {
        self.vertex.is_some_and(|vertex| vertex == [first, second] || vertex == [second, first])
    }

    /// Whether the caller sees a vertex before the vertex is certified.
    pub(crate) fn is_seen_first(&self) -> bool {
        self.at_vertex.is_some() && self.query.len() <= PROOF_LIMIT
    }

    /// Whether the caller ends the search at the vertex of two generators. O(n).
    pub(crate) fn ends_at(&self, pair: [usize; 2]) -> bool {
        self.at_vertex.is_some_and(|at_vertex| at_vertex(self.query, &self.p, pair).is_break())
    }

    /// Whether an optimum that doubles prove answers what the caller wants to know.
    pub(crate) fn is_answered_by(&self, optimum: &RoundedOptimum) -> bool {
        compare(self.query, optimum, self.goal).is_some()
    }
}
