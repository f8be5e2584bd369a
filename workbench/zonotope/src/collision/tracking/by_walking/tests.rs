//! Cubes by hand, and small bodies of whole numbers beside the twins.

use super::WalkingTracker;
use crate::arrangement::facet_walk::WalkError;
use crate::collision::brute_force::locate;
use crate::collision::distance::FeatureKind;
use crate::collision::distance::brute_force::nearest_point;
use crate::collision::{Query, Status};
use crate::zonotope::Zonotope;
use proptest::prelude::*;

fn cube() -> Zonotope<3> {
    Zonotope::new([0.0; 3], vec![[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]).expect("finite")
}

#[test]
fn a_cube_goes_around_a_cube() {
    let mut tracker = WalkingTracker::new(&cube(), &cube()).expect("cubes are solid");
    let cases = [
        ([5.0, 0.0, 0.0], Status::Outside, 9.0, Some(FeatureKind::Facet)),
        ([5.0, 6.0, 1.0], Status::Outside, 25.0, Some(FeatureKind::Edge)),
        ([3.0, 4.0, -4.0], Status::Outside, 9.0, Some(FeatureKind::Vertex)),
        ([3.0, 2.0, 0.0], Status::Outside, 1.0, Some(FeatureKind::Edge)),
        ([2.0, 2.0, -2.0], Status::Boundary, 0.0, None),
        ([2.0, 0.5, 0.0], Status::Boundary, 0.0, None),
        ([2.0, 0.5, 0.0].map(|c: f64| c.next_down()), Status::Inside, 0.0, None),
        ([0.0; 3], Status::Inside, 0.0, None),
        ([0.0, 0.0, 2.0f64.next_up()], Status::Outside, f64::EPSILON * f64::EPSILON * 4.0, Some(FeatureKind::Facet)),
    ];
    for (place, status, square, kind) in cases {
        let frame = tracker.frame([0.0; 3], place).expect("finite");
        assert_eq!((frame.status(), frame.squared_distance(), frame.closest()), (status, square, kind), "{place:?}");
        assert_eq!(frame.location().status(), status, "{place:?}");
    }
}

#[test]
fn what_cannot_be_tracked_is_refused() {
    let flat = Zonotope::new([0.0; 3], vec![[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]).expect("finite");
    assert!(matches!(WalkingTracker::new(&flat, &flat), Err(WalkError::Flat { rank: 2 })));
    let mut tracker = WalkingTracker::new(&flat, &cube()).expect("the sum is solid");
    let message = tracker.frame([0.0; 3], [0.0, f64::NAN, 0.0]).map(drop).map_err(|error| error.to_string());
    assert_eq!(message, Err("the end's coordinate 1 is NaN, not a finite number".to_owned()));
}

fn small() -> impl Strategy<Value = [f64; 3]> {
    proptest::array::uniform3((-2i32..3).prop_map(f64::from))
}

properties! {
    #![proptest_config(crate::property_cases::config(100))]

    #[test]
    fn walks_find_the_nearest_point_of_bodies_in_special_position(
        generators in proptest::collection::vec(small(), 3..6),
        places in proptest::collection::vec(proptest::array::uniform3((-14i32..15).prop_map(f64::from)), 4),
    ) {
        let (first, second) = generators.split_at(2);
        let body = |part: &[[f64; 3]]| Zonotope::new([0.0; 3], part.to_vec()).expect("finite");
        let Ok(mut tracker) = WalkingTracker::new(&body(first), &body(second)) else { return Ok(()) };
        for place in places {
            let frame = tracker.frame([0.5, 0.0, 0.0], place).expect("finite");
            let query = Query::new([0.5, 0.0, 0.0], place, &generators).expect("finite");
            prop_assert_eq!(frame.exact_squared_distance(), nearest_point(&query).squared_distance);
            prop_assert_eq!(frame.status(), locate(&query).status());
        }
    }
}
