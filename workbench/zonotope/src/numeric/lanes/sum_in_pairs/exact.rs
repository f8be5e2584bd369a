//! The exact sum of vectors of space with the signs of their products with a direction, in one pass; vectors of which
//! rounding leaves the sign open are listed instead.
//!
//! Adding and subtracting a power of two far above a number splits it into a multiple of that power's last place and a
//! rest, without error, and a block of such multiples sums up in doubles without error. Twice that, and a rest is left
//! of numbers alone that are more than 2^30 times smaller than the longest vector: then there is no sum, and the
//! vectors are added one by one by whoever needs it.

use fearless_simd::{Simd, dispatch, f64x8, prelude::*};

use super::super::level::level;
use super::super::number::product;
use super::super::octet::{LANES, slot, splat, totals, turned};
use super::super::octets::Octets;
use super::super::rows::Rows;
use crate::numeric::exact_sum::ExactSum;
use crate::numeric::scaling::{power_of_two, power_of_two_below};
use crate::numeric::tolerance::PRODUCT_UNDERFLOW;

/// Vectors whose parts sum up in a double without error.
const BLOCK: usize = 512;

/// The first power of two in terms of that which is not above the longest vector: a block of numbers below twice the
/// latter stays below it, with room for their rounding.
const COARSE: f64 = 4.0 * BLOCK as f64;

/// The sizes of longest vectors between which no power overflows and no part is lost to underflow.
const SIZES: std::ops::Range<f64> = power_of_two(-900)..power_of_two(1000);

/// A direction, with the errors of products with it in terms of the coordinates of a vector.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Along<'a> {
    pub(crate) direction: &'a [f64; 3],
    pub(crate) errors: &'a [f64; 3],
    /// At least the longest vector's largest coordinate, and less than twice as much.
    pub(crate) longest: f64,
}

/// Adds Σ ± v over the rows whose sign is certain to a sum, and the others' places from an offset on to a list; whether
/// nothing was left out. O(n).
pub(crate) fn add_extreme_exactly(
    rows: Rows<'_>,
    along: &Along<'_>,
    offset: usize,
    sums: &mut [ExactSum; 3],
    doubtful: &mut Vec<usize>,
) -> bool {
    if !SIZES.contains(&along.longest) {
        return along.longest == 0.0 && rows.is_empty();
    }
    rows.chunks(BLOCK).enumerate().all(|(number, block)| {
        let first = offset + number * BLOCK;
        let from = doubtful.len();
        let parts = dispatch!(level(), simd => sum_of_block(simd, block.octets(), along, first, doubtful));
        // places that fill up the last eight are no rows
        while doubtful.len() > from && doubtful.last().is_some_and(|&place| place >= first + block.len()) {
            doubtful.pop();
        }
        let Some(parts) = parts else { return false };
        for (sum, own) in sums.iter_mut().zip(parts) {
            own.into_iter().for_each(|part| sum.add(part));
        }
        true
    })
}

/// The sums of the two parts of each coordinate, if no rest is left.
#[inline(always)]
fn sum_of_block<S: Simd>(
    simd: S,
    octets: Octets<'_>,
    along: &Along<'_>,
    first: usize,
    doubtful: &mut Vec<usize>,
) -> Option<[[f64; 2]; 3]> {
    let (u, errors) = (splat(simd, along.direction), splat(simd, along.errors));
    let coarse = COARSE * power_of_two_below(along.longest);
    let fine = coarse * (COARSE * f64::EPSILON);
    let [zero, least, coarse, fine] = [0.0, PRODUCT_UNDERFLOW, coarse, fine].map(|c| f64x8::splat(simd, c));
    let (mut large, mut small, mut left) = ([zero; 3], [zero; 3], zero);
    for number in 0..octets.len() {
        let v = octets.load(simd, number);
        let value = product(&v, &u);
        let error = product(&[v[0].abs(), v[1].abs(), v[2].abs()], &errors) + least;
        let is_certain = value.abs().simd_gt(error);
        for k in 0..3 {
            let own = turned(simd, is_certain.select(v[k], zero), value);
            let part = (coarse + own) - coarse;
            let rest = own - part;
            let smaller = (fine + rest) - fine;
            large[k] += part;
            small[k] += smaller;
            left += (rest - smaller).abs();
        }
        let mut open = !is_certain.to_bitmask() & ((1 << LANES) - 1);
        let mut places = [0; LANES];
        let mut count = 0;
        while open != 0 {
            places[count] = first + LANES * number + slot(open.trailing_zeros() as usize);
            count += 1;
            open &= open - 1;
        }
        places[..count].sort_unstable();
        doubtful.extend_from_slice(&places[..count]);
    }
    let (large, small) = (totals(&large), totals(&small));
    (totals(&[left, zero, zero])[0] == 0.0).then(|| [0, 1, 2].map(|k| [large[k], small[k]]))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numeric::dyadic::Dyadic;
    use crate::numeric::lanes::body_sums::laid_out;
    use crate::numeric::lanes::level::at_each_level;
    use crate::numeric::linear::{dot, max_norm};
    use crate::numeric::tolerance::UNIT;
    use proptest::prelude::*;

    fn coordinate() -> impl Strategy<Value = f64> {
        prop_oneof![6 => -1.0..1.0f64, 3 => (-4i32..5).prop_map(|i| f64::from(i) / 4.0), 1 => -1e-9..1e-9f64]
    }

    type Found = (bool, [Dyadic; 3], Vec<usize>);

    properties! {
        #![proptest_config(crate::property_cases::config(300))]

        /// Sums of more than one block, in rows and in blocks, at each level.
        #[test]
        fn sums_are_exact(
            vectors in proptest::collection::vec(proptest::array::uniform3(coordinate()), 1..1200),
            direction in proptest::array::uniform3(coordinate()),
            exponent in -800..800i32,
        ) {
            let size = power_of_two(exponent);
            let vectors: Vec<[f64; 3]> = vectors.iter().map(|v| v.map(|c| c * size)).collect();
            let errors = direction.map(|c| 8.0 * UNIT * c.abs());
            let longest = vectors.iter().fold(0.0f64, |m, v| m.max(max_norm(v)));
            let along = Along { direction: &direction, errors: &errors, longest };
            let known = laid_out(&vectors);
            let of = |rows: Rows<'_>| -> Found {
                let (mut sums, mut doubtful) = (<[ExactSum; 3]>::default(), Vec::new());
                let is_whole = add_extreme_exactly(rows, &along, 5, &mut sums, &mut doubtful);
                (is_whole, sums.each_ref().map(ExactSum::value), doubtful)
            };
            let found = [Rows::new(&vectors), Rows::laid_out(&vectors, &known)].map(|rows| at_each_level(|| of(rows)));
            let (is_whole, sum, doubtful) = &found[0][0];
            prop_assert!(found.iter().flatten().all(|own| own == &found[0][0]));
            let least = vectors.iter().flatten().filter(|c| **c != 0.0).fold(f64::MAX, |m, c| m.min(c.abs()));
            prop_assert!(*is_whole || least < longest * power_of_two(-30));
            if !is_whole {
                return Ok(());
            }
            let is_open = |v: &[f64; 3]| {
                let error = errors.iter().zip(v).map(|(e, c)| e * c.abs()).sum::<f64>() + PRODUCT_UNDERFLOW;
                dot(v, &direction).abs() <= error
            };
            let open: Vec<usize> = (0..vectors.len()).filter(|&i| is_open(&vectors[i])).map(|i| i + 5).collect();
            prop_assert_eq!(&open, doubtful);
            for k in 0..3 {
                let truth = vectors.iter().filter(|v| !is_open(v)).fold(Dyadic::zero(), |sum, v| {
                    sum + Dyadic::from_f64(v[k] * dot(v, &direction).signum())
                });
                prop_assert_eq!(&truth, &sum[k]);
            }
        }
    }

    #[test]
    fn a_rest_below_both_parts_leaves_no_sum() {
        let vectors = [[1.0, 1.0, 1.0], [1.0, power_of_two(-100), 1.0]];
        let along = Along { direction: &[1.0; 3], errors: &[0.0; 3], longest: 1.0 };
        let of = |vectors: &[[f64; 3]], along: &Along<'_>| {
            add_extreme_exactly(Rows::new(vectors), along, 0, &mut Default::default(), &mut Vec::new())
        };
        assert!(of(&vectors[..1], &along) && !of(&vectors, &along));
        let [tiny, huge] = [power_of_two(-1000), power_of_two(1010)].map(|longest| Along { longest, ..along });
        assert!(!of(&vectors, &tiny) && !of(&vectors, &huge) && !of(&vectors, &Along { longest: 0.0, ..along }));
    }
}
