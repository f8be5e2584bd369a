//! The first steps, word for word as the project's README shows them.

use std::error::Error;

use zonotope::enclosing::min_area;
use zonotope::motion::continuous::{FirstContact, first_contact};
use zonotope::{Motion, Zonotope};

/// Asks and asserts.
pub fn main() {
    first_steps().expect("the coordinates are finite");
}

fn first_steps() -> Result<(), Box<dyn Error>> {
    let square = Zonotope::new([0.0, 0.0], vec![[1.0, 0.0], [0.0, 1.0]])?; // centre and generators
    assert!(square.contains([1.0, 0.5])?); // closed, and exact
    assert!(square.locate([3.0, 0.5])?.separation().is_some()); // a direction that separates
    assert_eq!(square.gauge([3.0, 0.5])?.value, 3.0); // it holds the point when it is three times as large

    let answer = min_area(&[[0.0, 0.0], [2.0, 0.0], [0.0, 2.0]])?;
    assert_eq!((answer.value, answer.lower_bound), (4.0, 4.0)); // nothing smaller holds the triangle

    // a robot's link makes half a turn about the origin: nothing that it meets on its way is missed
    let link = Zonotope::new([1.0, 0.0, 0.0], vec![[1.0, 0.0, 0.0], [0.0, 0.1, 0.0], [0.0, 0.0, 0.1]])?;
    let block = Zonotope::new([0.0, 2.1, 0.0], vec![[0.5, 0.0, 0.0], [0.0, 0.5, 0.0], [0.0, 0.0, 0.5]])?;
    let turn = Motion::constant_rate([0.0; 3], [0.0, 0.0, 1.0], std::f64::consts::PI, [0.0; 3])?;
    let found = first_contact([&link, &block], [&turn, &Motion::rest()]); // with directions that prove the time before
    let FirstContact::Contact { time: [free, met], .. } = found else { unreachable!("they meet") };
    assert!(met - free < 1e-9 && format!("{met:.6}") == "0.384589"); // of the step, where link and corner touch
    Ok(())
}
