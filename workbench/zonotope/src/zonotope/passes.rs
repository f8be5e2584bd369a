//! Passes over generators in plain doubles: fixed lanes, so that the compiler vectorises them and the result is the
//! same on every machine.
//!
//! A pass decides nothing by itself. [`Extents`] are read off once a body; with them every later pass has a bound on
//! its error, and only where that bound leaves a doubt is exact arithmetic needed.

use wide::f64x2;

use super::Zonotope;
use super::faces::Estimate;
use crate::numeric::bounded::Bounded;
use crate::numeric::linear::dot;
use crate::numeric::tolerance::{LONG_SUM, PRODUCT_UNDERFLOW, UNIT};

/// Partial sums kept side by side.
const LANES: usize = 8;

/// Generators whose sums are taken together where the bound is to be small for any number of them.
const BLOCK: usize = 512;

/// Σ |g · direction| over the generators, in doubles; [`Extents::error`] bounds how far it is off. O(n).
///
/// Infinite or NaN where a product or a sum leaves the range of doubles.
#[inline]
pub fn absolute_sum<const D: usize>(generators: &[[f64; D]], direction: &[f64; D]) -> f64 {
    let mut sums = [0.0; LANES];
    let (blocks, rest) = generators.as_chunks::<LANES>();
    for block in blocks {
        for (sum, generator) in sums.iter_mut().zip(block) {
            *sum += dot(generator, direction).abs();
        }
    }
    for (sum, generator) in sums.iter_mut().zip(rest) {
        *sum += dot(generator, direction).abs();
    }
    total(sums)
}

/// Σ |g · direction| with a bound on its error, in one pass that sums up the magnitudes as well.
#[inline]
pub(crate) fn bounded_sum(generators: &[[f64; 3]], direction: &[f64; 3]) -> Bounded {
    bounded_sum_near(generators, direction, 0.0)
}

/// The same along an exact direction of which no coordinate is farther than 4 u `size` from the given one.
///
/// A dot product is off by at most 3 u |g|_1 max |direction_k|; the sums are taken in blocks, so a term goes through
/// few additions.
pub(crate) fn bounded_sum_near(generators: &[[f64; 3]], direction: &[f64; 3], size: f64) -> Bounded {
    let [x, y, z] = *direction;
    // two generators in the order in which they lie in memory
    let wide = [[x, y], [z, x], [y, z]].map(f64x2::new);
    let (mut value, mut magnitude) = (0.0, 0.0);
    for block in generators.chunks(BLOCK) {
        let mut values = [f64x2::default(); 2];
        let mut sizes = [f64x2::default(); 3];
        let mut read = |[[a, b, c], [d, e, f]]: [[f64; 3]; 2], values: &mut f64x2| {
            let pair = [[a, b], [c, d], [e, f]].map(f64x2::new);
            let [first, middle, last] = [pair[0] * wide[0], pair[1] * wide[1], pair[2] * wide[2]];
            let [ends, others] = f64x2::transpose([first, last]);
            *values += (ends + others + middle).abs();
            for (size, c) in sizes.iter_mut().zip(pair) {
                *size += c.abs();
            }
        };
        let (fours, rest) = block.as_chunks::<4>();
        for [a, b, c, d] in fours {
            read([*a, *b], &mut values[0]);
            read([*c, *d], &mut values[1]);
        }
        for generator in rest {
            read([*generator, [0.0; 3]], &mut values[0]);
        }
        value += (values[0] + values[1]).reduce_add();
        magnitude += (sizes[0] + sizes[1] + sizes[2]).reduce_add();
    }
    let additions = (BLOCK + generators.len() / BLOCK + 8) as f64;
    let largest = direction.iter().fold(0.0f64, |m, c| m.max(c.abs()));
    let error = UNIT * (additions * value + 4.0 * magnitude * (largest + size)) * (1.0 + 4.0 * additions * UNIT);
    Bounded { value, error: error + generators.len() as f64 * PRODUCT_UNDERFLOW }
}

/// Σ ± g with the signs of g · direction: an extreme vertex of the centred body, in doubles. O(n).
///
/// Its signs are those of computed dot products: [`Extents::error`] bounds by how much the point misses the support
/// function, and [`Extents::point_error`] how far its coordinates are from those of the vertex with these signs.
#[inline]
pub fn extreme_sum<const D: usize>(generators: &[[f64; D]], direction: &[f64; D]) -> [f64; D] {
    let mut sums = [[0.0; LANES]; D];
    let (blocks, rest) = generators.as_chunks::<LANES>();
    for block in blocks {
        let signs: [f64; LANES] = std::array::from_fn(|lane| dot_or_plus_zero(&block[lane], direction));
        for (axis, sum) in sums.iter_mut().enumerate() {
            for lane in 0..LANES {
                sum[lane] += turned(block[lane][axis], signs[lane]);
            }
        }
    }
    for (lane, generator) in rest.iter().enumerate() {
        let sign = dot_or_plus_zero(generator, direction);
        for (axis, sum) in sums.iter_mut().enumerate() {
            sum[lane] += turned(generator[axis], sign);
        }
    }
    sums.map(total)
}

/// Σ |g_k| for each coordinate k, rounded up: half the sides of the smallest box around the centred body, and what
/// bounds the errors of passes over the same generators.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Extents<const D: usize> {
    count: usize,
    sums: [f64; D],
}

impl<const D: usize> Extents<D> {
    /// The extents of some generators. O(n).
    pub fn new(generators: &[[f64; D]]) -> Self {
        let mut sums = [[0.0; LANES]; D];
        for block in generators.chunks(LANES) {
            for (lane, generator) in block.iter().enumerate() {
                for (axis, sum) in sums.iter_mut().enumerate() {
                    sum[lane] += generator[axis].abs();
                }
            }
        }
        let count = generators.len();
        Self { count, sums: sums.map(|lanes| (total(lanes) * (1.0 + 2.0 * additions(count) * UNIT)).next_up()) }
    }

    /// Upper bounds of Σ |g_k|, one a coordinate; infinite where the sum leaves the range of doubles.
    pub fn sums(&self) -> [f64; D] {
        self.sums
    }

    /// A bound for |[`absolute_sum`] − Σ |g · direction||, given the value that was computed; it also bounds by how
    /// much the exact value of the point of [`extreme_sum`] in this direction falls short of the support function.
    /// Infinite where anything overflows.
    ///
    /// With u = 2^-53, a dot product of D terms is off by at most (D + u') u Σ |g_k u_k| and D denormal steps; a lane
    /// adds ⌈n / 8⌉ of their absolute values and three more additions join the lanes, each off by u times the sum. A
    /// sign that is wrong costs twice its dot product, which is then no larger than that product's error: hence the
    /// factor two. The factor 1 + 2^-20 covers products of these errors for every n below 2^32 and the rounding of the
    /// bound itself.
    pub fn error(&self, direction: &[f64; D], value: f64) -> f64 {
        let dimension = D as f64;
        let magnitude: f64 = self.sums.iter().zip(direction).map(|(sum, u)| sum * u.abs()).sum();
        let relative = UNIT * (2.0 * (dimension + 1.0) * magnitude + additions(self.count) * value.abs());
        let underflow = f64::from_bits(1) * 4.0 * (self.count as f64 + 1.0) * (dimension + 1.0);
        finite_or_infinity(relative * LONG_SUM + underflow)
    }

    /// A bound for the error of each coordinate of [`extreme_sum`], against the exact sum with the same signs.
    pub fn point_error(&self) -> [f64; D] {
        self.sums.map(|sum| finite_or_infinity((additions(self.count) * UNIT * sum).next_up()))
    }
}

impl<const D: usize> Zonotope<D> {
    /// The support function in a direction of finite coordinates by one pass in doubles, with a bound on its error;
    /// `extents` are those of the generators. O(n). [`support`](Self::support) is exact.
    pub fn support_estimate(&self, direction: &[f64; D], extents: &Extents<D>) -> Estimate {
        let width = absolute_sum(self.generators(), direction);
        let center = self.center();
        let magnitude: f64 = center.iter().zip(direction).map(|(c, u)| (c * u).abs()).sum();
        let value = dot(&center, direction) + width;
        let of_center = UNIT * (D as f64 + 2.0) * magnitude + UNIT * width + f64::from_bits(1) * (D as f64 + 2.0);
        let error = (extents.error(direction, width) + of_center) * LONG_SUM;
        Estimate { value, error: if value.is_finite() { finite_or_infinity(error) } else { f64::INFINITY } }
    }
}

/// How many additions a term of a pass over `count` generators goes through, with room for products of their errors.
fn additions(count: usize) -> f64 {
    count.div_ceil(LANES) as f64 + 5.0
}

fn finite_or_infinity(bound: f64) -> f64 {
    if bound.is_finite() { bound } else { f64::INFINITY }
}

/// The dot product, where 0 has the plus sign: a generator that is orthogonal to the direction is added as it stands.
#[inline(always)]
fn dot_or_plus_zero<const D: usize>(a: &[f64; D], b: &[f64; D]) -> f64 {
    0.0 + dot(a, b)
}

/// `value`, or its opposite if `sign` is negative.
#[inline(always)]
fn turned(value: f64, sign: f64) -> f64 {
    f64::from_bits(value.to_bits() ^ (sign.to_bits() & (1 << 63)))
}

#[inline(always)]
fn total(lanes: [f64; LANES]) -> f64 {
    let [a, b, c, d, e, f, g, h] = lanes;
    ((a + b) + (c + d)) + ((e + f) + (g + h))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numeric::dyadic::Dyadic;
    use proptest::prelude::*;

    fn coordinate() -> impl Strategy<Value = f64> {
        prop_oneof![
            4 => -1.0..1.0f64,
            1 => -1e-300..1e-300f64,
            1 => -1e150..1e150f64,
            2 => (-3i32..4).prop_map(f64::from),
            1 => (-9i32..9).prop_map(|i| f64::from(i) * f64::from_bits(1)),
        ]
    }

    fn vectors() -> impl Strategy<Value = (Vec<[f64; 3]>, [f64; 3])> {
        let vector = || [coordinate(), coordinate(), coordinate()];
        (proptest::collection::vec(vector(), 0..40), vector())
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(3000))]

        #[test]
        fn sums_keep_their_bounds((generators, direction) in vectors()) {
            let exact = |v: f64| Dyadic::from_f64(v);
            let along =
                |v: &[f64; 3]| v.iter().zip(direction).fold(Dyadic::zero(), |s, (a, b)| s + exact(*a) * exact(b));
            let truth = generators.iter().fold(Dyadic::zero(), |s, g| s + along(g).abs());
            let extents = Extents::new(&generators);
            let value = absolute_sum(&generators, &direction);
            let error = extents.error(&direction, value);
            prop_assert!(error == f64::INFINITY || (exact(value) - truth.clone()).abs() <= exact(error));

            let signs: Vec<bool> =
                generators.iter().map(|g| dot_or_plus_zero(g, &direction).is_sign_negative()).collect();
            let point: [Dyadic; 3] = std::array::from_fn(|k| {
                generators.iter().zip(&signs).fold(Dyadic::zero(), |s, (g, &minus)| {
                    if minus { s - exact(g[k]) } else { s + exact(g[k]) }
                })
            });
            let gained = point.iter().zip(direction).fold(Dyadic::zero(), |s, (a, b)| s + a * &exact(b));
            prop_assert!(error == f64::INFINITY || truth - gained <= exact(error));
            for center in [[0.0; 3], [1e16, -3.0, 0.1], generators.first().copied().unwrap_or_default()] {
                let body = Zonotope::new(center, generators.clone()).expect("finite");
                let estimate = body.support_estimate(&direction, &extents);
                let off = || (exact(estimate.value) - body.support(direction).exact_value).abs();
                prop_assert!(estimate.error == f64::INFINITY || off() <= exact(estimate.error));
            }
            let rounded = extreme_sum(&generators, &direction);
            for k in 0..3 {
                prop_assert!((exact(rounded[k]) - point[k].clone()).abs() <= exact(extents.point_error()[k]));
                let length = generators.iter().fold(Dyadic::zero(), |s, g| s + exact(g[k]).abs());
                prop_assert!(length <= exact(extents.sums()[k]));
            }
        }
    }

    #[test]
    fn overflow_is_never_called_certain() {
        let generators = [[f64::MAX, f64::MAX, 0.0]; 3];
        let value = absolute_sum(&generators, &[1.0, 1.0, 0.0]);
        assert_eq!(Extents::new(&generators).error(&[1.0, 1.0, 0.0], value), f64::INFINITY);
        let cancelling = [[f64::MAX, f64::MAX, 0.0]];
        let value = absolute_sum(&cancelling, &[2.0, -2.0, 0.0]);
        assert_eq!(Extents::new(&cancelling).error(&[2.0, -2.0, 0.0], value), f64::INFINITY);
    }
}
