//! Σ c v over vectors of space with coefficients of at most 1 in magnitude, to about twice the digits of a double, in
//! one pass.
//!
//! Each factor is cut into a head of 26 bits and a tail of 27, so that what rounding a product leaves behind is known
//! (Dekker), and so is what rounding a sum does (Knuth). These small parts are added as they are. A coefficient of a
//! basis that is near 0 is known to the last digit by a sum as precise as that, where one with a tenth of the digits
//! more than a double would leave it to exact arithmetic on all vectors.
//!
//! Near the boundary of a body nearly all coefficients of a proof are ±c for one c: those of the extreme vertex of a
//! facet, made smaller. Eight vectors with such coefficients are summed up with their signs alone, which takes no
//! products, and c is multiplied with the sum. That is a third of the arithmetic: some four passes in doubles, where
//! eight products take some twelve.

use std::array;

use fearless_simd::{Level, Simd, dispatch, f64x8, prelude::*};

use super::double_double::BoundedDoubleDouble;
use super::lanes::level::{level, level_for_few};
use super::lanes::octet::{LANES, reordered, turned};
use super::lanes::octets::Octets;
use super::lanes::pair_lanes::{BLOCK, Lanes, Sum};
use super::lanes::rows::Rows;

/// The coefficients among whose first ones two neighbours of the same magnitude are looked for.
const FIRST_COEFFICIENTS: usize = 9;

/// Fewer vectors than these are all multiplied: a second sum takes longer to join than the products that it spares.
const LEAST_SIGNED_COUNT: usize = 64;

/// The most vectors whose sum is left to instructions of 256 bits.
const NARROW_LIMIT: usize = 32;

/// The sums over all vectors.
struct Sums {
    /// Over the eights whose coefficients differ in magnitude.
    products: [Sum; 3],
    /// Over the others, of the vectors with the signs of their coefficients.
    signed: [Sum; 3],
    /// Whether all coefficients are at most 1 in magnitude.
    are_within: bool,
}

/// Σ c v of as many vectors as coefficients; nothing is known of it where a coefficient exceeds 1 in magnitude or is
/// NaN. O(n).
pub(crate) fn combined_sum(rows: Rows<'_>, coefficients: &[f64]) -> [BoundedDoubleDouble; 3] {
    let common = common_magnitude(coefficients);
    let Sums { products, signed, are_within } =
        dispatch!(level_for(rows.len()), simd => sums(simd, rows, coefficients, common));
    if !are_within {
        return [BoundedDoubleDouble::of_parts(0.0, 0.0, f64::INFINITY); 3];
    }
    let count = rows.len() as f64;
    array::from_fn(|k| {
        let sum = products[k].in_pairs(count);
        match common {
            Some(common) => sum + signed[k].in_pairs(0.0) * BoundedDoubleDouble::exact(common),
            None => sum,
        }
    })
}

/// The magnitude that most coefficients of an extreme point have: that of two neighbours among the first.
fn common_magnitude(coefficients: &[f64]) -> Option<f64> {
    if coefficients.len() < LEAST_SIGNED_COUNT {
        return None;
    }
    let first = &coefficients[..FIRST_COEFFICIENTS];
    first.windows(2).find(|pair| pair[0].abs() == pair[1].abs()).map(|pair| pair[0].abs())
}

#[inline(always)]
fn level_for(count: usize) -> Level {
    if count <= NARROW_LIMIT { level_for_few() } else { level() }
}

#[inline(always)]
fn sums<S: Simd>(simd: S, rows: Rows<'_>, coefficients: &[f64], common: Option<f64>) -> Sums {
    let (mut products, mut signed) = ([Sum::default(); 3], [Sum::default(); 3]);
    let mut are_within = common.is_none_or(|common| common <= 1.0);
    let mut rest = coefficients;
    for block in rows.chunks(BLOCK) {
        let (own, others) = rest.split_at(block.len());
        rest = others;
        let octets = block.octets();
        let mut uneven = (1u64 << octets.len()) - 1;
        if let Some(common) = common {
            let lanes;
            (lanes, uneven) = sum_of_signed(simd, octets, own, common);
            for (sum, lanes) in signed.iter_mut().zip(&lanes) {
                sum.add(lanes.joined());
            }
        }
        if uneven != 0 {
            let (lanes, own_are_within) = sum_of_products(simd, octets, own, uneven);
            are_within &= own_are_within;
            for (sum, lanes) in products.iter_mut().zip(&lanes) {
                sum.add(lanes.joined());
            }
        }
    }
    Sums { products, signed, are_within }
}

/// The vectors with the signs of their coefficients, where all eight of these have a common magnitude; a bit for each
/// eight that have not.
#[inline(always)]
fn sum_of_signed<S: Simd>(simd: S, octets: Octets<'_>, coefficients: &[f64], common: f64) -> ([Lanes<S>; 3], u64) {
    let magnitude = f64x8::splat(simd, common);
    let mut lanes = [Lanes::new(simd); 3];
    let mut uneven = 0;
    for place in 0..octets.len() {
        let signs = coefficients_at(simd, coefficients, place, common);
        if !signs.abs().simd_eq(magnitude).all_true() {
            uneven |= 1 << place;
            continue;
        }
        let v = octets.load(simd, place);
        for k in 0..3 {
            lanes[k].add_exact(turned(simd, v[k], signs));
        }
    }
    (lanes, uneven)
}

/// The vectors times their coefficients, of the eights that have a bit; and whether no coefficient exceeds 1.
#[inline(always)]
fn sum_of_products<S: Simd>(simd: S, octets: Octets<'_>, coefficients: &[f64], places: u64) -> ([Lanes<S>; 3], bool) {
    let one = f64x8::splat(simd, 1.0);
    let mut lanes = [Lanes::new(simd); 3];
    let (mut are_within, mut places) = (true, places);
    while places != 0 {
        let place = places.trailing_zeros() as usize;
        places &= places - 1;
        let own = coefficients_at(simd, coefficients, place, 0.0);
        are_within &= own.abs().simd_le(one).all_true();
        let v = octets.load(simd, place);
        for k in 0..3 {
            lanes[k].add_products(simd, v[k], own);
        }
    }
    (lanes, are_within)
}

/// Eight coefficients in the order of the lanes; those that the last eight lack are a number of the caller's choice.
#[inline(always)]
fn coefficients_at<S: Simd>(simd: S, coefficients: &[f64], place: usize, missing: f64) -> f64x8<S> {
    let (whole, last) = coefficients.as_chunks::<LANES>();
    let own = match whole.get(place) {
        Some(own) => f64x8::from_slice(simd, own),
        None => {
            let mut own = [missing; LANES];
            for (own, c) in own.iter_mut().zip(last) {
                *own = *c;
            }
            f64x8::from_slice(simd, &own)
        }
    };
    reordered(simd, own)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numeric::dyadic::Dyadic;
    use crate::numeric::lanes::body_sums::laid_out;
    use crate::numeric::lanes::level::at_each_level;
    use crate::numeric::scaling::power_of_two;
    use proptest::prelude::*;

    /// Coefficients of any kind, and those that are nearly all of one magnitude.
    fn coefficients() -> impl Strategy<Value = Vec<f64>> {
        let of_proof = (0.0..1.0f64, proptest::collection::vec((any::<bool>(), 0..60u8, -1.0..1.0f64), 600));
        let signed = of_proof.prop_map(|(common, places)| {
            let of = |(is_negative, kind, own): (bool, u8, f64)| match (kind, is_negative) {
                (0, _) => own,
                (_, true) => -common,
                (_, false) => common,
            };
            places.into_iter().map(of).collect()
        });
        prop_oneof![proptest::collection::vec(-1.0..1.0f64, 600), signed]
    }

    properties! {
        #[test]
        fn sums_keep_their_bounds_and_are_the_same_at_each_level(
            vectors in proptest::collection::vec(proptest::array::uniform3(-1e3..1e3f64), 0..600),
            coefficients in coefficients(),
            exponent in -900..900i32,
        ) {
            let size = power_of_two(exponent);
            let vectors: Vec<[f64; 3]> = vectors.iter().map(|v| v.map(|c| c * size)).collect();
            let coefficients = &coefficients[..vectors.len()];
            let known = laid_out(&vectors);
            let of = |rows| at_each_level(|| combined_sum(rows, coefficients));
            let found = [of(Rows::new(&vectors)), of(Rows::laid_out(&vectors, &known))].concat();
            for k in 0..3 {
                let exact = vectors.iter().zip(coefficients).fold(Dyadic::zero(), |sum, (v, c)| {
                    sum + Dyadic::from_f64(v[k]) * Dyadic::from_f64(*c)
                });
                let (pair, error) = found[0][k].parts();
                let off = (exact - Dyadic::from_f64(pair.high) - Dyadic::from_f64(pair.low)).abs();
                prop_assert!(off <= Dyadic::from_f64(error), "{error}");
                let magnitude: f64 = vectors.iter().zip(coefficients).map(|(v, c)| (c * v[k]).abs()).sum();
                prop_assert!(error <= 1e-27 * magnitude + 1e-268, "{error} {magnitude}");
                let bits = |sum: &BoundedDoubleDouble| {
                    let (pair, error) = sum.parts();
                    [pair.high, pair.low, error].map(f64::to_bits)
                };
                prop_assert!(found.iter().all(|sums| bits(&sums[k]) == bits(&found[0][k])));
            }
        }
    }

    /// All coefficients are 1/2 but for one of 1/4: the sum is known to the last bit.
    #[test]
    fn signs_and_products_worked_out_by_hand() {
        let vectors: Vec<[f64; 3]> = (0..105).map(|i| [1.0, f64::from(i), power_of_two(-60)]).collect();
        let coefficients: Vec<f64> = (0..105).map(|i| if i == 20 { 0.25 } else { 0.5 }).collect();
        let found = combined_sum(Rows::new(&vectors), &coefficients).map(|sum| sum.parts().0.high);
        assert_eq!(found, [52.25, 2725.0, 52.25 * power_of_two(-60)]);
    }

    #[test]
    fn overflow_and_coefficients_beyond_one_leave_nothing_known() {
        for count in [3, 80] {
            let [sum, ..] = combined_sum(Rows::new(&vec![[f64::MAX; 3]; count]), &vec![1.0; count]);
            assert!(sum.sign().is_none());
            for (usual, last) in [(0.5, 1.5), (1.5, 0.5), (f64::NAN, f64::NAN), (0.5, f64::NAN)] {
                let mut coefficients = vec![usual; count];
                coefficients[count - 1] = last;
                let sums = combined_sum(Rows::new(&vec![[1.0; 3]; count]), &coefficients);
                assert!(sums.iter().all(|sum| !sum.is_known()), "{usual} {last}");
            }
        }
    }

    /// Each block has one vector that is not zero: the sum of the first two is the tail, and the third is what the tail
    /// has no room for.
    #[test]
    fn what_rounding_the_tail_leaves_behind_is_kept() {
        let terms = [1.0, power_of_two(-60), power_of_two(-120), -1.0];
        let blocks = terms.iter().flat_map(|term| std::iter::once([*term; 3]).chain(vec![[0.0; 3]; BLOCK - 1]));
        let vectors: Vec<[f64; 3]> = blocks.collect();
        let [sum, ..] = combined_sum(Rows::new(&vectors), &vec![1.0; vectors.len()]);
        assert_eq!(sum.to_dyadic(), Dyadic::from_f64(terms[1]) + Dyadic::from_f64(terms[2]));
        assert!(sum.is_known());
    }

    #[test]
    fn a_common_magnitude_is_that_of_two_neighbours_among_the_first() {
        let with_pair = |at: usize, count: u8| {
            let mut coefficients: Vec<f64> = (0..count).map(|i| f64::from(i) / 100.0).collect();
            coefficients[at..at + 2].copy_from_slice(&[0.9, -0.9]);
            common_magnitude(&coefficients)
        };
        assert_eq!([with_pair(0, 64), with_pair(7, 64), with_pair(7, 80)], [Some(0.9); 3]);
        assert_eq!([with_pair(8, 64), with_pair(0, 63)], [None; 2]);
    }
}
