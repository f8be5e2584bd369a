//! Along given directions: the smallest zonotope whose generators point along the axes and the diagonals of space.

use zonotope::enclosing::fixed_directions::{FixedDirections, min_length_along};

/// Asks, prints and asserts.
pub fn main() {
    // an octahedron that leans over
    let points =
        [[4.0, 4.0, 4.0], [-4.0, -4.0, -4.0], [1.0, -1.0, 0.0], [-1.0, 1.0, 0.0], [0.0, 1.0, -1.0], [0.0, -1.0, 1.0]];
    let directions = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [1.0, 1.0, 1.0], [1.0, -1.0, 0.0]];
    let lengths = directions.map(|v| v.iter().map(|c| c * c).sum::<f64>().sqrt());

    let problem = FixedDirections::new(&points, &directions, &lengths).expect("the numbers are finite");
    let answer = min_length_along(&problem).expect("the answer fits in doubles");
    let directed = answer.optimal().expect("the directions span space");
    println!("total length {}, and none is below {}", directed.value, directed.lower_bound);
    assert!(directed.lower_bound <= directed.value && directed.relative_gap() < 1e-12);

    let body = directed.zonotope(&problem).expect("the generators fit in doubles");
    for point in points {
        assert_eq!(body.contains(point), Ok(true));
    }

    // along the axes alone the long diagonal is dear
    let boxed = FixedDirections::new(&points, &directions[..3], &lengths[..3]).expect("the numbers are finite");
    let boxed = min_length_along(&boxed).expect("the answer fits in doubles");
    assert!(boxed.optimal().is_some_and(|boxed| boxed.value > directed.value));
}
