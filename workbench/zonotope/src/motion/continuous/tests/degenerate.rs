//! Bodies without an inside, equal bodies, contacts that last, and numbers at the ends of the range of doubles.

use super::{FirstContact, first_contact};
use crate::motion::continuous::by_control_points::{first_contact_counted, first_contact_within};
use crate::motion::{Motion, MotionPiece};
use crate::tally::{Operation, OperationCounts};
use crate::zonotope::Zonotope;

fn body(center: [f64; 3], generators: &[[f64; 3]]) -> Zonotope<3> {
    Zonotope::new(center, generators.to_vec()).expect("finite")
}

const CUBE: [[f64; 3]; 3] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];

fn contact_time(found: &FirstContact) -> Option<[f64; 2]> {
    match found {
        FirstContact::Contact { time, .. } => Some(*time),
        _ => None,
    }
}

#[test]
fn bodies_without_an_inside_meet_when_they_must() {
    let cube = body([3.0, 0.0, 0.0], &CUBE);
    let shapes: [&[[f64; 3]]; 3] = [&[], &[[0.0, 1.0, 0.0]], &[[0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]];
    for shape in shapes {
        // its face is reached half way
        let motion = Motion::translation([4.0, 0.0, 0.0]).expect("finite");
        let found = first_contact([&body([0.0; 3], shape), &cube], [&motion, &Motion::rest()]);
        let time = contact_time(&found).unwrap_or_else(|| panic!("{found:?}"));
        assert!(time[0] < 0.5 && 0.5 <= time[1] && time[1] - time[0] <= 2f64.powi(-30), "{time:?}");
        let away = Motion::translation([-4.0, 0.0, 0.0]).expect("finite");
        let found = first_contact([&body([0.0; 3], shape), &cube], [&away, &Motion::rest()]);
        assert_eq!(found.name(), "separate");
    }
}

#[test]
fn bodies_that_touch_at_the_start_meet_at_the_time_zero() {
    let (a, b) = (body([0.0; 3], &CUBE), body([2.0, 0.0, 0.0], &CUBE));
    for motion in [Motion::rest(), Motion::translation([-1.0, 0.0, 0.0]).expect("finite")] {
        let found = first_contact([&a, &b], [&motion, &Motion::rest()]);
        assert_eq!(contact_time(&found), Some([0.0; 2]));
        let found = first_contact([&a, &a], [&motion, &motion]);
        assert_eq!(contact_time(&found), Some([0.0; 2]), "equal bodies meet");
    }
}

/// A cube that docks at the end of a step, or is in the other one there by less than a stretch of time shows.
#[test]
fn bodies_that_meet_at_the_end_of_a_step_meet() {
    let (cube, other) = (body([0.0; 3], &CUBE), body([6.0, 0.0, 0.0], &CUBE));
    for exponent in [-60, -42, -38, -34, -30, -26, -20] {
        let over = if exponent == -60 { 0.0 } else { 2f64.powi(exponent) };
        let right = Motion::translation([4.0 * (1.0 + over), 0.0, 0.0]).expect("finite");
        for resolution in [2f64.powi(-30), 2f64.powi(-50)] {
            let found = first_contact_within([&cube, &other], [&right, &Motion::rest()], resolution);
            let time = contact_time(&found).unwrap_or_else(|| panic!("{exponent}: {found:?}"));
            let exact = 1.0 / (1.0 + over);
            assert!(time[0] <= exact && exact <= time[1].next_up() && time[1] - time[0] <= resolution, "{time:?}");
        }
    }
    // the first part of a motion ends in contact
    let part = |until, x| MotionPiece {
        until,
        from: [1.0, 0.0, 0.0, 0.0],
        to: [1.0, 0.0, 0.0, 0.0],
        axis_point: [0.0; 3],
        translation: [x, 0.0, 0.0],
    };
    for second in [4.0, 0.0, -4.0] {
        let two = Motion::from_pieces(&[part(0.5, 4.0), part(1.0, second)]).expect("a motion");
        let time = contact_time(&first_contact([&cube, &other], [&two, &Motion::rest()]));
        assert!(time.is_some_and(|[before, met]| before < 0.5 && met == 0.5), "{time:?}");
    }
}

/// Bodies that slide along each other, or turn face to face, at a distance of so much. A turn at constant rate is off
/// across its axis alone, and where nothing else moves not at all, so that it takes few stretches as well.
#[test]
fn a_turn_by_no_angle_parts_no_bodies() {
    let no_turn = |point, axis| Motion::constant_rate(point, axis, 0.0, [0.0; 3]).expect("an axis");
    let square = body([0.0; 3], &[[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]);
    let on_its_edge = body([1.0, 0.0, 0.0], &[]);
    let resting = [no_turn([100.0, 0.0, 0.0], [0.0, 1.0, 0.0]), no_turn([0.0; 3], [0.0, 0.0, 1.0])];
    assert_ne!(first_contact([&square, &on_its_edge], resting.each_ref()).name(), "separate");
    // half a turn takes a point to within 1e-16 of a segment's end, and of a point
    let half = |point, axis| Motion::constant_rate(point, axis, std::f64::consts::PI, [0.0; 3]).expect("an axis");
    let (origin, segment) = (body([0.0; 3], &[]), body([0.0, 2.0, 0.0], &[[0.0, 1.5, 0.0]]));
    let turning = half([0.5, 0.25, 0.0], [1.0, 0.0, 0.0]);
    let found = first_contact([&origin, &segment], [&turning, &no_turn([0.0; 3], [0.0, 0.0, 1.0])]);
    assert_ne!(found.name(), "separate", "the segment begins where the point ends");
    let turning = half([1.0, 0.0, 0.0], [0.0, 1.0, 0.0]);
    let other = body([2.0, 0.0, 0.0], &[]);
    assert_ne!(first_contact([&origin, &other], [&turning, &resting[1]]).name(), "separate");
}

#[test]
fn a_contact_that_lasts_ends_the_search_soon() {
    for distance in [0.0, 1e-15, 1e-14, 1e-12, 1e-10] {
        let (a, b) = (body([0.0; 3], &CUBE), body([5.0, 2.0 + distance, 0.0], &CUBE));
        let slide = Motion::translation([10.0, 0.0, 0.0]).expect("finite");
        let turn = Motion::constant_rate([0.0; 3], [0.0, 1.0, 0.0], 7.0, [0.0; 3]).expect("an axis");
        let screw = Motion::constant_rate([0.0; 3], [0.0, 1.0, 0.0], 7.0, [5.0, 0.0, 0.0]).expect("an axis");
        for (motion, place, most) in [(slide, 5.0, 200), (turn, 0.5, 200), (screw, 5.0, 200)] {
            let b = b.translated([place - 5.0, 0.0, 0.0]).expect("finite");
            let mut counts = OperationCounts::default();
            let found = first_contact_counted([&a, &b], [&motion, &Motion::rest()], 2f64.powi(-30), &mut counts);
            let stretches = counts.get(Operation::Stretch);
            assert!(stretches <= most, "{distance} {stretches} {}", found.name());
            if let FirstContact::Grazing { distance_at_most, .. } = found {
                assert!(distance <= distance_at_most && distance_at_most <= distance + 1e-9, "{distance_at_most}");
            }
        }
    }
}

#[test]
fn numbers_of_any_size_have_the_answer_of_ordinary_ones() {
    for size in [1e-300, 1e-160, 1e-10, 1e10, 1e150, 1e300] {
        let scaled = |list: &[[f64; 3]]| list.iter().map(|g| g.map(|c| c * size)).collect::<Vec<_>>();
        let cube = body([0.0; 3], &scaled(&CUBE));
        let bar = body([3.0 * size, 0.0, 0.0], &scaled(&[[1.5, 0.0, 0.0], [0.0, 0.1, 0.0], [0.0, 0.0, 0.1]]));
        let turn =
            Motion::constant_rate([3.0 * size, 0.0, 0.0], [0.0, 1.0, 1.0], 9.0, [size, 0.0, 0.0]).expect("an axis");
        assert_eq!(first_contact([&bar, &cube], [&turn, &Motion::rest()]).name(), "separate", "{size}");
        let pass = Motion::translation([-4.0 * size, 0.0, 0.0]).expect("finite");
        let found = first_contact([&bar, &cube], [&pass, &Motion::rest()]);
        let time = contact_time(&found).unwrap_or_else(|| panic!("{size}: {found:?}"));
        assert!((time[1] - 0.125).abs() < 1e-8, "{size} {time:?}");
    }
}
