//! Distance and depth: how far apart two bodies are, where they are nearest, and how deep they overlap.

use zonotope::Zonotope;
use zonotope::collision::distance::Proximity;

/// Asks, prints and asserts.
pub fn main() {
    let axes = vec![[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    let cube = Zonotope::new([0.0; 3], axes).expect("the coordinates are finite");

    // the corner (1, 1, 1) is nearest to the corner (4, 5, 1) of the second cube
    let apart = cube.translated([5.0, 6.0, 0.0]).expect("the sums are finite");
    assert_eq!(cube.distance(&apart), 5.0);
    let Proximity::Disjoint(gap) = cube.proximity(&apart) else { unreachable!("the distance is not zero") };
    let [[x, y, _], [u, v, _]] = gap.points;
    assert_eq!([x, y, u, v], [1.0, 1.0, 4.0, 5.0]);
    println!("distance {}, from {:?} to {:?}", gap.distance(), gap.points[0], gap.points[1]);

    // the square of a distance is rational, also where the distance is not
    let askew = cube.translated([3.0, 3.0, 3.0]).expect("the sums are finite");
    assert_eq!(cube.proximity(&askew).exact_squared_distance().to_string(), "3");

    // bodies that overlap: a motion by a half along x separates them, and none by less
    let overlapping = cube.translated([1.5, 0.25, 0.0]).expect("the sums are finite");
    let depth = cube.penetration(&overlapping);
    assert!(depth.lower <= 0.5 && 0.5 <= depth.upper);
    println!("depth between {} and {}, along {:?}", depth.lower, depth.upper, depth.direction);
}
