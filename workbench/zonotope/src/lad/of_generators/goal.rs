//! What a caller wants to know of a query; the less it is, the earlier the search may end.

/// What a caller wants to know.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Goal {
    /// The gauge, to the accuracy that [`compare`](super::certify::gauge_interval::compare) asks for.
    Gauge,
    /// Only whether the gauge is below, at or above 1: a separating direction ends the search.
    Location,
    /// The same with a proof: one that does without the optimum ends the search.
    Proof,
}
