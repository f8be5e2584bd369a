//! Monotone chains through the tiling: what a vertical line through the dual arrangement becomes.
//!
//! A vertical line meets the lines of the arrangement from top to bottom; the chain starts in the top vertex of Q,
//! where every upward generator has coefficient 1, and turns one generator after the other to −1, a step of −2 v'.
//! Generators with y = 0 have vertical lines: those left of the vertical line have −1 along the whole chain, the
//! others 1.

use std::cmp::Ordering;

use crate::arrangement::DualArrangement;
use crate::arrangement::dual::Upward;
use crate::numeric::dyadic::Dyadic;
use crate::numeric::exact_sum::ExactSum;

/// The chain of a vertical line.
#[derive(Debug, Clone)]
pub(super) struct Chain {
    /// The places of the lines from top to bottom.
    pub(super) places: Vec<u32>,
    /// How many vertical lines lie left of it.
    pub(super) passed: usize,
}

/// A point `end` − `start` of space: the difference of doubles is seldom a double.
#[derive(Debug, Clone, Copy)]
pub(super) struct Target {
    pub(super) start: [f64; 3],
    pub(super) end: [f64; 3],
}

/// The edge of a chain at the height of a point.
#[derive(Debug, Clone)]
pub(super) struct Crossing {
    /// The number of the edge, from 0 at the top: the first whose lower end is not above the point.
    pub(super) edge: usize,
    /// The place of its line.
    pub(super) place: u32,
    /// How far its upper end is above the point.
    pub(super) rise: Dyadic,
    /// The upward generator's y times how far the point is right of the edge: negative when it is left of it.
    pub(super) lead: Dyadic,
}

impl Target {
    pub(super) fn opposite(self) -> Self {
        Self { start: self.end, end: self.start }
    }
}

impl Chain {
    /// The chain of a vertical line that meets the places from bottom to top in this order.
    pub(super) fn new(mut places: Vec<u32>, passed: usize) -> Self {
        places.reverse();
        Self { places, passed }
    }

    /// The left side of Q.
    pub(super) fn leftmost(dual: &DualArrangement) -> Self {
        Self::new(dual.lines().order_before_all(), 0)
    }

    /// The right side of Q.
    pub(super) fn rightmost(dual: &DualArrangement) -> Self {
        Self::new(dual.lines().order_after_all(), dual.level.len())
    }

    /// Every generator other than zero with its sign at a corner, numbered from the top.
    pub(super) fn signs<'a>(
        &'a self,
        corner: usize,
        dual: &'a DualArrangement,
    ) -> impl Iterator<Item = (&'a Upward, i8)> {
        let turned = |turned: bool| if turned { -1 } else { 1 };
        let slanted = self.places.iter().enumerate();
        let slanted = slanted.map(move |(edge, &place)| (&dual.slanted[place as usize], turned(edge < corner)));
        let level = dual.level.iter().enumerate().map(move |(i, upward)| (upward, turned(i < self.passed)));
        slanted.chain(level).chain(dual.poles.iter().map(|pole| (pole, 1)))
    }

    /// A coordinate of a corner minus that of a point, exactly. O(n).
    pub(super) fn offset(&self, corner: usize, axis: usize, target: &Target, dual: &DualArrangement) -> Dyadic {
        let mut sum = ExactSum::default();
        for (upward, sign) in self.signs(corner, dual) {
            sum.add(f64::from(sign) * upward.vector[axis]);
        }
        sum.add(target.start[axis]);
        sum.add(-target.end[axis]);
        sum.value()
    }

    /// The edge at the height of a point; `None` when the chain is all above or all below it. O(n).
    pub(super) fn crossing(&self, target: &Target, dual: &DualArrangement) -> Option<Crossing> {
        let height = |edge: usize| dual.slanted[self.places[edge] as usize].vector[1];
        let top = self.offset(0, 1, target, dual);
        if top.sign() == Ordering::Less {
            return None;
        }
        let mut edge = self.certainly_above(top.to_f64(), height);
        let mut rise = if edge == 0 { top } else { self.offset(edge, 1, target, dual) };
        while edge < self.places.len() {
            let lower = &rise - &Dyadic::from_f64(height(edge)).scaled(1);
            if lower.sign() != Ordering::Greater {
                return Some(self.crossing_at(edge, rise, target, dual));
            }
            (edge, rise) = (edge + 1, lower);
        }
        None
    }

    /// A number of edges whose lower ends are above a point for certain, the chain's top being `rise` above it.
    fn certainly_above(&self, rise: f64, height: impl Fn(usize) -> f64) -> usize {
        let length: f64 = (0..self.places.len()).map(|edge| 2.0 * height(edge)).sum();
        // one rounding an edge, each of at most the half unit of the largest intermediate value, and those of the bound
        // itself
        let error = (self.places.len() + 16) as f64 * f64::EPSILON * (rise.abs() + length) + f64::MIN_POSITIVE;
        let mut left = rise;
        let below = |edge: &usize| {
            left -= 2.0 * height(*edge);
            let is_certain = left > error;
            !is_certain
        };
        (0..self.places.len()).find(below).unwrap_or(self.places.len())
    }

    fn crossing_at(&self, edge: usize, rise: Dyadic, target: &Target, dual: &DualArrangement) -> Crossing {
        let place = self.places[edge];
        let [x, y, _] = dual.slanted[place as usize].vector.map(Dyadic::from_f64);
        let lead = &x * &rise - self.offset(edge, 0, target, dual) * y;
        Crossing { edge, place, rise, lead }
    }
}
