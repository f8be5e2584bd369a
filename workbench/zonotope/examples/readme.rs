//! The first steps, word for word as the project's README shows them.

use std::error::Error;

use zonotope::enclosing::min_area;
use zonotope::{Location, Zonotope};

/// Asks and asserts.
pub fn main() {
    first_steps().expect("the coordinates are finite");
}

fn first_steps() -> Result<(), Box<dyn Error>> {
    let square = Zonotope::new([0.0, 0.0], vec![[1.0, 0.0], [0.0, 1.0]])?; // centre and generators
    assert!(square.contains([1.0, 0.5])?); // closed, and exact
    assert!(matches!(square.locate([3.0, 0.5])?, Location::Outside(_))); // with a direction that separates
    assert_eq!(square.gauge([3.0, 0.5])?.value, 3.0); // it holds the point when it is three times as large

    let answer = min_area(&[[0.0, 0.0], [2.0, 0.0], [0.0, 2.0]])?;
    assert_eq!((answer.value, answer.lower_bound), (4.0, 4.0)); // nothing smaller holds the triangle
    Ok(())
}
