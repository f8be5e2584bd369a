//! A cone of directions, and which generators are orthogonal to none of them.

use wide::f64x2;

use crate::numeric::bounded::{self, Bounded, BoundedVector};
use crate::numeric::dyadic::Dyadic;
use crate::numeric::exact_linear::{self, ExactVector};
use crate::numeric::exact_sum::exact_sum;
use crate::numeric::linear::dot;
use crate::numeric::tolerance::UNIT;

/// Covers the underflow of a dot product of doubles.
const UNDERFLOW_FLOOR: f64 = f64::from_bits((1023 - 1000) << 52);

/// A longer vector's square does not underflow.
const LEAST_SQUARABLE: f64 = f64::from_bits((1023 - 500) << 52);

/// How much wider a cell is where the optimum seemed to be outside of it.
const BALL_STRETCH: f64 = 8.0;

/// Generators read before their sums join the total: their crossings are gathered in one word.
const BLOCK: usize = 64;

/// What rounding adds to a cell, in terms of its centre, and what makes up for it in products of a few rounded terms.
const CONE_ROUNDING: f64 = 8.0 * UNIT;
const CONE_SLACK: f64 = 1.0 + 32.0 * UNIT;

/// (a + b)² ≤ (1 + SQUARE_SPLIT) a² + (1 + 1 / SQUARE_SPLIT) b².
const SQUARE_SPLIT: f64 = 1.0 / 1024.0;

/// All positive multiples of the directions of an ellipse, or of a ball if it has no axes.
///
/// The ellipse is center + x axes_0 + y axes_1, x² + y² ≤ 1; with it all that is no farther from it than `ball`.
#[derive(Debug, Clone, Copy)]
pub(crate) struct DirectionCone {
    pub(crate) center: [f64; 3],
    pub(crate) axes: Option<[[f64; 3]; 2]>,
    pub(crate) ball: f64,
}

/// Σ sign · v over generators whose sign is fixed throughout a cell, in doubles.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct FixedSum {
    pub(crate) sum: [f64; 3],
    /// At least Σ |v| over all generators read.
    pub(crate) magnitude: f64,
    /// A bound for the error of each coordinate of the sum.
    pub(crate) error: f64,
}

impl FixedSum {
    pub(crate) fn bounded(&self) -> BoundedVector {
        self.sum.map(|value| Bounded { value, error: self.error })
    }

    /// Both sums together.
    pub(crate) fn plus(&self, other: &Self) -> Self {
        let sum = [0, 1, 2].map(|k| self.sum[k] + other.sum[k]);
        let magnitude = self.magnitude + other.magnitude;
        Self { sum, magnitude, error: self.error + other.error + 4.0 * UNIT * magnitude }
    }
}

impl DirectionCone {
    /// One pass: sums up the generators that are certainly orthogonal to no direction of the cell, and reports the others.
    ///
    /// The sign of v · center is that throughout the cell if |v · center| exceeds |v| ball + sqrt((v · axes_0)² + (v · axes_1)²). Each
    /// product with v is off by at most 3 u |v| times the other factor and an underflow, which a wider ball makes up for.
    pub(crate) fn split(&self, generators: &[[f64; 3]], report: impl FnMut(usize)) -> FixedSum {
        match self.axes {
            None => split(&WideCone::<0>::new(self, [], 1.0), generators, report),
            Some(axes) => split(&WideCone::<2>::new(self, axes, 1.0 + 1.0 / SQUARE_SPLIT), generators, report),
        }
    }

    /// A vector near the centre, in terms of the cell's size, with no more digits than that takes; not finite where that overflows.
    pub(crate) fn coarse_center(&self) -> [f64; 3] {
        let size = self.size();
        // the power of two not above the size; adding one far above rounds to its multiples
        let step = f64::from_bits(size.to_bits() & (0x7ff << 52));
        let far = 1.5 / f64::EPSILON * step;
        self.center.map(|c| (c + far) - far)
    }

    /// A cell in which the sign of a vector that is off by this part of its length is that of the exact vector in the cell itself.
    pub(crate) fn widened(&self, relative_error: f64) -> Self {
        if relative_error == 0.0 {
            return *self;
        }
        let size = length(&self.center) + self.axes.iter().flatten().map(length).sum::<f64>() + self.ball;
        Self { ball: self.ball + 2.0 * relative_error * size, ..*self }
    }

    /// A ball around another direction, in terms of its size wider than the cell.
    pub(crate) fn around_other(&self, center: [f64; 3]) -> Self {
        let ball = BALL_STRETCH * self.size() * (length(&center) / length(&self.center));
        Self { center, axes: None, ball }
    }

    fn size(&self) -> f64 {
        self.axes.iter().flatten().map(length).fold(self.ball, f64::max)
    }

    /// Whether no coordinate overflowed.
    pub(crate) fn is_finite(&self) -> bool {
        let axes = self.axes.iter().flat_map(|axes| axes.as_flattened());
        self.center.iter().chain(axes).chain([&self.ball]).all(|c| c.is_finite())
    }

    /// v · center; its sign is that throughout the cell for every generator that is not reported.
    #[inline(always)]
    pub(crate) fn value(&self, [x, y, z]: &[f64; 3]) -> f64 {
        let u = &self.center;
        x * u[0] + y * u[1] + z * u[2]
    }

    /// The cell of the directions that are one direction but for rounding.
    pub(crate) fn around(direction: &BoundedVector) -> Self {
        let ball = length(&direction.map(|c| c.error)) * CONE_SLACK;
        Self { center: direction.map(|c| c.value), axes: None, ball }
    }

    /// A point of the ellipse near a direction that is scaled such that its product with p is that of the centre; as multiples of the axes.
    fn nearest(&self, direction: [f64; 3], along: f64, own: f64) -> [f64; 2] {
        let Some([a, b]) = self.axes else { return [0.0; 2] };
        let off = [0, 1, 2].map(|k| direction[k] * (own / along) - self.center[k]);
        let is_swapped = dot(&b, &b) > dot(&a, &a);
        let [long, short] = if is_swapped { [b, a] } else { [a, b] };
        // the ellipse may be so thin that its axes seem to be parallel
        let part = dot(&long, &short) / dot(&long, &long);
        let across = [0, 1, 2].map(|k| short[k] - part * long[k]);
        let y = dot(&off, &across) / dot(&across, &across);
        let y = if y.is_finite() { y } else { 0.0 };
        let x = dot(&off, &long) / dot(&long, &long) - y * part;
        let size = (x * x + y * y).sqrt().max(1.0) * CONE_SLACK;
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

fn length(a: &[f64; 3]) -> f64 {
    dot(a, a).sqrt()
}

/// A vector in the order in which the coordinates of two vectors lie in memory: x y, z x, y z.
type Twice = [f64x2; 3];

fn twice([x, y, z]: [f64; 3]) -> Twice {
    [[x, y], [z, x], [y, z]].map(f64x2::new)
}

/// Either of two vectors times the same vector.
#[inline(always)]
fn products(pair: &Twice, other: &Twice) -> f64x2 {
    let [first, middle, last] = [pair[0] * other[0], pair[1] * other[1], pair[2] * other[2]];
    let [ends, others] = f64x2::transpose([first, last]);
    ends + others + middle
}

/// A cell of `AXES` axes in the order of memory, with the square of its ball.
struct WideCone<const AXES: usize> {
    center: Twice,
    axes: [Twice; AXES],
    square: f64x2,
}

impl<const AXES: usize> WideCone<AXES> {
    fn new(cell: &DirectionCone, axes: [[f64; 3]; AXES], factor: f64) -> Self {
        let size = length(&cell.center) + axes.iter().map(length).sum::<f64>() + cell.ball;
        let ball = (cell.ball + CONE_ROUNDING * size) * CONE_SLACK;
        let wider = (1.0 + SQUARE_SPLIT).sqrt() * CONE_SLACK;
        Self {
            center: twice(cell.center),
            axes: axes.map(|axis| twice(axis.map(|c| c * wider))),
            square: f64x2::splat(ball * ball * factor * CONE_SLACK),
        }
    }
}

/// Sums in the order of memory.
#[derive(Default)]
struct Sums {
    sum: Twice,
    /// Σ |v|².
    squares: f64x2,
}

impl Sums {
    /// Adds two vectors with the signs of their values; a bit for each that certainly misses the cell, and one for each that has a minus.
    #[inline(always)]
    fn read<const AXES: usize>(&mut self, cell: &WideCone<AXES>, pair: &Twice) -> [u64; 2] {
        let values = products(pair, &cell.center);
        let squares = products(pair, pair);
        self.squares += squares;
        let mut reach = squares * cell.square + f64x2::splat(UNDERFLOW_FLOOR);
        for axis in &cell.axes {
            let value = products(pair, axis);
            reach += value * value;
        }
        let signs = values & f64x2::splat(-0.0);
        let [first, second] = f64x2::transpose([signs, signs]);
        self.sum[0] += pair[0] ^ first;
        self.sum[1] += pair[1] ^ signs;
        self.sum[2] += pair[2] ^ second;
        // NaN does not miss it
        let misses = (values * values).simd_gt(reach).to_bitmask();
        [u64::from(misses), u64::from(values.to_bitmask())]
    }

    /// The sum, and what bounds the sum of the lengths.
    fn total(&self, count: usize) -> ([f64; 3], f64) {
        let [[x, y], [z, other_x], [other_y, other_z]] = self.sum.map(f64x2::to_array);
        let size = (self.squares.reduce_add() * count as f64).sqrt() + count as f64 * LEAST_SQUARABLE;
        ([x + other_x, y + other_y, z + other_z], size)
    }
}

fn split<const AXES: usize>(cell: &WideCone<AXES>, generators: &[[f64; 3]], mut report: impl FnMut(usize)) -> FixedSum {
    // the sums of blocks, and what their rounding leaves behind
    let (mut total, mut rest) = ([0.0; 3], [0.0; 3]);
    let (mut magnitude, mut error) = (0.0, 0.0);
    for (number, block) in generators.chunks(BLOCK).enumerate() {
        let mut sums = Sums::default();
        let mut taken = [0.0; 3];
        // the bits of a pair go in at the top and move down as others follow: no shift depends on the place
        let (mut misses, mut signs) = (0, 0);
        let (pairs, last) = block.as_chunks::<2>();
        for pair in pairs {
            let [own, minus] = sums.read(cell, &wide(*pair));
            misses = misses >> 2 | own << (BLOCK - 2);
            signs = signs >> 2 | minus << (BLOCK - 2);
        }
        let place = 2 * pairs.len();
        [misses, signs] = [misses, signs].map(|bits: u64| bits.checked_shr((BLOCK - place) as u32).unwrap_or(0));
        if let [last] = last {
            let [own, minus] = sums.read(cell, &wide([*last, [0.0; 3]]));
            misses |= (own & 1) << place;
            signs |= (minus & 1) << place;
        }
        let mut crosses = !misses & (u64::MAX >> (BLOCK - block.len()));
        let crossing = crosses.count_ones();
        while crosses != 0 {
            let place = crosses.trailing_zeros() as usize;
            crosses &= crosses - 1;
            let sign = (signs >> place) << 63;
            for (taken, c) in taken.iter_mut().zip(block[place]) {
                *taken += f64::from_bits(c.to_bits() ^ sign);
            }
            report(number * BLOCK + place);
        }
        let (sum, size) = sums.total(block.len());
        for k in 0..3 {
            let (sum, left) = exact_sum(total[k], sum[k] - taken[k]);
            total[k] = sum;
            rest[k] += left;
        }
        magnitude += size;
        // a term goes through an addition for each pair, one for both lanes and one for what is taken out; those that are taken out, which at
        // most double the terms, through one for each
        let additions = (BLOCK / 2 + 2) as f64 + 2.0 * f64::from(crossing);
        error += size * additions;
    }
    let sum = [0, 1, 2].map(|k| total[k] + rest[k]);
    let blocks = generators.len().div_ceil(BLOCK) as f64;
    let slack = 1.0 + (blocks + BLOCK as f64) * 4.0 * UNIT;
    // what the blocks leave behind is summed up with less than one more rounding of the whole, and added with another
    FixedSum { sum, magnitude: magnitude * slack, error: UNIT * (error + 6.0 * magnitude) * slack }
}

/// Two vectors in the order of memory.
#[inline(always)]
fn wide([[a, b, c], [d, e, f]]: [[f64; 3]; 2]) -> Twice {
    [[a, b], [c, d], [e, f]].map(f64x2::new)
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
