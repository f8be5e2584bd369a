//! Along given directions: the smallest zonotope whose generators point along the axes and the diagonals of space.

use zonotope::enclosing::along_directions;
use zonotope::enclosing::fixed_directions::Enclosure;

/// Asks, prints and asserts.
pub fn main() {
    // an octahedron that leans over
    let points =
        [[4.0, 4.0, 4.0], [-4.0, -4.0, -4.0], [1.0, -1.0, 0.0], [-1.0, 1.0, 0.0], [0.0, 1.0, -1.0], [0.0, -1.0, 1.0]];
    let directions = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [1.0, 1.0, 1.0], [1.0, -1.0, 0.0]];
    let answer = along_directions(&points, &directions).expect("the numbers are finite");
    let best = answer.optimal().expect("the directions span space");
    println!("total length {}, and none is below {}", best.value, best.lower_bound);
    assert!(best.lower_bound <= best.value && best.relative_gap() < 1e-12);

    for point in points {
        assert_eq!(best.body.contains(point), Ok(true));
    }

    // along the axes alone the long diagonal is dear
    let boxed = along_directions(&points, &directions[..3]).expect("the numbers are finite");
    assert!(boxed.optimal().is_some_and(|boxed| boxed.value > best.value));

    // along two axes there is no zonotope around the points, and the answer says why
    let flat = along_directions(&points, &directions[..2]).expect("the numbers are finite");
    assert!(matches!(flat, Enclosure::Infeasible(_)));
}
