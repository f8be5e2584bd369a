//! The end of a search by a growing polytope.

use crate::collision::distance::Penetration;
use crate::numeric::tolerance::PRODUCT_UNDERFLOW;

/// By how much the bounds may differ, in terms of the upper one.
pub const ACCURACY: f64 = 0.01;

/// The most vertices that the polytope gets in doubles or in pairs: a ball around p takes some three hundred for a
/// hundredth.
pub(super) const VERTEX_LIMIT: usize = 1 << 11;

/// Whether the depth is so far below the unit that doubles may not tell its bounds apart.
pub(super) fn is_too_short(depth: &Penetration<3>) -> bool {
    depth.upper < PRODUCT_UNDERFLOW
}

/// Whether the bounds are as near to each other as they must be.
pub(super) fn is_settled(depth: &Penetration<3>) -> bool {
    depth.upper.is_finite() && depth.is_within(ACCURACY)
}
