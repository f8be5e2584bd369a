//! Where the projection p_0 of a point lies relative to Q, the projection of the zonotope.

use std::cmp::Ordering;

use super::chain::{Chain, Target};
use crate::arrangement::DualArrangement;

/// Where p_0 lies, and the side of Q that says so.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Shadow {
    /// Not in Q: a level direction u with u · p > h(u).
    Outside([f64; 3]),
    /// On the boundary of Q; everywhere when Q is a segment.
    Boundary,
    /// In the interior of Q.
    Interior,
}

impl Shadow {
    /// Compares p_0 with the two sides of Q, the first and the last separator. Some line must not be vertical. O(n).
    pub(super) fn of(target: &Target, dual: &DualArrangement) -> Self {
        let (left, right) = (Chain::leftmost(dual), Chain::rightmost(dual));
        let [above, below] = [0, left.places.len()].map(|corner| left.offset(corner, 1, target, dual).sign());
        let (Some(left), Some(right)) = (left.crossing(target, dual), right.crossing(target, dual)) else {
            return Self::Outside([0.0, if above == Ordering::Less { 1.0 } else { -1.0 }, 0.0]);
        };
        let [x, y, _] = dual.slanted[left.place as usize].vector;
        let [a, b, _] = dual.slanted[right.place as usize].vector;
        match (left.lead.sign(), right.lead.sign()) {
            (Ordering::Less, _) => Self::Outside([-y, x, 0.0]),
            (_, Ordering::Greater) => Self::Outside([b, -a, 0.0]),
            (Ordering::Greater, Ordering::Less) if above.is_gt() && below.is_lt() => Self::Interior,
            _ => Self::Boundary,
        }
    }
}
