//! The weighted median, by brackets that a sample proposes.
//!
//! # Statement
//! Input: items with places, none of them NaN, and weights that are not negative, in two columns of one length below
//! 2^32; a target. Output: the index of the first item, by place and then by index, at which the weights up to it and
//! with it reach the target; of the last item if they never do; none of no items.
//!
//! # Source
//! Selection by a sample: Floyd and Rivest, Expected time bounds for selection, Comm. ACM 18 (1975) 165. Departures:
//! weights take the place of ranks; the items are never moved, so one pass with wide vectors sums up what lies below
//! the bracket and lists what lies inside.
//!
//! # Method
//! 1. At most `HALVING_LIMIT` items: by halving.
//! 2. Sort some n^(2/3) items, one from each of as many stretches of the list, and take the places that the median is
//!    probably between: where the weights of the sample reach its share of the target, less and more a few standard
//!    deviations.
//! 3. In one pass sum up the weights of the items below that bracket, and list the items inside. If the target is not
//!    reached inside, list the items on the other side of the bracket instead.
//! 4. If all listed items have one place, they are in the order of their indices: add their weights up. If nearly all
//!    items are listed, go on by halving. Else go to 1 with the list.
//!
//! # Complexity
//! n items: expected O(n), one pass over all and some n^(2/3) items after it; the worst case is that of halving, O(n)
//! expected. Space O(n^(2/3)) expected.
//!
//! # Shapes
//! `places`, `weights`: n each, in any order, ties allowed, infinite places allowed.
//!
//! # Numerics
//! Sums of doubles are rounded, so the answer is a guess wherever the sum is near the target; where all sums are exact,
//! so is the answer. The zeros of both signs are one place. The bits of the answer are the same at every level of
//! vector instructions.
//!
//! # Panics
//! If the columns differ in length.
//!
//! # Checked by
//! The method that sorts, on ties, weights of zero and of all magnitudes, equal places.

use fearless_simd::{Simd, dispatch, f64x8, prelude::*};

use super::by_halving::{self, Item};
use crate::numeric::lanes::bit_places::{WORD, places_of};
use crate::numeric::lanes::level::level;
use crate::numeric::lanes::octet::{LANES, total};
use crate::numeric::reused::{Reused, keep_lists_of};

/// Number of items up to which halving is quicker than a sample.
const HALVING_LIMIT: usize = 500;

/// Standard deviations of the sample's weights between the median that it proposes and the ends of the bracket.
const BRACKET_DEVIATIONS: f64 = 2.0;

/// The multiplier and the increment of the linear congruential generator (Knuth's MMIX) that draws the sample.
const GENERATOR: [u64; 2] = [6_364_136_223_846_793_005, 1_442_695_040_888_963_407];

keep_lists_of!(Item, (f64, f64));

/// The index of the weighted median.
pub(crate) fn weighted_median(places: &[f64], weights: &[f64], target: f64) -> Option<usize> {
    assert_eq!(places.len(), weights.len(), "every place has a weight");
    if places.len() <= HALVING_LIMIT {
        return by_halving::weighted_median(&mut items(places, weights), target);
    }
    let mut missing = target;
    let mut inside = narrowed(places, weights, &mut missing);
    loop {
        let len = inside.places.len();
        let index = |listed: Option<usize>| listed.map(|listed| inside.indices[listed] as usize);
        if inside.is_one_place {
            return index(first_reaching(&inside.weights, missing));
        }
        if len <= HALVING_LIMIT || inside.is_nearly_all {
            return index(by_halving::weighted_median(&mut items(&inside.places, &inside.weights), missing));
        }
        let mut within = narrowed(&inside.places, &inside.weights, &mut missing);
        within.indices.iter_mut().for_each(|index| *index = inside.indices[*index as usize]);
        inside = within;
    }
}

fn items(places: &[f64], weights: &[f64]) -> Reused<Item> {
    let columns = (0..).zip(places).zip(weights);
    columns.map(|((index, &place), &weight)| Item::new(place, weight, index)).collect()
}

/// The first index up to which and with which the weights reach a target; the last one if they never do.
fn first_reaching(weights: &[f64], target: f64) -> Option<usize> {
    let mut sum = 0.0;
    let reached = weights.iter().position(|weight| {
        sum += weight;
        sum >= target
    });
    reached.or(weights.len().checked_sub(1))
}

/// The items between two places, both included, in the order of their indices.
struct Listed {
    places: Reused<f64>,
    weights: Reused<f64>,
    indices: Reused<u32>,
    /// Whether all of them have the same place.
    is_one_place: bool,
    /// Whether they are nearly all of the items that they were taken from.
    is_nearly_all: bool,
}

/// The items among which the median is, at least one; the weights of those before them are taken off what is missing.
fn narrowed(places: &[f64], weights: &[f64], missing: &mut f64) -> Listed {
    let [low, high] = bracket(places, weights, *missing);
    let (below, inside) = listed(places, weights, [low, high]);
    let up_to_high = below + inside.weights.iter().sum::<f64>();
    if low > f64::NEG_INFINITY && below >= *missing {
        let (_, before) = listed(places, weights, [f64::NEG_INFINITY, low.next_down()]);
        if !before.places.is_empty() {
            return before;
        }
    } else if high < f64::INFINITY && up_to_high < *missing {
        let (_, behind) = listed(places, weights, [high.next_up(), f64::INFINITY]);
        if !behind.places.is_empty() {
            *missing -= up_to_high;
            return behind;
        }
    }
    *missing -= below;
    inside
}

/// Two places that the median is probably between, both included; infinite where the sample leaves a side open.
fn bracket(places: &[f64], weights: &[f64], missing: f64) -> [f64; 2] {
    let n = places.len() as u64;
    let size = libm::pow(n as f64, 2.0 / 3.0) as u64;
    // places in units of 2^-32, so that one division does for all
    let step = (n << 32) / size;
    let mut state = GENERATOR[1];
    let draw = |stretch: u64| {
        state = state.wrapping_mul(GENERATOR[0]).wrapping_add(GENERATOR[1]);
        let drawn = ((stretch * step + (step >> 16) * (state >> 48)) >> 32) as usize;
        (places[drawn], weights[drawn])
    };
    let mut sample: Reused<(f64, f64)> = (0..size).map(draw).collect();
    sample.sort_unstable_by(|a, b| a.0.total_cmp(&b.0));
    let target = missing * (size as f64 / n as f64);
    let (mut sum, mut squares) = (0.0, 0.0);
    for (_, weight) in &sample {
        if sum >= target {
            break;
        }
        sum += weight;
        squares += weight * weight;
    }
    let slack = BRACKET_DEVIATIONS * squares.sqrt();
    let [mut low, mut high] = [f64::NEG_INFINITY, f64::INFINITY];
    sum = 0.0;
    for &(place, weight) in &sample {
        sum += weight;
        if sum < target - slack {
            low = place;
        }
        if sum > target + slack {
            high = place;
            break;
        }
    }
    [low, high]
}

/// The sum of the weights below a bracket, and the items inside. One pass.
fn listed(places: &[f64], weights: &[f64], bracket: [f64; 2]) -> (f64, Listed) {
    let mut indices = Reused::with_capacity(WORD);
    let below = dispatch!(level(), simd => list(simd, places, weights, bracket, &mut indices));
    let of = |column: &[f64]| indices.iter().map(|&index| column[index as usize]).collect();
    let is_nearly_all = 8 * indices.len() > 7 * places.len();
    let is_one_place = bracket[0] == bracket[1];
    (below, Listed { places: of(places), weights: of(weights), indices, is_one_place, is_nearly_all })
}

#[inline(always)]
fn list<S: Simd>(simd: S, places: &[f64], weights: &[f64], [low, high]: [f64; 2], indices: &mut Vec<u32>) -> f64 {
    let (lowest, highest, zero) = (f64x8::splat(simd, low), f64x8::splat(simd, high), f64x8::splat(simd, 0.0));
    let mut sums = zero;
    let mut room = [0; WORD];
    let mut first = 0;
    let ((place_words, last_places), (weight_words, last_weights)) =
        (places.as_chunks::<WORD>(), weights.as_chunks::<WORD>());
    for (places, weights) in place_words.iter().zip(weight_words) {
        let mut bits = 0;
        let octets = places.as_chunks::<LANES>().0.iter().zip(weights.as_chunks::<LANES>().0);
        for (k, (place, weight)) in octets.enumerate() {
            let (place, weight) = (f64x8::from_slice(simd, place), f64x8::from_slice(simd, weight));
            sums += place.simd_lt(lowest).select(weight, zero);
            bits |= (place.simd_ge(lowest) & place.simd_le(highest)).to_bitmask() << (LANES * k);
        }
        if bits != 0 {
            indices.extend_from_slice(places_of(bits, first, &mut room));
        }
        first += WORD as u32;
    }
    let mut below = total(sums);
    for ((index, place), weight) in (first..).zip(last_places).zip(last_weights) {
        below += if *place < low { *weight } else { 0.0 };
        if (low..=high).contains(place) {
            indices.push(index);
        }
    }
    below
}

#[cfg(test)]
mod tests {
    use super::super::brute_force;
    use super::*;
    use crate::numeric::lanes::level::at_each_level;
    use proptest::prelude::*;

    fn median(items: &[(f64, f64)], target: f64) -> Option<usize> {
        let (places, weights): (Vec<f64>, Vec<f64>) = items.iter().copied().unzip();
        weighted_median(&places, &weights, target)
    }

    #[test]
    fn by_hand() {
        let items = [(3.0, 1.0), (1.0, 2.0), (2.0, 4.0)];
        let found = [2.0, 2.5, 6.0, 6.5, 8.0].map(|target| median(&items, target));
        assert_eq!(found, [Some(1), Some(2), Some(2), Some(0), Some(0)]);
        assert_eq!(median(&items, -1.0), Some(1));
        assert_eq!(median(&[], 0.0), None);
    }

    /// Places that are spread, tied, all equal, infinite, sorted, or of all magnitudes.
    fn place(kind: usize) -> BoxedStrategy<f64> {
        match kind {
            0 => (-1e3..1e3f64).boxed(),
            1 => (-3i32..4).prop_map(f64::from).boxed(),
            2 => Just(2.5).boxed(),
            3 => prop_oneof![Just(f64::INFINITY), Just(f64::NEG_INFINITY), Just(0.0), Just(-0.0), -1.0..1.0f64].boxed(),
            _ => {
                (any::<bool>(), -1070i32..1023).prop_map(|(s, e)| if s { 2f64.powi(e) } else { -2f64.powi(e) }).boxed()
            }
        }
    }

    /// Weights whose sums are exact: small integers, zeros, all tiny, all huge, one that outweighs the others.
    fn weight(kind: usize) -> BoxedStrategy<f64> {
        let scaled = |scale: f64| (0u8..9).prop_map(move |w| scale * f64::from(w)).boxed();
        match kind {
            0 => scaled(1.0),
            1 => prop_oneof![9 => Just(0.0), 1 => Just(1.0)].boxed(),
            2 => scaled(f64::from_bits(1)),
            3 => scaled(2f64.powi(980)),
            4 => Just(0.0).boxed(),
            _ => prop_oneof![500 => (0u8..3).prop_map(f64::from), 1 => Just(2f64.powi(40))].boxed(),
        }
    }

    properties! {
        #![proptest_config(crate::property_cases::config(400))]

        #[test]
        fn it_is_what_sorting_finds(
            items in (0usize..5, 0usize..6).prop_flat_map(|(p, w)| {
                prop_oneof![proptest::collection::vec((place(p), weight(w)), 0..60),
                    proptest::collection::vec((place(p), weight(w)), 200..3000)]
            }),
            part in prop_oneof![0.0..1.2f64, Just(0.0), Just(1.0), Just(-1.0), Just(0.5)],
            is_sorted in any::<bool>(),
        ) {
            let mut items = items;
            if is_sorted {
                items.sort_by(|a, b| a.0.total_cmp(&b.0));
            }
            let total: f64 = items.iter().map(|item| item.1).sum();
            let target = (part * 1024.0).round() / 1024.0 * total;
            let (places, weights): (Vec<f64>, Vec<f64>) = items.into_iter().unzip();
            let truth = brute_force::weighted_median(&places, &weights, target);
            let found = at_each_level(|| weighted_median(&places, &weights, target));
            prop_assert!(found.iter().all(|own| *own == truth), "{:?} for {:?}", found, truth);
        }
    }

    #[test]
    fn targets_and_weights_that_are_no_numbers_end_the_search_all_the_same() {
        let places: Vec<f64> = (0..1000).map(f64::from).collect();
        for (weight, target) in [(1.0, f64::NAN), (f64::NAN, 3.0), (f64::INFINITY, f64::INFINITY)] {
            assert!(weighted_median(&places, &[weight; 1000], target).is_some());
        }
    }

    #[test]
    fn zeros_of_both_signs_are_one_place() {
        let items = [(0.0, 1.0), (-0.0, 1.0), (0.0, 1.0)];
        assert_eq!([0.5, 1.5, 3.0].map(|target| median(&items, target)), [Some(0), Some(1), Some(2)]);
    }

    /// Stretches of sixteen items, each of which gives one item to the sample.
    const STRETCHES: u32 = 255;

    /// The target 15 of the sample is reached after 15 items of the weight 1: two deviations of 3.87 around it.
    #[test]
    fn a_bracket_worked_out_by_hand() {
        let places: Vec<f64> = (0..16 * STRETCHES).map(|index| f64::from(index / 16)).collect();
        let of = |missing: f64| bracket(&places, &vec![1.0; places.len()], missing);
        assert_eq!(of(16.0 * 15.0), [6.0, 22.0]);
        // two deviations of exactly 4: a sum of 8 or 24 is not yet outside
        assert_eq!(of(16.0 * 16.0), [6.0, 24.0]);
        // four times the weights make sums and deviations four times as large
        assert_eq!(bracket(&places, &vec![4.0; places.len()], 64.0 * 15.0), [6.0, 22.0]);
        assert_eq!([of(16.0)[0], of(16.0 * 254.0)[1]], [f64::NEG_INFINITY, f64::INFINITY]);
    }

    #[test]
    fn places_that_repeat_with_the_stretches_are_drawn_all_the_same() {
        let places: Vec<f64> = (0..16 * STRETCHES).map(|index| f64::from(index % 16)).collect();
        let [low, high] = bracket(&places, &vec![1.0; places.len()], f64::from(8 * STRETCHES));
        assert!((4.0..=7.0).contains(&low) && (7.0..12.0).contains(&high), "{low} {high}");
    }

    #[test]
    fn nearly_all_are_more_than_seven_eighths() {
        let places: Vec<f64> = (0..16).map(f64::from).collect();
        let is_nearly_all = |high: f64| listed(&places, &[1.0; 16], [0.0, high]).1.is_nearly_all;
        assert_eq!([12.0, 13.0, 14.0].map(is_nearly_all), [false, false, true]);
    }

    /// Items that are drawn, and those that are not, have all the weight: the bracket is on one side of the median, or
    /// just beside it.
    #[test]
    fn a_sample_that_misleads_leads_to_the_median_all_the_same() {
        let places: Vec<f64> = (0..600).map(f64::from).collect();
        let of = |index: usize| {
            let mut weights = vec![0.0; places.len()];
            weights[index] = 1.0;
            weights
        };
        // an item that is drawn reaches a target, and leaves all below it open
        let is_drawn = |index: usize| bracket(&places, &of(index), 1.0)[0] == f64::NEG_INFINITY;
        let drawn: Vec<bool> = (0..places.len()).map(is_drawn).collect();
        for value in [true, false] {
            let weights: Vec<f64> = drawn.iter().map(|own| f64::from(u8::from(*own == value))).collect();
            for target in 0..=602 {
                let target = f64::from(target);
                let truth = brute_force::weighted_median(&places, &weights, target);
                assert_eq!(weighted_median(&places, &weights, target), truth, "{value} {target}");
            }
        }
        for index in (0..places.len()).step_by(7) {
            assert_eq!(weighted_median(&places, &of(index), 1.0), Some(index));
        }
    }

    #[test]
    fn beyond_all_weights_the_last_of_the_infinite_places_is_told() {
        let places: Vec<f64> = (0..1000).map(|k| if k % 5 == 0 { f64::INFINITY } else { f64::from(k) }).collect();
        for target in [999.0, 1000.0, 1001.0, 1100.0] {
            let truth = brute_force::weighted_median(&places, &[1.0; 1000], target);
            assert_eq!(weighted_median(&places, &[1.0; 1000], target), truth, "{target}");
        }
    }
}
