//! Prepared bodies have the answers of the bodies that they were made of.

use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;

use super::posed::check_proof;
use super::{FAMILIES, displacement, family};
use crate::collision::{Query, by_lad};
use crate::interop::verifier::check_location;
use crate::zonotope::pose::Pose;
use crate::zonotope::{Placed, PreparedBody, Zonotope};

/// The displacement, and the one that ends nearly on the boundary in the same direction.
fn ends(body: &Zonotope<3>, to: [f64; 3]) -> Vec<[f64; 3]> {
    let from = body.center();
    let gauge = body.gauge(to).expect("finite").value;
    let scaled = [0, 1, 2].map(|k| from[k] + (to[k] - from[k]) / gauge);
    let mut ends = vec![to];
    ends.extend(Some(scaled).filter(|end| end.iter().all(|c| c.is_finite())));
    ends
}

#[test]
fn points_are_located_alike() {
    let mut random = Pcg64Mcg::seed_from_u64(41);
    for name in FAMILIES {
        for n in [0, 1, 6, 15, 17, 40, 129, 321, 1100, 5000] {
            let generators = family::<3>(name, n, &mut random);
            let (from, to) = displacement(&generators, &mut random);
            let body = Zonotope::new(from, generators).expect("finite");
            let prepared = PreparedBody::new(body.clone());
            for end in ends(&body, to) {
                let query = Query::of_point_in(end, prepared.placed()).expect("finite");
                let location = by_lad::locate(&query, &mut ());
                let plain = by_lad::gauge(&Query::of_point(end, &body).expect("finite"), &mut ());
                let gauge = by_lad::gauge(&query, &mut ());
                assert!(check_location(&query, &location).is_right(), "{name} {n}");
                assert!(check_location(&query, &gauge.location).is_right(), "{name} {n}");
                assert_eq!(location.status(), plain.location.status(), "{name} {n}");
                let is_near = (gauge.value - plain.value).abs() <= gauge.error + plain.error;
                assert!(is_near || gauge.value == plain.value, "{name} {n}: {gauge:?} {plain:?}");
            }
        }
    }
}

#[test]
fn two_bodies_meet_alike() {
    let mut random = Pcg64Mcg::seed_from_u64(42);
    let turned = Pose::new([[0.6, -0.8, 0.0], [0.8, 0.6, 0.0], [0.0, 0.0, 1.0]], [0.1, 0.2, 0.3]).expect("finite");
    for name in FAMILIES {
        for [n, m] in [[3, 3], [5, 20], [130, 7], [400, 400], [3000, 1001]] {
            let [first, second] = [n, m].map(|n| family::<3>(name, n, &mut random));
            let all: Vec<[f64; 3]> = first.iter().chain(&second).copied().collect();
            let (from, to) = displacement(&all, &mut random);
            let first = Zonotope::new(from, first).expect("finite");
            let sum = Zonotope::new(from, all).expect("finite");
            for end in ends(&sum, to) {
                let second = Zonotope::new(end, second.clone()).expect("finite");
                let prepared = [&first, &second].map(|body| PreparedBody::new(body.clone()));
                let [a, b] = prepared.each_ref().map(PreparedBody::placed);
                let status = by_lad::locate(&Query::between(&first, &second), &mut ()).status();
                let pose = if random.random_bool(0.5) { Pose::IDENTITY } else { turned };
                let posed = by_lad::locate(&Query::of_placed(first.at(&turned), second.at(&pose)), &mut ()).status();
                for [a, b] in [[a, b], [Placed::from(&first), b], [a, Placed::from(&second)]] {
                    let query = Query::of_placed(a, b);
                    let location = by_lad::locate(&query, &mut ());
                    assert!(check_location(&query, &location).is_right(), "{name} {n} {m}");
                    assert_eq!(location.status(), status, "{name} {n} {m}");
                    let query = Query::of_placed(a.at(&turned), b.at(&pose));
                    let location = by_lad::locate(&query, &mut ());
                    check_proof(&query, &location);
                    assert_eq!(location.status(), posed, "posed {name} {n} {m}");
                }
            }
        }
    }
}
