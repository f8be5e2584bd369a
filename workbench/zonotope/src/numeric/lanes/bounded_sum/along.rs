//! Support functions and extreme vertices of a centred zonotope of space along a few directions, in one pass over its
//! generators.

use fearless_simd::{Simd, dispatch, f64x8, prelude::*};

use crate::numeric::bounded::Bounded;
use crate::numeric::lanes::level::level;
use crate::numeric::lanes::number::product;
use crate::numeric::lanes::octet::{Octet, splat, total, totals, turned};
use crate::numeric::lanes::rows::Rows;
use crate::numeric::tolerance::{LONG_SUM, PRODUCT_UNDERFLOW, UNIT};

/// Generators whose sums are taken together: a term goes through few additions, whatever their number.
const BLOCK: usize = 512;

/// Σ |g · u| for each direction u, with bounds of the errors. `magnitude` is Σ |g|_1, but for rounding.
///
/// A dot product with the rounded direction is off by at most 3 u |g|_1 max |u_k|, and by |g|_1 times the largest error
/// of a coordinate of the direction.
pub(crate) fn bounded_sums<const K: usize>(
    generators: Rows<'_>,
    magnitude: f64,
    directions: &[[Bounded; 3]; K],
) -> [Bounded; K] {
    let values = absolute_sums(generators, &directions.map(|u| u.map(|c| c.value)));
    let additions = (BLOCK / 8 + generators.len() / BLOCK + 8) as f64;
    let underflow = generators.len() as f64 * PRODUCT_UNDERFLOW;
    let bounded = |k: usize| {
        let [largest, off] =
            directions[k].iter().fold([0.0f64; 2], |m, c| [m[0].max(c.value.abs()), m[1].max(c.error)]);
        let error = UNIT * (additions * values[k] + 4.0 * magnitude * largest) + magnitude * off;
        // a maximum leaves out what is NaN, a sum does not
        let is_known = directions[k].iter().all(|c| c.error.is_finite());
        let error = if is_known { error * LONG_SUM + underflow } else { f64::INFINITY };
        Bounded { value: values[k], error }
    };
    std::array::from_fn(bounded)
}

/// Σ |g · u| for each direction u, in doubles.
pub(crate) fn absolute_sums<const K: usize>(generators: Rows<'_>, directions: &[[f64; 3]; K]) -> [f64; K] {
    dispatch!(level(), simd => absolute_sums_at(simd, generators, directions))
}

#[inline(always)]
fn absolute_sums_at<S: Simd, const K: usize>(simd: S, generators: Rows<'_>, directions: &[[f64; 3]; K]) -> [f64; K] {
    let zero = f64x8::splat(simd, 0.0);
    let wide = wide_directions(simd, directions);
    let mut values = [0.0; K];
    for block in generators.chunks(BLOCK) {
        let octets = block.octets();
        let mut sums = [zero; K];
        for place in 0..octets.len() {
            let v = octets.load(simd, place);
            for k in 0..K {
                sums[k] += product(&v, &wide[k]).abs();
            }
        }
        for k in 0..K {
            values[k] += total(sums[k]);
        }
    }
    values
}

/// For each direction the sum of the generators, each with the sign with which it goes along it.
pub(crate) fn extreme_sums<const K: usize>(generators: Rows<'_>, directions: &[[f64; 3]; K]) -> [[f64; 3]; K] {
    dispatch!(level(), simd => extreme_sums_at(simd, generators, directions))
}

#[inline(always)]
fn extreme_sums_at<S: Simd, const K: usize>(
    simd: S,
    generators: Rows<'_>,
    directions: &[[f64; 3]; K],
) -> [[f64; 3]; K] {
    let zero = f64x8::splat(simd, 0.0);
    let wide = wide_directions(simd, directions);
    let octets = generators.octets();
    let mut sums = [[zero; 3]; K];
    for place in 0..octets.len() {
        let v = octets.load(simd, place);
        for k in 0..K {
            let value = zero + product(&v, &wide[k]);
            for axis in 0..3 {
                sums[k][axis] += turned(simd, v[axis], value);
            }
        }
    }
    let mut points = [[0.0; 3]; K];
    for k in 0..K {
        points[k] = totals(&sums[k]);
    }
    points
}

#[inline(always)]
fn wide_directions<S: Simd, const K: usize>(simd: S, directions: &[[f64; 3]; K]) -> [Octet<S>; K] {
    let mut wide = [[f64x8::splat(simd, 0.0); 3]; K];
    for k in 0..K {
        wide[k] = splat(simd, &directions[k]);
    }
    wide
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numeric::dyadic::Dyadic;
    use crate::numeric::lanes::level::at_each_level;
    use crate::numeric::lanes::test_vectors::vectors;
    use crate::numeric::lanes::{absolute_sum, extreme_sum};
    use crate::numeric::scaling::power_of_two;
    use proptest::prelude::*;

    properties! {
        #![proptest_config(crate::property_cases::config(2000))]

        #[test]
        fn sums_along_several_directions_keep_their_bounds(
            (generators, direction) in vectors(),
            doubt in 0.0..1e-3f64,
        ) {
            let exact = |v: f64| Dyadic::from_f64(v);
            let truth = |u: &[f64; 3]| {
                let along =
                    |v: &[f64; 3]| v.iter().zip(u).fold(Dyadic::zero(), |s, (a, b)| s + exact(*a) * exact(*b));
                generators.iter().fold(Dyadic::zero(), |s, g| s + along(g).abs())
            };
            let magnitude: f64 = generators.iter().flatten().map(|c| c.abs()).sum();
            // the true directions are at the ends of what the errors leave open
            let errors = direction.map(|c| doubt * c.abs());
            let near = [0, 1, 2].map(|k| Bounded { value: direction[k], error: errors[k] });
            let far = [0, 1, 2].map(|k| direction[k] - errors[k]);
            let directions = [direction.map(Bounded::exact), near];
            let rows = Rows::new(&generators);
            for sums in at_each_level(|| bounded_sums(rows, magnitude, &directions)) {
                for (sum, truth) in sums.iter().zip([truth(&direction), truth(&far)]) {
                    let is_known = sum.value.is_finite() && sum.error.is_finite();
                    // the end itself is rounded to a double
                    let room = sum.error * (1.0 + 1e-9) + sum.value.abs() * 1e-15;
                    prop_assert!(!is_known || (exact(sum.value) - truth).abs() <= exact(room));
                }
            }
            let plain = absolute_sums(rows, &[direction]);
            prop_assert!(
                generators.len() > BLOCK || plain[0].to_bits() == absolute_sum(&generators, &direction).to_bits()
                    || (plain[0] - absolute_sum(&generators, &direction)).abs() <= 1e-12 * plain[0]
                    || !plain[0].is_finite()
            );
            let points = extreme_sums(rows, &[direction, [1.0, 0.0, 0.0]]).map(|p| p.map(f64::to_bits));
            prop_assert_eq!(points[0], extreme_sum(&generators, &direction).map(f64::to_bits));
        }
    }

    /// The value is 1024 · |1.5 − 1 + 0|, the sum of the magnitudes 1024 · 7: the bound is (74 · 512 + 4 · 7168 · 2) u
    /// and 7168 times the largest error of a coordinate of the direction.
    #[test]
    fn bounds_worked_out_by_hand() {
        let generators = [[3.0, -4.0, 0.0]; 1024];
        let along = |error: f64| [0.5, 0.25, 2.0].map(|value| Bounded { value, error: error * value });
        let [known, near] = bounded_sums(Rows::new(&generators), 7168.0, &[along(0.0), along(power_of_two(-11))]);
        assert_eq!([known.value, near.value], [512.0; 2]);
        let of = |expected: f64| expected..expected * (1.0 + power_of_two(-19));
        assert!(of(95_232.0 * UNIT).contains(&known.error), "{}", known.error);
        assert!(of(7.0 + 95_232.0 * UNIT).contains(&near.error), "{}", near.error);
        let [first] = bounded_sums(Rows::new(&generators[..1]), 7.0, &[along(0.0)]);
        assert!(of((36.0 + 56.0) * UNIT).contains(&first.error), "{}", first.error);
        let [zero] = bounded_sums(Rows::new(&[[0.0; 3]; 3]), 0.0, &[along(0.0)]);
        assert_eq!(zero.error, 3.0 * PRODUCT_UNDERFLOW);
    }

    #[test]
    fn what_is_orthogonal_to_a_direction_is_added_as_it_stands() {
        let generators = [[-1.0, -2.0, -0.0], [5.0, 0.0, 0.0]];
        let points = extreme_sums(Rows::new(&generators), &[[0.0; 3], [0.0, 0.0, 1.0]]);
        assert_eq!(points, [[4.0, -2.0, 0.0]; 2]);
    }
}
