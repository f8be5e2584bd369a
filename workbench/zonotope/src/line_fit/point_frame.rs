//! The frame in which points are fitted: coordinates about 1 in magnitude, measured from the middle of most points.
//!
//! A line y = s x + t of the input is y' = s' x' + t' in the frame, and weighted deviations are in proportion, so the
//! best lines are the same. Far from the origin, or where x and y differ by orders of magnitude, all lines of the dual
//! plane would be nearly parallel, and doubles could not tell where they cross.

use fearless_simd::{Simd, dispatch, f64x8, prelude::*};

use crate::numeric::double_double::BoundedDoubleDouble;
use crate::numeric::dyadic::Dyadic;
use crate::numeric::exact_sum::exact_sum;
use crate::numeric::lanes::level::level;
use crate::numeric::lanes::octet::{self, Octet, total};
use crate::numeric::lanes::rows::Rows;
use crate::numeric::scaling::{PowerOfTwo, binary_exponent, scaled_difference};
use crate::numeric::short_dyadic::ShortDyadic;
use crate::numeric::weighted_median::weighted_median;

/// Number of points whose middle is the origin of the frame.
const ORIGIN_SAMPLE: usize = 63;

/// The least and the largest of x, y and the weight over some points.
#[derive(Debug, Clone, Copy)]
pub(super) struct Bounds {
    least: [f64; 3],
    largest: [f64; 3],
}

/// A coordinate in the frame: (c − origin) · 2^−exponent, of magnitude at most 1.
#[derive(Debug, Clone, Copy)]
pub(super) struct Axis {
    origin: f64,
    exponent: i64,
    /// The factor 2^−`coarse`, with which no difference overflows, and the one that makes up the rest.
    factors: [PowerOfTwo; 2],
    /// The origin times the first factor.
    scaled_origin: f64,
}

/// The frame of some points.
#[derive(Debug, Clone, Copy)]
pub(super) struct PointFrame {
    pub(super) x: Axis,
    pub(super) y: Axis,
    weight_exponent: i64,
    weight_factor: PowerOfTwo,
}

impl Bounds {
    /// The bounds of rows (x, y, weight); `None` if a number is not finite or a weight is negative. One pass.
    pub(super) fn of(points: &[[f64; 3]]) -> Option<Self> {
        let first = points.first()?;
        let (octets, rest) = Rows::new(points).octets().whole_and_rest();
        let mut bounds = Self { least: *first, largest: *first };
        let mut zero = 0.0;
        if octets.len() > 0 {
            let (least, largest, zeros) = dispatch!(level(), simd => bounds_of_octets(simd, points));
            (bounds, zero) = (Self { least, largest }, zeros);
        }
        for row in rest {
            for (axis, &c) in row.iter().enumerate() {
                zero += 0.0 * c;
                bounds.least[axis] = if c < bounds.least[axis] { c } else { bounds.least[axis] };
                bounds.largest[axis] = if c > bounds.largest[axis] { c } else { bounds.largest[axis] };
            }
        }
        (zero == 0.0 && bounds.least[2] >= 0.0).then_some(bounds)
    }
}

/// The bounds of whole octets, and the sum of zero times each number: zero where all are finite.
#[inline(always)]
fn bounds_of_octets<S: Simd>(simd: S, points: &[[f64; 3]]) -> ([f64; 3], [f64; 3], f64) {
    let (octets, _) = Rows::new(points).octets().whole_and_rest();
    let mut least = octets.load(simd, 0);
    let mut largest = least;
    let mut zeros = f64x8::splat(simd, 0.0);
    for k in 0..octets.len() {
        let v = octets.load(simd, k);
        for axis in 0..3 {
            least[axis] = v[axis].simd_lt(least[axis]).select(v[axis], least[axis]);
            largest[axis] = v[axis].simd_gt(largest[axis]).select(v[axis], largest[axis]);
        }
        zeros += (v[0] * 0.0 + v[1] * 0.0) + v[2] * 0.0;
    }
    let least = [-octet::largest(-least[0]), -octet::largest(-least[1]), -octet::largest(-least[2])];
    (least, [octet::largest(largest[0]), octet::largest(largest[1]), octet::largest(largest[2])], total(zeros))
}

impl Axis {
    fn new(least: f64, largest: f64, origin: f64) -> Self {
        let magnitude = least.abs().max(largest.abs());
        // one more than the exponent of the largest coordinate, so that no difference of two overflows
        let coarse = binary_exponent(magnitude).map_or(0, |e| i64::from(e) + 2);
        let spread = [least, largest].map(|end| scaled_difference(end, origin, -coarse).abs());
        let fine = binary_exponent(spread[0].max(spread[1])).map_or(0, |e| i64::from(e) + 1);
        let factors = [-coarse, -fine].map(PowerOfTwo::new);
        Self { origin, exponent: coarse + fine, factors, scaled_origin: factors[0].apply(origin) }
    }

    /// The coordinate in the frame, rounded once.
    #[inline(always)]
    pub(super) fn rounded(&self, c: f64) -> f64 {
        self.factors[1].apply(self.factors[0].apply(c) - self.scaled_origin)
    }

    #[inline(always)]
    fn rounded_octet<S: Simd>(&self, c: f64x8<S>) -> f64x8<S> {
        self.factors[1].apply_to_octet(self.factors[0].apply_to_octet(c) - self.scaled_origin)
    }

    /// The coordinate in the frame, exactly.
    pub(super) fn exact(&self, c: f64) -> Dyadic {
        (Dyadic::from_f64(c) - Dyadic::from_f64(self.origin)).scaled(-self.exponent)
    }

    /// The same, if it is short.
    #[inline]
    pub(super) fn short(&self, c: f64) -> Option<ShortDyadic> {
        let off = ShortDyadic::from_f64(c).plus(ShortDyadic::from_f64(-self.origin))?;
        Some(off.scaled(-self.exponent))
    }

    /// The same as two doubles, if scaling the coordinate did not round it.
    #[inline]
    pub(super) fn pair(&self, c: f64) -> Option<BoundedDoubleDouble> {
        let scaled = self.factors[0].apply(c);
        let is_exact = |scaled: f64, c: f64| c == 0.0 || scaled.abs() >= f64::MIN_POSITIVE;
        if !is_exact(scaled, c) || !is_exact(self.scaled_origin, self.origin) {
            return None;
        }
        let (high, low) = exact_sum(scaled, -self.scaled_origin);
        Some(BoundedDoubleDouble::of_parts(self.factors[1].apply(high), self.factors[1].apply(low), 0.0))
    }
}

impl PointFrame {
    /// The frame of points with some bounds.
    pub(super) fn new(points: &[[f64; 3]], bounds: &Bounds) -> Self {
        let step = points.len() / ORIGIN_SAMPLE + 1;
        let middle = |axis: usize| {
            let values: Vec<f64> = points.iter().step_by(step).map(|point| point[axis]).collect();
            let found = weighted_median(&values, &vec![1.0; values.len()], values.len() as f64 / 2.0);
            found.map_or(0.0, |found| values[found])
        };
        let Bounds { least, largest } = bounds;
        let weight_exponent = binary_exponent(largest[2]).map_or(0, |e| i64::from(e) + 1);
        Self {
            x: Axis::new(least[0], largest[0], middle(0)),
            y: Axis::new(least[1], largest[1], middle(1)),
            weight_exponent,
            weight_factor: PowerOfTwo::new(-weight_exponent),
        }
    }

    /// The weight in the frame, which is below 1.
    #[inline(always)]
    pub(super) fn weight(&self, w: f64) -> f64 {
        self.weight_factor.apply(w)
    }

    /// The weight in the frame, exactly.
    pub(super) fn exact_weight(&self, w: f64) -> Dyadic {
        Dyadic::from_f64(w).scaled(-self.weight_exponent)
    }

    /// The sum of w' x' and of w' over some points, given those of w x and of w.
    pub(super) fn moved_sum(&self, of_x: Dyadic, of_weight: Dyadic) -> [Dyadic; 2] {
        let moved = of_x - &Dyadic::from_f64(self.x.origin) * &of_weight;
        [moved.scaled(-self.x.exponent - self.weight_exponent), of_weight.scaled(-self.weight_exponent)]
    }

    /// The coefficients of w' (x' s' + t' − y') for a point.
    #[inline(always)]
    pub(super) fn row(&self, &[x, y, w]: &[f64; 3]) -> [f64; 3] {
        let weight = self.weight(w);
        [self.x.rounded(x) * weight, weight, -self.y.rounded(y) * weight]
    }

    /// The same for eight points.
    #[inline(always)]
    pub(super) fn rows<S: Simd>(&self, [x, y, w]: &Octet<S>) -> Octet<S> {
        let weight = self.weight_factor.apply_to_octet(*w);
        [self.x.rounded_octet(*x) * weight, weight, -self.y.rounded_octet(*y) * weight]
    }
}
