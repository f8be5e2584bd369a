//! The box along the axes around points, in doubles: the zonotope that there is whatever the numbers are.

use crate::numeric::dyadic::Dyadic;
use crate::numeric::outward::{at_least, axis_generators};
use crate::zonotope::Zonotope;

/// The box with a centre of doubles near its middle and the least half-sides that reach all points from there, and an
/// upper bound of the sum of the half-sides; `None` where that leaves the range of doubles. O(n).
pub(super) fn axis_box_around<const D: usize>(points: &[[f64; D]]) -> Option<(Zonotope<D>, f64)> {
    let sides: [(f64, f64); D] = std::array::from_fn(|c| {
        let (low, high) =
            points.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), p| (l.min(p[c]), h.max(p[c])));
        let center = low.midpoint(high);
        let reach = |end: f64| at_least(&(Dyadic::from_f64(end) - Dyadic::from_f64(center)).abs());
        (center, reach(low).max(reach(high)))
    });
    let body = Zonotope::new(sides.map(|(center, _)| center), axis_generators(sides.map(|(_, half)| half)).collect());
    let body = body.ok()?;
    let length = body.total_length();
    length.is_finite().then_some((body, length))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_box_of_any_numbers() {
        let least = f64::from_bits(1);
        let large = f64::MAX / 2.0;
        let points = [[0.0, large, 1.0], [least, -large, 1.0]];
        let (body, length) = axis_box_around(&points).expect("within the range");
        // the sum of the half-sides is rounded up
        assert_eq!((body.center(), length), ([0.0, 0.0, 1.0], large.next_up()));
        assert_eq!(body.generators(), [[least, 0.0, 0.0], [0.0, large, 0.0]]);
        assert!(points.iter().all(|&p| body.contains(p) == Ok(true)));
        assert!(axis_box_around(&[[f64::MAX, f64::MAX], [-f64::MAX, -f64::MAX]]).is_none());
    }
}
