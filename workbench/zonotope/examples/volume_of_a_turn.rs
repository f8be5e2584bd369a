//! A zonotope around everywhere that a turning body comes: by Theorem 6.1, by tighter methods, and in parts.

use zonotope::motion::space_time::{Method, Sweep, volumes_of_intervals};
use zonotope::zonotope::combinatorics;
use zonotope::{Motion, Zonotope};

/// Parts of the angle, each with a volume of its own.
const PARTS: u32 = 8;

/// The volume of a body, rounded.
fn volume_of(body: &Zonotope<3>) -> f64 {
    combinatorics(body).measure.to_f64_fast()
}

/// Encloses, prints and asserts.
pub fn main() {
    let generators = vec![[0.8, 0.1, 0.0], [0.0, 0.4, 0.1], [0.1, 0.0, 0.3], [0.2, 0.2, 0.2]];
    let body = Zonotope::new([1.0, 0.0, 0.0], generators).expect("the coordinates are finite");
    // a radian about the z axis
    let (point, axis, angle) = ([0.0; 3], [0.0, 0.0, 1.0], 1.0);
    let motion = Motion::constant_rate(point, axis, angle, [0.0; 3]).expect("the axis is not zero");
    let around = body.swept(&motion).expect("the volume is within the range of doubles");
    assert!(around.generators().len() >= body.generators().len() + 2);

    // every placement is inside, so is a corner of the body at a moment between
    let pose = motion.pose_at(0.7).expect("the placement is within the range of doubles");
    let (own, moved) = (body.support([1.0, 2.0, 3.0]).point(), pose.translation());
    let corner = [0, 1, 2].map(|i| (0..3).map(|k| pose.matrix()[i][k] * own[k]).sum::<f64>() + moved[i]);
    assert!(around.contains(corner).expect("the point is finite"));

    let sweep = Sweep::new(point, axis, angle, [0.0; 3]).expect("the axis is not zero");
    for method in Method::ALL {
        let volume = body.swept_by(&sweep, method).expect("the volume is within the range of doubles");
        println!("{:<60} {:.3}", method.title(), volume_of(&volume));
        assert!(volume.contains(corner).expect("the point is finite"));
    }

    // the angle in parts: each volume is nearer to the body, and one of them holds the corner
    let parts = volumes_of_intervals(&sweep, &body, PARTS, Method::ByMiddlePlacement).expect("within the range");
    let whole = volume_of(&around);
    assert!(parts.iter().all(|part| volume_of(part) < whole));
    assert!(parts.iter().any(|part| part.contains(corner).expect("the point is finite")));
}
