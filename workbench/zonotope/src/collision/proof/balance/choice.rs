//! The generators whose coefficients absorb a rest: one by one, each as far as possible from the span of those before,
//! so that what they absorb changes their coefficients little. Nothing rests on the choice but whether there is room.

use crate::numeric::linear::{add_multiple, dot};
use crate::numeric::scaling::{binary_exponent, scale_by_power_of_two};

/// The number of generators from which three are chosen where a part of all will do.
const SAMPLE: usize = 16;

/// A residual below this part of the vector is what rounding left of a member of the span.
const RESIDUAL_ROUNDING: f64 = 1e-13;

/// Some of all generators, evenly spread over the list, from which three may be chosen.
pub(crate) fn sampled(count: usize) -> impl Iterator<Item = usize> {
    (0..count).step_by(count.div_ceil(SAMPLE).max(1))
}

/// The candidate that is farthest from the plane through the origin with a normal, of equal ones the first; none if all
/// are in the plane.
#[inline]
pub(crate) fn farthest_from_plane(
    normal: &[f64; 3],
    candidates: impl Iterator<Item = usize>,
    generator: impl Fn(usize) -> [f64; 3],
) -> Option<usize> {
    let heights = candidates.map(|i| (dot(&generator(i), normal).abs(), i));
    let (height, index) = heights.fold((0.0, 0), |best, own| if own.0 > best.0 { own } else { best });
    (height > 0.0).then_some(index)
}

/// Three of some generators, chosen in turn for how far they lead out of the span of those before; none if all of them
/// nearly are in a plane.
pub(crate) fn well_spread(
    candidates: impl Iterator<Item = usize>,
    generator: impl Fn(usize) -> [f64; 3],
) -> Option<[usize; 3]> {
    let candidates: Vec<usize> = candidates.collect();
    let chosen = roomy(candidates.iter().map(|&i| generator(i)).collect(), |_| 1.0);
    <[usize; 3]>::try_from(chosen).ok().map(|places| places.map(|place| candidates[place]))
}

/// At most D vectors, independent in floating point, chosen in turn for the room that their coefficients have times how
/// far they lead out of the span of those before. Each axis is taken in terms of the largest coordinate along it.
pub(crate) fn roomy<const D: usize>(mut left: Vec<[f64; D]>, room: impl Fn(usize) -> f64) -> Vec<usize> {
    for axis in 0..D {
        let scale = left.iter().filter_map(|v| binary_exponent(v[axis])).max().map_or(0, i64::from);
        left.iter_mut().for_each(|v| v[axis] = scale_by_power_of_two(v[axis], -scale));
    }
    let length = |v: &[f64; D]| dot(v, v).sqrt();
    let least: Vec<f64> = left.iter().map(|v| RESIDUAL_ROUNDING * length(v)).collect();
    let mut chosen = Vec::with_capacity(D);
    while chosen.len() < D {
        let key = |i: usize| if length(&left[i]) > least[i] { room(i) * length(&left[i]) } else { 0.0 };
        let keyed = (0..left.len()).map(|i| (key(i), i));
        let (key, best) = keyed.fold((0.0, 0), |best, own| if own.0 > best.0 { own } else { best });
        if key == 0.0 {
            break;
        }
        chosen.push(best);
        let size = length(&left[best]);
        let axis = left[best].map(|c| c / size);
        for vector in &mut left {
            let along = dot(vector, &axis);
            add_multiple(vector, -along, &axis);
        }
        left[best] = [0.0; D];
    }
    chosen
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn three_that_span_space_are_chosen_by_hand() {
        let body = [[1.0, 0.0, 0.0], [3.0, 0.0, 0.0], [3.0, 1.0, 0.0], [2.0, 2.0, 0.0], [1.0, 1.0, 1e-9]];
        let spread = |body: &[[f64; 3]]| well_spread(0..body.len(), |i| body[i]);
        // along z all but the last are 0, so that it is as far from the plane of the others as any could be
        assert_eq!(spread(&body), Some([4, 1, 3]));
        assert_eq!(spread(&body[..4]), None);
        assert_eq!(spread(&[]), None);
        let sizes = [1e40, 1e-30, 1e5];
        let uneven = [[1.0, 2.0, 3.0], [-1.0, 0.5, 0.25], [2.0, 0.1, -1.0]];
        let uneven = [0, 1, 2].map(|i| uneven[i].map(|c: f64| c * sizes[i]));
        assert_eq!(spread(&uneven), Some([0, 2, 1]));
        assert_eq!(farthest_from_plane(&[0.0, 0.0, -1.0], 0..5, |i| body[i]), Some(4));
        assert_eq!(farthest_from_plane(&[0.0, 0.0, -1.0], 0..4, |i| body[i]), None);
    }

    #[test]
    fn coefficients_at_their_ends_have_no_room() {
        let square = vec![[1.0, 0.0], [0.0, 1.0], [0.5, 0.5]];
        let room = |shares: [f64; 3]| roomy(square.clone(), |i| 1.0 - f64::abs(shares[i]));
        assert_eq!(room([1.0, 0.0, 0.0]), [1, 2]);
        assert_eq!(room([1.0, 1.0, 0.5]), [2]);
        assert_eq!(room([0.0, 0.25, 0.5]), [0, 1]);
    }
}
