//! Bounds on the errors of passes over the same generators, read off once a body: a pass decides nothing by itself, and
//! only where the bound leaves a doubt is exact arithmetic needed.

use super::partial_sums::{LANES, joined};
use crate::numeric::bounded::finite_or_infinity;
use crate::numeric::tolerance::{LONG_SUM, UNIT};

/// Σ |g_k| for each coordinate k, rounded up: half the sides of the smallest box around the centred body, and what
/// bounds the errors of passes over the same generators.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Extents<const D: usize> {
    count: usize,
    /// The additions that a term of a pass goes through.
    additions: f64,
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
        let additions = additions(count);
        let rounded_up = |lanes| (joined(lanes) * (1.0 + 2.0 * additions * UNIT)).next_up();
        Self { count, additions, sums: sums.map(rounded_up) }
    }

    /// The bounds for passes over blocks of at most so many generators, whose sums are added one to another.
    pub(crate) fn in_blocks_of(self, size: usize) -> Self {
        let blocks = self.count.div_ceil(size);
        let additions = if blocks > 1 { additions(size) + blocks as f64 } else { self.additions };
        Self { additions, ..self }
    }

    /// Upper bounds of Σ |g_k|, one a coordinate; infinite where the sum leaves the range of doubles.
    pub fn sums(&self) -> [f64; D] {
        self.sums
    }

    /// A bound for |[`absolute_sum`](super::absolute_sum) − Σ |g · direction||, given the value that was computed; it
    /// also bounds by how much the exact value of the point of [`extreme_sum`](super::extreme_sum) in this direction
    /// falls short of the support function. Infinite where anything overflows.
    ///
    /// With u = 2^-53, a dot product of D terms is off by at most (D + u') u Σ |g_k u_k| and D denormal steps; a lane
    /// adds ⌈n / 8⌉ of their absolute values and three more additions join the lanes, each off by u times the sum. A
    /// sign that is wrong costs twice its dot product, which is then no larger than that product's error: hence the
    /// factor two. The factor 1 + 2^-20 covers products of these errors for every n below 2^32 and the rounding of the
    /// bound itself.
    pub fn error(&self, direction: &[f64; D], value: f64) -> f64 {
        let dimension = D as f64;
        let magnitude: f64 = self.sums.iter().zip(direction).map(|(sum, u)| sum * u.abs()).sum();
        let relative = UNIT * (2.0 * (dimension + 1.0) * magnitude + self.additions * value.abs());
        let underflow = f64::from_bits(1) * 4.0 * (self.count as f64 + 1.0) * (dimension + 1.0);
        finite_or_infinity(relative * LONG_SUM + underflow)
    }

    /// A bound for the error of each coordinate of [`extreme_sum`](super::extreme_sum), against the exact sum with the
    /// same signs.
    pub fn point_error(&self) -> [f64; D] {
        self.sums.map(|sum| finite_or_infinity((self.additions * UNIT * sum).next_up()))
    }
}

/// How many additions a term of a pass over `count` generators goes through, with room for products of their errors.
fn additions(count: usize) -> f64 {
    count.div_ceil(LANES) as f64 + 5.0
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numeric::dyadic::Dyadic;
    use crate::numeric::lanes::extreme_sum::dot_or_plus_zero;
    use crate::numeric::lanes::level::at_each_level;
    use crate::numeric::lanes::rows::Rows;
    use crate::numeric::lanes::test_vectors::vectors;
    use crate::numeric::lanes::{absolute_sum, bounded_sum, extreme_sum};
    use proptest::prelude::*;

    properties! {
        #![proptest_config(crate::property_cases::config(3000))]

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
            let rounded = extreme_sum(&generators, &direction);
            for k in 0..3 {
                prop_assert!((exact(rounded[k]) - point[k].clone()).abs() <= exact(extents.point_error()[k]));
                let length = generators.iter().fold(Dyadic::zero(), |s, g| s + exact(g[k]).abs());
                prop_assert!(length <= exact(extents.sums()[k]));
            }
        }
    }

    properties! {
        #[test]
        fn sums_are_the_same_at_every_level((generators, direction) in vectors()) {
            let all = at_each_level(|| {
                let extreme = extreme_sum(&generators, &direction).map(f64::to_bits);
                let bounded = bounded_sum(Rows::new(&generators), &direction);
                let sums = [absolute_sum(&generators, &direction), bounded.value, bounded.error];
                (sums.map(f64::to_bits), extreme)
            });
            prop_assert!(all.iter().all(|own| *own == all[0]));
        }
    }

    #[test]
    fn sums_of_blocks_keep_bounds_of_their_own() {
        let generators: Vec<[f64; 3]> = (1..3000).map(|i| [1, 7, 31].map(|k| 0.1 + 1.0 / f64::from(i * k))).collect();
        let sums = generators.chunks(256).map(|block| extreme_sum(block, &[1.0; 3]));
        let sum = sums.reduce(|a, b| [0, 1, 2].map(|k| a[k] + b[k])).expect("there are blocks");
        let whole = Extents::new(&generators);
        let bounds = whole.in_blocks_of(256).point_error();
        for k in 0..3 {
            let exact = generators.iter().fold(Dyadic::zero(), |s, g| s + Dyadic::from_f64(g[k]));
            assert!((exact - Dyadic::from_f64(sum[k])).abs() <= Dyadic::from_f64(bounds[k]));
            assert!(7.0 * bounds[k] < whole.point_error()[k]);
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

    /// Sixteen generators (3, −4) add two to each lane: a term goes through 7 additions.
    #[test]
    fn bounds_worked_out_by_hand() {
        let generators = [[3.0, -4.0]; 16];
        let extents = Extents::new(&generators);
        let within = |value: f64, expected: f64, units: f64| {
            let more = (value / expected - 1.0) / UNIT;
            (units..units + 8.0).contains(&more)
        };
        let ([x, y], [off_x, off_y]) = (extents.sums(), extents.point_error());
        assert!(within(x, 48.0, 14.0) && within(y, 64.0, 14.0), "{extents:?}");
        assert!(within(off_x, 7.0 * 48.0 * UNIT, 14.0) && within(off_y, 7.0 * 64.0 * UNIT, 14.0), "{off_x} {off_y}");
        // 2 · 3 · (0.5 · 48 + 2 · 64) + 7 · 16 · |1.5 − 8|
        let error = extents.error(&[0.5, -2.0], 104.0) / UNIT;
        assert!((1640.0..1640.01).contains(&error), "{error}");
        // the sums of two blocks of one octet each are added: a term goes through 6 + 2 additions
        let in_blocks = extents.in_blocks_of(8).point_error()[0];
        assert!(within(in_blocks, 8.0 * 48.0 * UNIT, 14.0), "{in_blocks}");
        assert_eq!(extents.in_blocks_of(16), extents);
        // four denormal steps for each of 3 generators and 3 dimensions
        assert_eq!(Extents::new(&[[0.0; 2]; 2]).error(&[0.0; 2], 0.0), f64::from_bits(36));
    }
}
