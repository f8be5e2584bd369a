//! A direction of space prepared for determinants, and the exact sign of the determinant of three.
//!
//! Scaling a vector by a power of two does not change the sign of a determinant, so each is scaled on its own: then one
//! bound on the rounding error serves the whole range of doubles. The side of a plane on which a point lies is a
//! determinant of differences, which are not rounded.

use std::cmp::Ordering;

use robust::{Coord3D, orient3d};

use super::carried_exponents;
use crate::numeric::exact_linear::{cross, difference, dot, exact};
use crate::numeric::linear::sum_norm;
use crate::numeric::scaling::{binary_exponent, power_of_two, scale_by_power_of_two};
use crate::numeric::tolerance::{DETERMINANT_3X3, MODERATE_SIZES, UNDERFLOW};
use crate::tally::{Operation, Tally};

/// A nonzero vector, and the same scaled by a power of two so that its largest coordinate has magnitude in [1, 2).
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Direction {
    original: [f64; 3],
    scaled: [f64; 3],
    precision: Precision,
}

/// What is known of scaled coordinates.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Precision {
    /// Multiples of 2^-15 below 2: a determinant of three such vectors is computed without rounding.
    Short,
    /// Zero or of magnitude at least 2^-200, and scaled exactly: expansions of doubles are exact.
    Narrow,
    /// Anything; scaling may have rounded coordinates that became smaller than any normal double.
    Wide,
}

impl Direction {
    /// The direction of a nonzero vector.
    pub(crate) fn new(original: [f64; 3]) -> Self {
        let exponent = original.iter().filter_map(|&c| binary_exponent(c)).max().unwrap_or(0);
        let scaled = original.map(|c| scale_by_power_of_two(c, -i64::from(exponent)));
        let least = power_of_two(-200);
        let narrow = original.iter().zip(&scaled).all(|(o, s)| *o == 0.0 || s.abs() >= least);
        let short = narrow && scaled.iter().all(|s| (s * 32768.0).fract() == 0.0);
        let precision = match (short, narrow) {
            (true, _) => Precision::Short,
            (_, true) => Precision::Narrow,
            _ => Precision::Wide,
        };
        Self { original, scaled, precision }
    }

    /// The opposite direction.
    pub(crate) fn reversed(self) -> Self {
        Self { original: self.original.map(|c| -c), scaled: self.scaled.map(|c| -c), ..self }
    }

    /// The vector before scaling.
    pub(crate) fn original(&self) -> [f64; 3] {
        self.original
    }

    /// The vector with its largest coordinate in [1, 2); coordinates far below may be rounded.
    pub(crate) fn scaled(&self) -> [f64; 3] {
        self.scaled
    }
}

/// The sign of det(a, b, c) = a · (b × c), exactly.
#[inline]
pub(crate) fn determinant_sign(a: &Direction, b: &Direction, c: &Direction) -> Ordering {
    determinant_sign_counted(a, b, c, &mut ())
}

/// [`determinant_sign`], counting an [`Operation::ExactFallback`] if doubles do not decide it.
#[inline]
pub(crate) fn determinant_sign_counted(
    a: &Direction,
    b: &Direction,
    c: &Direction,
    tally: &mut impl Tally,
) -> Ordering {
    let [determinant, magnitude] = rounded_determinant(&a.scaled, &b.scaled, &c.scaled);
    if determinant.abs() > DETERMINANT_3X3 * magnitude + UNDERFLOW {
        return sign_of(determinant);
    }
    tally.add(Operation::ExactFallback, 1);
    exact_sign(determinant, a, b, c)
}

/// The sign of det(a, b, c) for vectors of doubles as they are, exactly: where there are so many that scaled copies of
/// them all take too much room. It is at its best where coordinates are of moderate sizes.
///
/// A product of coordinates that underflows is off by at most 2^-1075, in terms of the coordinate that it is multiplied
/// with: far less in all than the smallest normal double for each of these.
#[inline]
pub(crate) fn determinant_sign_of_rows(a: &[f64; 3], b: &[f64; 3], c: &[f64; 3]) -> Ordering {
    let [determinant, magnitude] = rounded_determinant(a, b, c);
    let underflow = f64::MIN_POSITIVE * (1.0 + sum_norm(a));
    if determinant.abs() > DETERMINANT_3X3 * magnitude + underflow {
        return sign_of(determinant);
    }
    scaled_sign(a, b, c)
}

/// The side of the plane through a, b and c on which a point lies, exactly: `Greater` if a, b and c are
/// counter-clockwise as seen from it, `Equal` if it lies in the plane or a, b and c lie on a line.
///
/// Coordinates of moderate size are multiples of 2^-252, and what expansions of three differences hold are multiples of
/// 2^-756 below 2^610: nothing underflows or overflows.
pub(crate) fn side_of_plane(a: &[f64; 3], b: &[f64; 3], c: &[f64; 3], point: &[f64; 3]) -> Ordering {
    let is_moderate = |x: &f64| *x == 0.0 || MODERATE_SIZES.contains(&x.abs());
    if [a, b, c, point].into_iter().flatten().all(is_moderate) {
        let [a, b, c, point] = [a, b, c, point].map(|p| Coord3D { x: p[0], y: p[1], z: p[2] });
        return sign_of(-orient3d(a, b, c, point));
    }
    let from_a = |p: &[f64; 3]| difference(&exact(*p), &exact(*a));
    dot(&cross(&from_a(b), &from_a(c)), &from_a(point)).sign()
}

/// det(a, b, c) in doubles, and the sum of the magnitudes of its six products.
#[inline(always)]
fn rounded_determinant([x, y, z]: &[f64; 3], [d, e, f]: &[f64; 3], [g, h, i]: &[f64; 3]) -> [f64; 2] {
    let products = [e * i, f * h, f * g, d * i, d * h, e * g];
    let determinant =
        x * (products[0] - products[1]) + y * (products[2] - products[3]) + z * (products[4] - products[5]);
    let [p, q, r, s, t, u] = products.map(f64::abs);
    [determinant, x.abs() * (p + q) + y.abs() * (r + s) + z.abs() * (t + u)]
}

/// The sign of a number that is not NaN.
#[inline(always)]
fn sign_of(value: f64) -> Ordering {
    if value > 0.0 {
        Ordering::Greater
    } else if value < 0.0 {
        Ordering::Less
    } else {
        Ordering::Equal
    }
}

#[cold]
#[inline(never)]
fn scaled_sign(a: &[f64; 3], b: &[f64; 3], c: &[f64; 3]) -> Ordering {
    let [a, b, c] = [a, b, c].map(|v| Direction::new(*v));
    determinant_sign(&a, &b, &c)
}

#[cold]
#[inline(never)]
fn exact_sign(computed: f64, a: &Direction, b: &Direction, c: &Direction) -> Ordering {
    match a.precision.max(b.precision).max(c.precision) {
        Precision::Short => sign_of(computed),
        Precision::Narrow => {
            let [a, b, c] = [a, b, c].map(|v| Coord3D { x: v.scaled[0], y: v.scaled[1], z: v.scaled[2] });
            sign_of(orient3d(a, b, c, Coord3D { x: 0.0, y: 0.0, z: 0.0 }))
        }
        Precision::Wide => {
            let [a, b, c] = [a, b, c].map(|v| v.original);
            let in_doubles = carried_exponents::determinant_sign(&a, &b, &c);
            in_doubles.unwrap_or_else(|| dot(&exact(a), &cross(&exact(b), &exact(c))).sign())
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numeric::dyadic::Dyadic;
    use crate::tally::OperationCounts;
    use proptest::prelude::*;

    fn coordinate() -> impl Strategy<Value = f64> {
        prop_oneof![
            2 => -1.0..1.0f64,
            2 => (-2i32..3).prop_map(f64::from),
            1 => (-9i32..9).prop_map(|i| f64::from(i) * 0.1),
            1 => (-9i32..9, -1074i64..1000).prop_map(|(i, e)| scale_by_power_of_two(f64::from(i), e)),
            1 => any::<u64>().prop_map(f64::from_bits).prop_filter("finite", |v| v.is_finite()),
        ]
    }

    fn vector() -> impl Strategy<Value = [f64; 3]> {
        [coordinate(), coordinate(), coordinate()].prop_filter("nonzero", |v| v.iter().any(|&c| c != 0.0))
    }

    properties! {
        #![proptest_config(crate::property_cases::config(20_000))]

        #[test]
        fn signs_are_exact(
            a in vector(),
            b in vector(),
            c in vector(),
            near in any::<bool>(),
            k in -3i32..4,
            up in 0usize..4,
        ) {
            let c = if near {
                // nearly, often exactly, in the plane of a and b
                let mut sum: [f64; 3] = std::array::from_fn(|i| a[i] + f64::from(k) * b[i]);
                if up < 3 {
                    sum[up] = sum[up].next_up();
                }
                prop_assume!(sum.iter().all(|v| v.is_finite()) && sum != [0.0; 3]);
                sum
            } else {
                c
            };
            let [x, y, z] = [a, b, c].map(|v| v.map(|v| Dyadic::from_f64(v).to_rational()));
            let minor = |k: usize, l: usize| &y[k] * &z[l] - &y[l] * &z[k];
            let determinant = &x[0] * minor(1, 2) + &x[1] * minor(2, 0) + &x[2] * minor(0, 1);
            let truth = determinant.cmp(&crate::numeric::Rational::ZERO);
            prop_assert_eq!(determinant_sign_of_rows(&a, &b, &c), truth);
            prop_assert_eq!(side_of_plane(&[0.0; 3], &a, &b, &c), truth);
            prop_assert_eq!(side_of_plane(&c, &b, &a, &[0.0; 3]), truth);
            let [a, b, c] = [a, b, c].map(Direction::new);
            prop_assert_eq!(determinant_sign(&a, &b, &c), truth);
            prop_assert_eq!(determinant_sign(&b.reversed(), &a, &c), truth);
        }
    }

    fn fallbacks(a: [f64; 3], b: [f64; 3], c: [f64; 3]) -> (Ordering, u64) {
        let mut counts = OperationCounts::default();
        let [a, b, c] = [a, b, c].map(Direction::new);
        let sign = determinant_sign_counted(&a, &b, &c, &mut counts);
        (sign, counts.get(Operation::ExactFallback))
    }

    #[test]
    fn directions_are_told_by_the_arithmetic_that_is_exact_on_them() {
        let precision = |v: [f64; 3]| Direction::new(v).precision;
        let [bit, least] = [-15, -200].map(power_of_two);
        let longest = 2.0 - bit;
        for exponent in [-800, 0, 1000] {
            let scaled = |v: [f64; 3]| v.map(|c| scale_by_power_of_two(c, exponent));
            for short in [[1.0, 0.0, 0.0], [1.5, bit, -longest], [bit, 1.0, 0.0]] {
                assert_eq!(precision(scaled(short)), Precision::Short);
            }
            for narrow in [[1.0, bit / 2.0, 0.0], [1.0, least, 0.0], [1.0, 0.1, -0.3], [-least, 0.0, 1.75]] {
                assert_eq!(precision(scaled(narrow)), Precision::Narrow);
            }
        }
        assert_eq!(precision([1.0, least.next_down(), 0.0]), Precision::Wide);
        assert_eq!(precision([f64::MAX, 0.0, f64::from_bits(1)]), Precision::Wide);
    }

    #[test]
    fn a_determinant_of_one_small_product_is_decided_by_doubles() {
        let [x, y, z] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        let small = power_of_two(-60);
        assert_eq!(fallbacks([small, 0.0, 1.0], y, z), (Ordering::Greater, 0));
        assert_eq!(fallbacks([1.0, small, 0.0], z, x), (Ordering::Greater, 0));
        assert_eq!(fallbacks([0.0, 1.0, small], x, y), (Ordering::Greater, 0));
    }

    #[test]
    fn a_determinant_is_decided_by_doubles_where_it_is_larger_than_its_bound() {
        let unit = power_of_two(-50);
        let (p, q) = (1.0 + unit, 1.0 - unit);
        assert_eq!((p - q, p + q), (2.0 * unit, 2.0));
        let of = |p: f64, q: f64| fallbacks([1.0, 0.0, 0.0], [0.0, p, 1.0], [0.0, q, 1.0]);
        assert_eq!(of(p, q), (Ordering::Greater, 1));
        assert_eq!(of(p.next_up(), q), (Ordering::Greater, 0));
        assert_eq!(of(q, p), (Ordering::Less, 1));
        assert_eq!(of(q, p.next_up()), (Ordering::Less, 0));
    }

    #[test]
    fn products_that_underflow_decide_no_sign_of_rows() {
        let [size, side] = [-600, -237].map(power_of_two);
        let a = [2.6, -1.4, -1.4].map(|c| c * size);
        let (b, c) = ([side, -side, 0.0], [0.0, side, -side]);
        // 2.6 − 1.4 − 1.4 < 0, and in units of the least double, rounded, 3 − 1 − 1 > 0
        assert!(rounded_determinant(&a, &b, &c)[0] > 0.0);
        assert_eq!(determinant_sign_of_rows(&a, &b, &c), Ordering::Less);
    }

    #[test]
    fn sides_of_planes_are_exact_where_no_coordinate_is_zero() {
        for size in [-1000, -400, 0, 400, 1000].map(power_of_two) {
            let [a, b, c, above, below] =
                [[1.0, 1.0, 1.0], [2.0, 1.0, 1.0], [1.0, 2.0, 1.0], [3.0, 3.0, 1.5], [3.0, 3.0, 0.5]]
                    .map(|p| p.map(|x| x * size));
            assert_eq!(side_of_plane(&a, &b, &c, &above), Ordering::Greater);
            assert_eq!(side_of_plane(&a, &b, &c, &below), Ordering::Less);
            assert_eq!(side_of_plane(&a, &b, &c, &[3.0 * size, 5.0 * size, size]), Ordering::Equal);
        }
    }
}
