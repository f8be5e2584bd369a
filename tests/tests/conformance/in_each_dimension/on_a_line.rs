//! Answers about bodies of the line against sums of their generators, exactly: there a body is an interval, and every
//! question has an answer of one line.

use std::cmp::Ordering;

use families::drawn::numbers::{any_magnitude, lattice, nudged, plain};
use proptest::prelude::*;
use zonotope::Zonotope;
use zonotope::collision::{Query, Status, by_lad};
use zonotope::numeric::dyadic::Dyadic;
use zonotope::reduction::hausdorff;

/// A centre and generators; points at the ends of the interval, an ulp beside them, or anywhere.
#[derive(Debug, Clone)]
struct Interval {
    center: f64,
    generators: Vec<f64>,
}

impl Interval {
    fn body(&self) -> Zonotope<1> {
        Zonotope::new([self.center], self.generators.iter().map(|g| [*g]).collect()).expect("finite")
    }

    /// Σ |g|, exactly.
    fn reach(&self) -> Dyadic {
        self.generators.iter().fold(Dyadic::zero(), |sum, g| &sum + &Dyadic::from_f64(g.abs()))
    }
}

fn interval() -> impl Strategy<Value = Interval> {
    let number = || prop_oneof![plain(), lattice(), any_magnitude()];
    (number(), proptest::collection::vec(number(), 0..6))
        .prop_map(|(center, generators)| Interval { center, generators })
}

/// Whether a double is a number within two units in the last place; below the normal doubles, within two of the
/// smallest one.
fn is_near(value: f64, exact: &Dyadic) -> bool {
    let off = (&Dyadic::from_f64(value) - exact).abs();
    let unit = (value.abs() * f64::EPSILON).max(f64::from_bits(1));
    off <= Dyadic::from_f64(unit).scaled(1)
}

tests::properties! {
    1_200;

    #[test]
    fn gauges_and_positions_are_those_of_intervals(
        interval in interval(), step in -2i64..3, share in prop_oneof![Just(1.0), Just(-1.0), -2.0..2.0f64]
    ) {
        let (reach, center) = (interval.reach(), Dyadic::from_f64(interval.center));
        let point = nudged(interval.center + share * reach.to_f64(), step);
        prop_assume!(point.is_finite());
        let generators: Vec<[f64; 1]> = interval.generators.iter().map(|g| [*g]).collect();
        let query = Query::new([interval.center], [point], &generators).expect("finite");
        let offset = (&Dyadic::from_f64(point) - &center).abs();
        let status = match offset.cmp(&reach) {
            Ordering::Less => Status::Inside,
            Ordering::Equal => Status::Boundary,
            Ordering::Greater => Status::Outside,
        };
        prop_assert_eq!(by_lad::locate(&query, &mut ()).status(), status);
        let gauge = by_lad::nearest_gauge(&query, &mut ());
        let truth = match (offset.is_zero(), reach.is_zero()) {
            (true, _) => 0.0,
            (false, true) => f64::INFINITY,
            (false, false) => offset.rounded_ratio(&reach),
        };
        if (f64::MIN_POSITIVE..f64::MAX).contains(&truth) {
            prop_assert!((gauge.value - truth).abs() <= 2.0 * f64::EPSILON * truth, "{} is not {truth}", gauge.value);
        } else {
            prop_assert!(gauge.value == truth || gauge.error >= (gauge.value - truth).abs(), "{} {truth}", gauge.value);
        }
    }

    #[test]
    fn distances_are_those_of_intervals(first in interval(), second in interval()) {
        let (a, b) = (first.body(), second.body());
        let apart = (&Dyadic::from_f64(second.center) - &Dyadic::from_f64(first.center)).abs();
        let (own, other) = (first.reach(), second.reach());
        let gap = &apart - &(&own + &other);
        let distance = a.distance(&b);
        if gap.sign().is_gt() && distance.is_finite() {
            prop_assert!(is_near(distance, &gap), "{distance} is not {}", gap.to_f64());
        } else if !gap.sign().is_gt() {
            prop_assert_eq!(distance, 0.0);
        }
        let depth = a.penetration(&b);
        if gap.sign().is_lt() {
            let truth = -gap;
            prop_assert!(Dyadic::from_f64(depth.lower) <= truth);
            prop_assert!(!depth.upper.is_finite() || truth <= Dyadic::from_f64(depth.upper));
        } else {
            prop_assert_eq!((depth.lower, depth.upper), (0.0, 0.0));
        }
        let farthest = &apart + &(&own - &other).abs();
        let found = hausdorff::hausdorff(&a, &b, 0.01);
        prop_assert!(Dyadic::from_f64(found.lower) <= farthest);
        prop_assert!(!found.upper.is_finite() || farthest <= Dyadic::from_f64(found.upper));
        if farthest.to_f64() < f64::MAX / 4.0 {
            prop_assert!(is_near(found.value, &farthest), "{found:?} is not {}", farthest.to_f64());
        }
    }
}
