//! What a caller wants to know of a query; the less it is, the earlier the search may end.

use std::ops::ControlFlow;

use super::seam::kernel_query::KernelQuery;
use crate::numeric::bounded::BoundedVector;

/// What a caller does with a vertex that a search finds: it ends the search or lets it go on. The function is given the
/// query, its displacement in doubles and the two generators of the vertex; of a flat body, the query is that of the
/// prism over it.
pub(crate) type AtVertex<'a> = &'a dyn Fn(&dyn KernelQuery, &BoundedVector, [usize; 2]) -> ControlFlow<()>;

/// What a caller wants to know.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Goal {
    /// The gauge, to the accuracy that [`compare`](super::certify::gauge_interval::compare) asks for.
    Gauge,
    /// Only whether the gauge is below, at or above 1: a separating direction ends the search.
    Location,
}
