//! What a caller wants to know of a query; the less it is, the earlier the search may end.

use super::told::Told;
use crate::numeric::bounded::BoundedVector;
use crate::zonotope::query::Query;

/// The proof that a caller finds at a vertex, and that ends the search there: from the query, its displacement in
/// doubles and the two generators of the vertex.
pub(crate) type AtVertex = fn(&Query<'_, 3>, &BoundedVector, [usize; 2]) -> Option<Told>;

/// What a caller wants to know.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Goal {
    /// The gauge, to the accuracy that [`compare`](super::certify::gauge_interval::compare) asks for.
    Gauge,
    /// Only whether the gauge is below, at or above 1: a separating direction ends the search.
    Location,
    /// The same with a proof: one that does without the optimum ends the search.
    Proof(AtVertex),
}

impl Goal {
    /// Whether the gauge is asked for.
    pub(crate) fn is_gauge(self) -> bool {
        matches!(self, Self::Gauge)
    }

    /// The search for a proof at a vertex, if a proof is all that is asked.
    pub(crate) fn at_vertex(self) -> Option<AtVertex> {
        match self {
            Self::Proof(at_vertex) => Some(at_vertex),
            Self::Gauge | Self::Location => None,
        }
    }
}
