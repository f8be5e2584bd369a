//! Order reduction: a zonotope of few generators around one of many, with the proof and how much larger it is.

use zonotope::Zonotope;
use zonotope::reduction::hausdorff::hausdorff;
use zonotope::reduction::{Method, Problem, contains};

/// The generators of the body, on three turns of a screw.
const COUNT: usize = 60;

/// The relative width of the interval in which the distance is asked for.
const WIDTH: f64 = 0.01;

/// Asks, prints and asserts.
pub fn main() {
    let generator = |i: usize| {
        let part = (i + 1) as f64 / COUNT as f64;
        let (height, radius) = (2.0 * part - 1.0, 1.0 - part * part / 2.0);
        let turn = 3 * i % COUNT;
        let corner = [[1.0, 0.25], [-0.25, 1.0], [0.75, -0.5]][turn % 3];
        [radius * corner[0], radius * corner[1], height]
    };
    let body = Zonotope::new([0.0; 3], (0..COUNT).map(generator).collect()).expect("the coordinates are finite");

    let mut last = f64::INFINITY;
    for count in [3, 6, 12, 24] {
        let problem = Problem::new(&body, count).expect("three generators span a body of space");
        let reduced = Method::Clusters.reduce(&problem).expect("the numbers are in range").body;
        assert!(reduced.generators().len() <= count);
        assert_eq!(contains(&reduced, &body), Some(true), "exactly");
        let distance = hausdorff(&body, &reduced, WIDTH);
        println!("{count} generators: {} to {} from the body", distance.lower, distance.upper);
        assert!(distance.lower < last, "more generators fit no worse here");
        last = distance.upper;
    }
}
