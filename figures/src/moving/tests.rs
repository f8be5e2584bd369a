//! Pictures of motions of every outcome.

use zonotope::motion::Motion;
use zonotope::motion::continuous::first_contact as found;
use zonotope::zonotope::Zonotope;

use super::{first_contact, swept};

const CUBE: [[f64; 3]; 3] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];

fn cube(center: [f64; 3], size: f64) -> Zonotope<3> {
    Zonotope::new(center, CUBE.map(|g| g.map(|c| size * c)).to_vec()).expect("finite")
}

fn drawn(center: [f64; 3], motion: &Motion) -> String {
    let (a, b, rest) = (cube([0.0; 3], 1.0), cube(center, 1.0), Motion::rest());
    let answer = found([&a, &b], [motion, &rest]);
    first_contact(["a", "b"], [&a, &b], [motion, &rest], &answer).expect("ordinary sizes")
}

#[test]
fn every_outcome_has_its_words_and_its_times() {
    let right = Motion::translation([8.0, 0.0, 0.0]).expect("finite");
    let apart = drawn([0.0, 5.0, 0.0], &right);
    assert!(apart.contains("Disjoint during the whole step: one direction proves it"), "{apart}");
    assert!(["time 0", "time 0.333", "time 0.667", "time 1"].iter().all(|time| apart.contains(time)));
    assert!(!apart.contains(">contact<"));
    let met = drawn([6.0, 0.0, 0.0], &right);
    assert!(met.contains("The bodies meet at the time 0.5, and not before"), "{met}");
    assert!(met.contains(">contact<") && met.contains("time 0.5"));
    let at_start = drawn([1.0, 0.0, 0.0], &right);
    assert!(at_start.contains("The bodies meet at the start") && !at_start.contains("direction that separates"));
}

#[test]
fn a_direction_that_turns_with_a_body_is_named() {
    let turn = Motion::constant_rate([0.0; 3], [0.0, 0.0, 1.0], 3.0, [0.0; 3]).expect("an axis");
    let bar =
        Zonotope::new([2.0, 0.0, 0.0], vec![[2.0, 0.0, 0.0], [0.0, 0.05, 0.0], [0.0, 0.0, 0.05]]).expect("finite");
    let (other, follows) = (cube([3.0, 1.7, 0.0], 1.0), turn.clone());
    let answer = found([&bar, &other], [&turn, &follows]);
    let picture = first_contact(["bar", "cube"], [&bar, &other], [&turn, &follows], &answer).expect("ordinary sizes");
    assert!(picture.contains("turning with"), "{picture}");
}

#[test]
fn bodies_far_from_the_origin_look_as_they_do_near_it() {
    let picture = |at: f64| {
        let turn = Motion::constant_rate([at, 0.0, 0.0], [0.0, 0.0, 1.0], 1.0, [0.0; 3]).expect("an axis");
        let body = cube([at + 2.0, 0.0, 0.0], 1.0);
        let volume = body.swept(&turn).expect("in range");
        swept("a", &body, &turn, &volume).expect("ordinary sizes").matches("polygon").count()
    };
    assert_eq!(picture(0.0), picture(1024.0));
}

#[test]
fn sizes_that_have_no_picture_are_refused() {
    for size in [1e-200, 1e200] {
        let body = cube([0.0; 3], size);
        let away = Motion::translation([4.0 * size, 0.0, 0.0]).expect("finite");
        let volume = body.swept(&away).expect("in range");
        let refused = swept("a", &body, &away, &volume).expect_err("no picture");
        assert!(refused.to_string().contains("is not drawn"), "{refused}");
    }
}
