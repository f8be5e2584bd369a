//! Bodies under poses: the pose is a part of the question, exact as the numbers that it is made of.

use zonotope::{Pose, Status, Zonotope};

/// Asks, prints and asserts.
pub fn main() {
    let axes = vec![[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    let cube = Zonotope::new([0.0; 3], axes).expect("the coordinates are finite");

    // a rotation by rational numbers, with the sine 4/5 and the cosine 3/5, in doubles
    let turned = [[0.6, -0.8, 0.0], [0.8, 0.6, 0.0], [0.0, 0.0, 1.0]];
    let pose = Pose::new(turned, [2.5, 0.0, 0.0]).expect("the numbers are finite");
    let other = cube.at(&pose);

    // along x the turned cube reaches 1.4, so that the bodies are 0.1 apart
    let apart = other.intersection(&cube);
    let direction = apart.separation().expect("the bodies are disjoint");
    println!("disjoint along {direction:?}, at the distance {}", other.distance(&cube));
    assert!((other.distance(&cube) - 0.1).abs() < 1e-15);

    // a pose may scale, shear and reflect as well; generators stay where they are stored
    let stretched = Pose::new([[1.5, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, -1.0]], [2.5, 0.0, 0.0]);
    let touching = cube.at(&stretched.expect("the numbers are finite"));
    assert_eq!(touching.intersection(&cube).status(), Status::Boundary);

    // points are asked about where the pose puts the body
    assert!(other.contains([2.5 + 1.3, 0.1, 0.0]).expect("the point is finite"));
    assert_eq!(touching.gauge([4.0, 0.0, 0.0]).expect("the point is finite").value, 1.0);
}
