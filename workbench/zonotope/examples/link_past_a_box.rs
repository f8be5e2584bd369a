//! A robot's link that turns past a box: the proof that they never meet, checked by the verifier, and the time at which
//! they meet where the box is nearer.

use std::f64::consts::PI;

use verifier::{Encounter, FirstContactAnswer, FreeInterval, MovingBody, MovingDirection, check_first_contact};
use zonotope::motion::continuous::by_control_points::DEFAULT_RESOLUTION;
use zonotope::motion::continuous::{FirstContact, FreeStretch, SeparatingDirection, first_contact};
use zonotope::{Motion, Zonotope};

/// A box along the coordinate axes, by its half sides.
fn upright_box(center: [f64; 3], [x, y, z]: [f64; 3]) -> Zonotope<3> {
    let generators = vec![[x, 0.0, 0.0], [0.0, y, 0.0], [0.0, 0.0, z]];
    Zonotope::new(center, generators).expect("the coordinates are finite")
}

/// A stretch of time with its direction, as the verifier takes it.
fn interval(stretch: &FreeStretch) -> FreeInterval {
    let direction = match stretch.direction {
        SeparatingDirection::Space(u) => MovingDirection::Space(u),
        SeparatingDirection::First(u) => MovingDirection::A(u),
        SeparatingDirection::Second(u) => MovingDirection::B(u),
        SeparatingDirection::Edges(edges) => MovingDirection::Edges(edges),
    };
    FreeInterval { from: stretch.from, to: stretch.until, direction }
}

/// Asks, checks, prints and asserts.
pub fn main() {
    // half a turn about the joint at the origin
    let (joint, axis, still) = ([0.0; 3], [0.0, 0.0, 1.0], [0.0; 3]);
    let turn = Motion::constant_rate(joint, axis, PI, still).expect("the axis is not zero");
    let (link, far) = (upright_box([1.0, 0.0, 0.0], [1.0, 0.1, 0.1]), upright_box([0.0, 2.6, 0.0], [0.5; 3]));
    let found = first_contact([&link, &far], [&turn, &Motion::rest()]);
    let FirstContact::Separate { free } = &found else { unreachable!("the box is out of reach") };
    println!("no contact: {} directions prove it", free.len());

    // the verifier takes plain numbers and shares no code with the library
    let answer = FirstContactAnswer { encounter: Encounter::Separate, intervals: free.iter().map(interval).collect() };
    let turning = verifier::Motion::ConstantRate { axis_point: joint, axis, angle: PI, translation: still };
    let rows = [&link, &far].map(|body| body.generators().iter().map(|g| g.to_vec()).collect::<Vec<_>>());
    let moving = [
        MovingBody { center: &link.center(), generators: &rows[0], motion: &turning },
        MovingBody { center: &far.center(), generators: &rows[1], motion: &verifier::Motion::Rest },
    ];
    assert!(check_first_contact(moving, DEFAULT_RESOLUTION, &answer).is_right());

    let near = upright_box([0.0, 2.1, 0.0], [0.5; 3]);
    let found = first_contact([&link, &near], [&turn, &Motion::rest()]);
    let FirstContact::Contact { time: [from, to], .. } = found else { unreachable!("the link reaches the box") };
    println!("nearer: a contact between the times {from} and {to}");
    assert!(0.25 < from && to < 0.5 && to - from <= DEFAULT_RESOLUTION);
}
