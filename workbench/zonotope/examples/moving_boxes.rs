//! Intersection in a loop: a box that turns passes a box that stands; the poses move, the generators stay where they
//! are.

use zonotope::{Pose, PoseError, Zonotope};

/// How many instants are looked at.
const INSTANTS: u32 = 200;

/// Half a side of both boxes.
const HALF_SIDE: f64 = 1.0;

fn pose_at(instant: u32) -> Result<Pose, PoseError> {
    let time = f64::from(instant) / f64::from(INSTANTS - 1);
    Pose::from_axis_angle([0.0, 0.0, 1.0], 2.0 * time, [8.0 * time - 4.0, 0.5, 0.0])
}

/// Asks, prints and asserts.
pub fn main() {
    let axes = vec![[HALF_SIDE, 0.0, 0.0], [0.0, HALF_SIDE, 0.0], [0.0, 0.0, HALF_SIDE]];
    let cube = Zonotope::new([0.0; 3], axes).expect("the coordinates are finite");

    let meets: Vec<bool> = (0..INSTANTS)
        .map(|instant| cube.at(&pose_at(instant).expect("the pose is finite")).intersects(&cube))
        .collect();

    let first = meets.iter().position(|meets| *meets).expect("the boxes meet on the way");
    let last = meets.iter().rposition(|meets| *meets).expect("the boxes meet on the way");
    println!("the boxes meet from instant {first} to instant {last} of {INSTANTS}");
    assert!(!meets[0] && !meets[meets.len() - 1], "they begin and end apart");
    assert!(meets[first..=last].iter().all(|meets| *meets), "they meet without a break");
}
