//! The lines by doubles and by pairs of doubles against the exact ones.

use std::cmp::Ordering;

use super::*;
use crate::hull::antipodal::farthest_vertices;
use crate::hull::convex_hull;
use crate::lad::kernel_input::ExactLines;

/// A regular polygon, whose lines nearly meet, made thin along one axis.
fn ellipse(corners: u32, height: f64) -> ConvexHull {
    let angle = |k: u32| f64::from(k) * std::f64::consts::TAU / f64::from(corners);
    let points: Vec<[f64; 2]> = (0..corners).map(|k| [libm::cos(angle(k)), height * libm::sin(angle(k))]).collect();
    convex_hull(&points, &mut ()).expect("the points are finite")
}

#[test]
fn certain_signs_are_those_of_exact_values() {
    for (corners, height) in [(30, 1.0), (64, 1.0), (31, 1e-6), (40, 1e-300)] {
        let hull = ellipse(corners, height);
        let farthest = farthest_vertices(&hull, &mut ());
        let lines = Lines { hull: &hull, farthest: &farthest, frame: Bisectors::new(&hull, &farthest).frame };
        let count = hull.edge_count();
        let (mut told, mut asked) = (0, 0);
        for t in 0..count {
            let (first, second) = (lines.line(t), lines.line((t + count / 3) % count));
            let mut point = first.meet(&second);
            if point[2].sign().is_lt() {
                point = point.map(|c| -c);
            }
            let at_infinity = [point[0].clone(), point[1].clone(), Dyadic::zero()];
            for place in [point, at_infinity] {
                let signs = lines.certain_signs(&place);
                for other in 0..count {
                    let exact = lines.line(other).evaluate(&place).sign() as i8;
                    assert!(signs(other).is_none_or(|sign| sign == exact), "{corners} {height:e} {t} {other}");
                    asked += i32::from(exact != 0);
                    told += i32::from(signs(other).is_some());
                }
            }
        }
        assert!(10 * told >= 9 * asked, "{told} of {asked} for {corners} corners of height {height:e}");
    }
}

#[test]
fn a_sum_of_edges_is_that_of_its_corners() {
    let hull = ellipse(12, 1.0);
    let farthest = farthest_vertices(&hull, &mut ());
    let lines = Lines { hull: &hull, farthest: &farthest, frame: Bisectors::new(&hull, &farthest).frame };
    let signs = [1, 1, -1, -1, -1, 0, 1, 1, 1, 1, -1, 1];
    let mut terms = signs.into_iter().enumerate().filter(|(_, sign)| *sign != 0);
    let one_by_one = terms.clone().fold([Dyadic::zero(), Dyadic::zero()], |[x, y], (t, sign)| {
        let [a, b] = lines.line(t).normal;
        if sign > 0 { [x + a, y + b] } else { [x - a, y - b] }
    });
    assert_eq!(lines.signed_normal_sum(&mut terms), one_by_one);
    let all = lines.signed_normal_sum(&mut (0..12).map(|t| (t, 1)));
    assert_eq!(all, [Dyadic::zero(), Dyadic::zero()]);
}

#[test]
fn meeting_points_and_values_by_pairs_are_near_the_exact_ones() {
    let mut known = 0;
    for (corners, height) in [(5, 1.0), (7, 1e-300), (30, 1.0), (31, 1e-6), (64, 1e300)] {
        let hull = ellipse(corners, height);
        let farthest = farthest_vertices(&hull, &mut ());
        let lines = Bisectors::new(&hull, &farthest).lines();
        let count = hull.edge_count();
        for t in 0..count {
            let other = (t + 1 + count / 3) % count;
            let [x, y, w] = lines.line(t).meet(&lines.line(other));
            let Some(place) = lines.meeting_point(t, other).filter(|_| !w.is_zero()) else { continue };
            known += 1;
            for (pair, exact) in place.iter().zip([&x, &y]) {
                let off = (pair.to_dyadic() * w.clone() - exact.clone()).abs();
                assert!(off <= Dyadic::from_f64(pair.parts().1) * w.clone(), "{corners} {height:e} {t}");
            }
            let exact_place = [place[0].to_dyadic(), place[1].to_dyadic(), Dyadic::one()];
            let at = place.map(|pair| BoundedDoubleDouble::of_parts(pair.parts().0.high, pair.parts().0.low, 0.0));
            let value = lines.value_near(0, &at).expect("the frame does not round the points");
            let off = (value.to_dyadic() - lines.line(0).evaluate(&exact_place)).abs();
            assert!(off <= Dyadic::from_f64(value.parts().1));
        }
    }
    // Lines of a regular polygon often meet so near to the reference that pairs of doubles do not know the point.
    assert!(known > 20, "{known} points are known");
}

#[test]
fn certain_rates_are_the_signs_of_exact_sums() {
    for (corners, height) in [(5, 1.0), (12, 1e-300), (31, 1e-6)] {
        let hull = ellipse(corners, height);
        let farthest = farthest_vertices(&hull, &mut ());
        let lines = Bisectors::new(&hull, &farthest).lines();
        let count = hull.edge_count();
        for turned in 0..count {
            let mut signs = vec![1; count];
            signs[turned] = -1;
            signs[(3 * turned + 1) % count] = 0;
            let terms = signs.iter().enumerate().filter(|(_, sign)| **sign != 0).map(|(t, &sign)| (t, sign));
            let [x, y] = lines.signed_normal_sum(&mut terms.collect::<Vec<_>>().into_iter());
            for along in 0..count {
                let [dx, dy] = lines.line(along).direction();
                let exact = (&x * &dx + &y * &dy).sign();
                assert!(lines.certain_rate(&signs, along).is_none_or(|rate| rate == exact), "{turned} {along}");
            }
        }
        let all_but_one = |t: usize| (0..count).map(|other| i8::from(other != t)).collect::<Vec<i8>>();
        assert!((0..count).all(|t| lines.certain_rate(&all_but_one(t), t) == Some(Ordering::Equal)));
    }
}
