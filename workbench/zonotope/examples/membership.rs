//! Membership: points are inside, on the boundary or outside of a body in space, exactly and with a proof.

use zonotope::{Location, Status, Zonotope};

/// Asks, prints and asserts.
pub fn main() {
    // the rhombic dodecahedron |x| + |y| ≤ 4, |y| + |z| ≤ 4, |x| + |z| ≤ 4
    let diagonals = vec![[1.0, 1.0, 1.0], [1.0, 1.0, -1.0], [1.0, -1.0, 1.0], [-1.0, 1.0, 1.0]];
    let body = Zonotope::new([0.0; 3], diagonals).expect("the coordinates are finite");

    let cases = [
        ([1.0, 1.0, 1.0], Status::Inside),
        ([2.0, 2.0, 0.5], Status::Boundary),
        ([2.0, 2.0f64.next_up(), 0.5], Status::Outside),
    ];
    for (point, status) in cases {
        let location = body.locate(point).expect("the point is finite");
        assert_eq!(location.status(), status);
        // a coefficient for each generator is written when it is asked for
        match location.expand() {
            Location::Inside(witness) | Location::Boundary(witness) => {
                assert!(witness.coefficients.iter().all(|coefficient| coefficient.abs() <= 1.0));
                println!("{point:?} is {status}: its coefficients are {:?}", witness.coefficients);
            }
            Location::Outside(separation) => println!("{point:?} is {status}: {separation:?}"),
        }
    }

    let refused = body.contains([0.0, f64::NAN, 0.0]).expect_err("NaN is no coordinate");
    assert_eq!(refused.to_string(), "the end's coordinate 1 is NaN, not a finite number");
}
