//! Slabs around places on a face of the cube: a segment that is made wider along both axes.
//!
//! Directions of a body lie around a curve more often than not: the normals of a sweep, a cone, nearly a plane. A box
//! with sides along the axes says little of a stretch of such a curve, but a slab along its slope does.

use crate::numeric::tolerance::SLAB_ROUNDING;

/// All m + t a + s with |t| ≤ 1 and |s_k| ≤ half_k.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Slab {
    pub(super) middle: [f64; 2],
    /// a.
    pub(super) side: [f64; 2],
    pub(super) half: [f64; 2],
}

/// A range of numbers.
#[derive(Debug, Clone, Copy)]
struct Range {
    low: f64,
    high: f64,
}

impl Range {
    const NONE: Self = Self { low: f64::INFINITY, high: f64::NEG_INFINITY };

    fn with(self, center: f64, reach: f64) -> Self {
        Self { low: self.low.min(center - reach), high: self.high.max(center + reach) }
    }

    fn middle(self) -> f64 {
        (self.low + self.high) / 2.0
    }

    fn half(self) -> f64 {
        (self.high - self.low) / 2.0
    }
}

impl Slab {
    /// A single place.
    pub(super) fn of_point(place: [f64; 2]) -> Self {
        Self { middle: place, side: [0.0; 2], half: [0.0; 2] }
    }

    /// A slab around some slabs, of which there is at least one, along the slope of their middles and sides.
    pub(super) fn around(parts: &[Self]) -> Self {
        let extent = |k: usize| {
            parts.iter().fold(Range::NONE, |range, part| range.with(part.middle[k], part.side[k].abs() + part.half[k]))
        };
        let extents = [extent(0), extent(1)];
        let main = usize::from(extents[1].half() > extents[0].half());
        let other = 1 - main;
        let center = extents[main].middle();
        let slope = slope(parts, main, [center, extents[other].middle()]);
        // what is left of the other coordinate
        let rest = parts.iter().fold(Range::NONE, |range, part| {
            let across = (part.side[other] - slope * part.side[main]).abs();
            let reach = across + part.half[other] + slope.abs() * part.half[main];
            range.with(part.middle[other] - slope * (part.middle[main] - center), reach)
        });
        let mut slab = Self::default();
        slab.middle[main] = center;
        slab.middle[other] = rest.middle();
        slab.side[main] = extents[main].half();
        slab.side[other] = slope * slab.side[main];
        slab.half[main] = SLAB_ROUNDING;
        slab.half[other] = rest.half() + SLAB_ROUNDING;
        slab
    }
}

/// The slope of the other coordinate by least squares over the ends of sides, of magnitude at most 1.
fn slope(parts: &[Slab], main: usize, center: [f64; 2]) -> f64 {
    let (mut square, mut product) = (0.0, 0.0);
    for Slab { middle, side, .. } in parts {
        for sign in [1.0, -1.0] {
            let along = middle[main] + sign * side[main] - center[0];
            let across = middle[1 - main] + sign * side[1 - main] - center[1];
            square += along * along;
            product += along * across;
        }
    }
    let slope = product / square;
    if slope.is_finite() { slope.clamp(-1.0, 1.0) } else { 0.0 }
}
