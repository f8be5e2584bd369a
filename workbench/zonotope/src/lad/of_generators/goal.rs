//! The goal of a caller with a query; the less it asks for, the earlier the search may end.

use std::ops::ControlFlow;

use super::seam::kernel_query::KernelQuery;
use crate::numeric::bounded::BoundedVector;

/// The response of a caller to a vertex that a search finds: the search ends or goes on. The function is given the
/// query, its displacement in doubles and the two generators of the vertex; of a flat body, the query is that of the
/// prism over it.
pub(crate) type AtVertex<'a> = &'a dyn Fn(&dyn KernelQuery, &BoundedVector, [usize; 2]) -> ControlFlow<()>;

/// The goal of a caller.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Goal {
    /// The gauge, to the accuracy that [`compare`](super::certify::rounded_optimum::compare) asks for.
    Gauge,
    /// Only whether the gauge is below, at or above 1: a separating direction ends the search.
    Location,
}
