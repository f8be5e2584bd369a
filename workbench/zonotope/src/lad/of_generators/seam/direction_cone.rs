//! A cone of directions, and whether a direction is in it.
//!
//! A cell is a cone of directions in space and not a box in the coordinates of the plane u · p = 1. Whether v · u
//! keeps its sign in a cone is decided by products of v with three vectors, without rotating v or computing its line,
//! so the rounding errors of the decision are those of dot products of input vectors. An ellipse follows the shape of
//! the guess, which is long and thin where generators are nearly coplanar; a box around it would be crossed by many
//! times as many lines.

use crate::numeric::bounded::{self, Bounded, BoundedVector};
use crate::numeric::dyadic::Dyadic;
use crate::numeric::exact_linear::{self, ExactVector};
use crate::numeric::linear::{dot, euclidean_norm};
use crate::numeric::scaling::power_of_two_below;
use crate::numeric::tolerance::THIRTY_ROUNDINGS;

/// The positive multiples of all directions of an ellipse, or of a ball if the cone has no axes.
///
/// The ellipse is center + x axes_0 + y axes_1, x² + y² ≤ 1; to it belong all directions that are no farther from it
/// than `ball`.
#[derive(Debug, Clone, Copy)]
pub(crate) struct DirectionCone {
    pub(crate) center: [f64; 3],
    pub(crate) axes: Option<[[f64; 3]; 2]>,
    pub(crate) ball: f64,
}

impl DirectionCone {
    /// The centre, rounded to about the digits that tell it from the rest of the cell, so that exact arithmetic
    /// around it works on short numbers; not finite where that overflows.
    pub(crate) fn coarse_center(&self) -> [f64; 3] {
        let size = self.size();
        // adding a number far above a power of two and taking it away again rounds to multiples of that power
        let step = power_of_two_below(size);
        let far = 1.5 / f64::EPSILON * step;
        self.center.map(|c| (c + far) - far)
    }

    /// A wider cell: where a vector that is off by `relative_error` of its length keeps its sign in it, the exact
    /// vector keeps that sign in the cell itself.
    pub(crate) fn widened(&self, relative_error: f64) -> Self {
        if relative_error == 0.0 {
            return *self;
        }
        let size =
            euclidean_norm(&self.center) + self.axes.iter().flatten().map(euclidean_norm).sum::<f64>() + self.ball;
        Self { ball: self.ball + 2.0 * relative_error * size, ..*self }
    }

    /// The cell with a ball of at least some part of the length of its centre.
    pub(crate) fn at_least(self, angle: f64) -> Self {
        Self { ball: self.ball.max(angle * euclidean_norm(&self.center)), ..self }
    }

    fn size(&self) -> f64 {
        self.axes.iter().flatten().map(euclidean_norm).fold(self.ball, f64::max)
    }

    /// Whether no coordinate overflowed.
    pub(crate) fn is_finite(&self) -> bool {
        let axes = self.axes.iter().flat_map(|axes| axes.as_flattened());
        self.center.iter().chain(axes).chain([&self.ball]).all(|c| c.is_finite())
    }

    /// v · center. For every generator that a pass does not report, its sign is the sign of v · u throughout the cell.
    #[inline(always)]
    pub(crate) fn value(&self, [x, y, z]: &[f64; 3]) -> f64 {
        let u = &self.center;
        x * u[0] + y * u[1] + z * u[2]
    }

    /// The cell of all directions within the rounding error of one direction.
    pub(crate) fn around(direction: &BoundedVector) -> Self {
        let ball = euclidean_norm(&direction.map(|c| c.error)) * THIRTY_ROUNDINGS;
        Self { center: direction.map(|c| c.value), axes: None, ball }
    }

    /// A point of the ellipse near a direction, as multiples of the axes. The direction is scaled such that its
    /// product with p is `own`, that of the centre; before, the product is `along`.
    fn nearest(&self, direction: [f64; 3], along: f64, own: f64) -> [f64; 2] {
        let Some([a, b]) = self.axes else { return [0.0; 2] };
        let off = [0, 1, 2].map(|k| direction[k] * (own / along) - self.center[k]);
        let is_swapped = dot(&b, &b) > dot(&a, &a);
        let [long, short] = if is_swapped { [b, a] } else { [a, b] };
        // the ellipse may be so thin that rounding makes its axes parallel
        let part = dot(&long, &short) / dot(&long, &long);
        let across = [0, 1, 2].map(|k| short[k] - part * long[k]);
        let y = dot(&off, &across) / dot(&across, &across);
        let y = if y.is_finite() { y } else { 0.0 };
        let x = dot(&off, &long) / dot(&long, &long) - y * part;
        let size = (x * x + y * y).sqrt().max(1.0) * THIRTY_ROUNDINGS;
        let [x, y] = if x.is_finite() && size.is_finite() { [x / size, y / size] } else { [0.0; 2] };
        if is_swapped { [y, x] } else { [x, y] }
    }

    /// Whether a direction u is certainly in the cell, when scaled such that u · p is center · p.
    pub(crate) fn contains(&self, u: &BoundedVector, p: &BoundedVector) -> bool {
        let center = bounded::exact(self.center);
        let (along, own) = (dot(u, p), dot(&center, p));
        let mut nearest = center;
        if let Some(axes) = self.axes {
            for (x, axis) in self.nearest(u.map(|c| c.value), along.value, own.value).into_iter().zip(axes) {
                nearest = [0, 1, 2].map(|k| nearest[k] + Bounded::exact(x) * Bounded::exact(axis[k]));
            }
        }
        let off = [0, 1, 2].map(|k| u[k] * own - nearest[k] * along);
        let ball = along * Bounded::exact(self.ball);
        along.is_positive() && own.is_positive() && dot(&off, &off).is_within(ball * ball)
    }

    /// Whether a direction u with u · p > 0 is in the cell, when scaled such that u · p is center · p.
    pub(crate) fn contains_exactly(&self, u: &ExactVector, p: &ExactVector) -> bool {
        if !self.is_finite() {
            return false;
        }
        let center = exact_linear::exact(self.center);
        let (along, own) = (exact_linear::dot(u, p), exact_linear::dot(&center, p));
        let mut nearest = center;
        if let Some(axes) = self.axes {
            let direction = u.each_ref().map(|c| c.ratio(&along));
            for (x, axis) in self.nearest(direction, 1.0, own.to_f64()).into_iter().zip(axes) {
                nearest = exact_linear::sum(
                    &nearest,
                    &exact_linear::multiple(&Dyadic::from_f64(x), &exact_linear::exact(axis)),
                );
            }
        }
        let off = exact_linear::difference(&exact_linear::multiple(&own, u), &exact_linear::multiple(&along, &nearest));
        let ball = &along * &Dyadic::from_f64(self.ball);
        along.sign().is_gt() && own.sign().is_gt() && exact_linear::dot(&off, &off) <= &ball * &ball
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const P: [f64; 3] = [0.0, 0.0, 1.0];

    fn holds(cell: &DirectionCone, u: [f64; 3]) -> [bool; 2] {
        [
            cell.contains(&bounded::exact(u), &bounded::exact(P)),
            cell.contains_exactly(&exact_linear::exact(u), &exact_linear::exact(P)),
        ]
    }

    #[test]
    fn an_ellipse_without_a_second_dimension_is_a_segment() {
        for axes in
            [[[1.0, 1.0, 0.0], [0.5, 0.5, 0.0]], [[0.0; 3], [2.0, 2.0, 0.0]], [[1.0, 1.0, 0.0], [1e-30, 0.0, 0.0]]]
        {
            let cell = DirectionCone { center: P, axes: Some(axes), ball: 1e-3 };
            assert_eq!(holds(&cell, [0.9, 0.9, 1.0]), [true; 2], "{axes:?}");
            assert_eq!(holds(&cell, [1.8, 1.8, 2.0]), [true; 2], "{axes:?}");
            assert_eq!(holds(&cell, [0.5, 0.6, 1.0]), [false; 2], "{axes:?}");
        }
        let point = DirectionCone { center: P, axes: Some([[0.0; 3]; 2]), ball: 1e-3 };
        assert_eq!(holds(&point, P), [true; 2]);
        let overflown =
            DirectionCone { center: P, axes: Some([[f64::INFINITY, 0.0, 0.0], [0.0, 1.0, 0.0]]), ball: 1e-3 };
        assert_eq!(holds(&overflown, P), [false; 2]);
    }

    #[test]
    fn the_coarse_centre_is_near_and_short() {
        let cell = DirectionCone { center: [1.0 / 3.0, -0.1, 1e-9], axes: None, ball: 1e-3 };
        let coarse = cell.coarse_center();
        for (c, own) in coarse.iter().zip(cell.center) {
            assert!((c - own).abs() <= 1e-3 && (c * 1024.0).fract() == 0.0, "{coarse:?}");
        }
        let fine = DirectionCone { ball: 1e-20, ..cell }.coarse_center();
        assert!(fine.iter().zip(cell.center).all(|(c, own)| (c - own).abs() <= 1e-20), "{fine:?}");
    }
}
