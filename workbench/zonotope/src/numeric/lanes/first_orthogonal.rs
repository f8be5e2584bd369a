//! The vectors that may be the first to become orthogonal to a direction that turns: one pass.

use fearless_simd::{Simd, dispatch, f64x8, prelude::*};

use super::blocks::Block;
use super::level::level;
use super::number::product;
use super::octet::{LANES, largest, slot, splat, turned};
use crate::numeric::tolerance::PRODUCT_WITH_TURNED_NORMAL as ERROR;

/// Less than any slope: products are below 2^4 and slopes are taken only of products above [`ERROR`].
const LOWEST_SLOPE: f64 = -1e18;

/// Of vectors v with largest coordinates in [1, 2): the places of all that may be the first to be orthogonal to a
/// direction that turns from `normal` towards `tangent`, by less than half a turn. In no order; of vectors that are
/// nearly orthogonal to the normal it is left open whether they come first.
///
/// `normal` and `tangent` have coordinates of at most 2, which round those of exact vectors: the products with the
/// vectors are off by less than [`ERROR`]. The direction turned by an angle φ is orthogonal to v where cot φ =
/// −(v · tangent) / (v · normal), so the vectors with the largest such slope come first. The pass keeps a lower bound
/// of the largest slope, and the octets that may exceed it: a quotient is taken for those alone.
pub(crate) fn first_orthogonal(blocks: &[Block], normal: &[f64; 3], tangent: &[f64; 3]) -> Vec<usize> {
    let mut octets = Vec::new();
    let lowest = dispatch!(level(), simd => candidate_octets(simd, blocks, [normal, tangent], &mut octets));
    let lanes = octets.iter().flat_map(|&octet| (0..LANES).map(move |lane| (octet, lane)));
    let may_be_first = |&(octet, lane): &(usize, usize)| {
        let v = blocks[octet].vector(lane);
        let (across, along) = (product(&v, normal), product(&v, tangent));
        let gain = if across.is_sign_negative() { along } else { -along };
        may_exceed(across.abs(), gain, lowest)
    };
    lanes.filter(may_be_first).map(|(octet, lane)| octet * LANES + slot(lane)).collect()
}

/// Whether gain / across may be above a bound, or `across` may be zero.
fn may_exceed(across: f64, gain: f64, bound: f64) -> bool {
    across <= ERROR || gain - bound * across >= -ERROR * (1.0 + bound.abs())
}

/// Collects the octets with a vector that may come first, and returns a lower bound of the largest slope.
#[inline(always)]
fn candidate_octets<S: Simd>(
    simd: S,
    blocks: &[Block],
    [normal, tangent]: [&[f64; 3]; 2],
    octets: &mut Vec<usize>,
) -> f64 {
    let (normal, tangent) = (splat(simd, normal), splat(simd, tangent));
    let (error, lowest) = (f64x8::splat(simd, ERROR), f64x8::splat(simd, LOWEST_SLOPE));
    let mut bound = LOWEST_SLOPE;
    let mut wide_bound = lowest;
    let mut margin = f64x8::splat(simd, -ERROR * (1.0 + bound.abs()));
    for (place, block) in blocks.iter().enumerate() {
        let v = block.load(simd);
        let across = product(&v, &normal);
        let gain = turned(simd, -product(&v, &tangent), across);
        let across = across.abs();
        let may_exceed = (gain - wide_bound * across).simd_ge(margin) | across.simd_le(error);
        if may_exceed.to_bitmask() == 0 {
            continue;
        }
        octets.push(place);
        // the least slope that the errors leave
        let least = gain - error;
        let slopes = least / (across + error.copysign(least));
        let certain = across.simd_gt(error + error).select(slopes, lowest);
        let highest = largest(certain);
        if highest > bound {
            bound = highest;
            wide_bound = f64x8::splat(simd, bound);
            margin = f64x8::splat(simd, -ERROR * (1.0 + bound.abs()));
        }
    }
    bound
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numeric::dyadic::Dyadic;
    use crate::numeric::exact_linear::{dot, exact};
    use crate::numeric::lanes::body_sums::laid_out;
    use crate::numeric::lanes::level::at_each_level;
    use proptest::prelude::*;

    fn coordinate() -> impl Strategy<Value = f64> {
        prop_oneof![2 => -1.0..1.0f64, 2 => (-2i32..3).prop_map(|c| f64::from(c) / 2.0), 1 => -1e-12..1e-12f64]
    }

    properties! {
        #![proptest_config(crate::property_cases::config(400))]

        #[test]
        fn none_that_comes_first_is_left_out(
            vectors in proptest::collection::vec([coordinate(), coordinate(), coordinate()], 1..60),
            axes in proptest::collection::vec(0usize..3, 60),
            [normal, tangent] in [(); 2].map(|()| [coordinate(), coordinate(), coordinate()]),
        ) {
            let vectors: Vec<[f64; 3]> = vectors
                .iter()
                .zip(axes)
                .map(|(v, axis)| { let mut v = *v; v[axis] = 1.5f64.copysign(v[axis]); v })
                .collect();
            // the slopes as numerators and positive denominators
            let slope = |v: &[f64; 3]| {
                let [across, along] = [normal, tangent].map(|u| dot(&exact(*v), &exact(u)));
                let is_positive = across.sign().is_gt();
                (!across.is_zero()).then(|| if is_positive { (-along, across) } else { (along, -across) })
            };
            let slopes: Vec<(usize, (Dyadic, Dyadic))> =
                vectors.iter().enumerate().filter_map(|(k, v)| Some((k, slope(v)?))).collect();
            let is_below = |a: &(Dyadic, Dyadic), b: &(Dyadic, Dyadic)| &a.0 * &b.1 < &b.0 * &a.1;
            let first = slopes.iter().filter(|(_, own)| !slopes.iter().any(|(_, other)| is_below(own, other)));
            let first: Vec<usize> = first.map(|(k, _)| *k).collect();
            let laid_out = laid_out(&vectors);
            for found in at_each_level(|| first_orthogonal(laid_out.blocks(), &normal, &tangent)) {
                prop_assert!(first.iter().all(|k| found.contains(k)), "{:?} are not all in {:?}", first, found);
            }
        }
    }

    #[test]
    fn what_comes_later_for_certain_is_left_out() {
        let vectors: Vec<[f64; 3]> = (0..40).map(|k| [1.0, f64::from(k) / 32.0, 1.0]).collect();
        // the slopes are −k / 32
        let found = first_orthogonal(laid_out(&vectors).blocks(), &[1.0, 0.0, 0.0], &[0.0, 1.0, 0.0]);
        assert_eq!(found, [0]);
    }

    #[test]
    fn a_slope_exceeds_a_bound_as_far_as_the_errors_leave_it_open() {
        // three errors are open at the bound 2
        let may_exceed_two = |errors: f64| may_exceed(1.0, 2.0 - errors * ERROR, 2.0);
        assert_eq!([1.0, 3.0, 3.5].map(may_exceed_two), [true, true, false]);
        assert!(!may_exceed(1.0, 0.5, 1.0) && may_exceed(1.0, -0.5, -1.0));
        // of a product that may be zero nothing is known
        assert!(may_exceed(ERROR, -1.0, 0.0) && !may_exceed(1.5 * ERROR, -1.0, 0.0));
    }

    /// Eight vectors of the slope 1, and eight of one below it: with both products off by the bound, those are at least
    /// 1 − 2 errors, and these at most four errors less than 1 and two more.
    #[test]
    fn slopes_that_the_errors_may_change_places_of_are_both_told() {
        let found = |sign: f64, errors: f64| {
            let vectors: Vec<[f64; 3]> =
                [1.0, 1.0 - sign * errors * ERROR].iter().flat_map(|gain| [[1.0, sign * gain, 1.5]; 8]).collect();
            let mut found = first_orthogonal(laid_out(&vectors).blocks(), &[1.0, 0.0, 0.0], &[0.0, -1.0, 0.0]);
            found.sort_unstable();
            found
        };
        for sign in [1.0, -1.0] {
            assert!(found(sign, 3.875).into_iter().eq(0..16), "{sign}");
            assert!(found(sign, 4.125).into_iter().eq(0..8), "{sign}");
        }
    }

    #[test]
    fn vectors_nearly_orthogonal_to_the_normal_are_told_however_low_their_slopes() {
        let vectors = [[1.0, ERROR * (1.0 + 1e-12), 1.5]; 8];
        let found = first_orthogonal(laid_out(&vectors).blocks(), &[0.0, 1.0, 0.0], &[1.0, 0.0, 0.0]);
        assert_eq!(found.len(), 8);
    }
}
