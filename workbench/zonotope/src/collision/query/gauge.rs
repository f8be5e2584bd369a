//! The gauge of a displacement: the polyhedral distance that a zonotope defines.

use super::location::Location;

/// How many times a zonotope Z centred at the origin must be taken to hold a displacement p: min { t ≥ 0 : p ∈ t Z }.
#[derive(Debug, Clone, PartialEq)]
pub struct Gauge<const D: usize> {
    /// The gauge, within [`error`](Self::error); infinite where no multiple of Z holds p (a flat Z), then without
    /// error.
    pub value: f64,
    /// A bound for |`value` − gauge|.
    pub error: f64,
    /// Where p lies relative to Z, decided exactly: the gauge is at most 1 just when p is a member. With its proof.
    pub location: Location<D>,
}
