//! The least total length around a mesh: the vertices of an OBJ file, read in a few lines, and the zonotope around
//! them.

use zonotope::enclosing::min_length;

/// A roof over a square: the ridge is shorter than the eaves.
const ROOF: &str = "\
v -2 -1 0
v 2 -1 0
v 2 1 0
v -2 1 0
v -1 0 1.5
v 1 0 1.5
f 1 2 6 5
f 3 4 5 6
f 2 3 6
f 4 1 5
f 4 3 2 1
";

/// The precision that is asked for.
const EPSILON: f64 = 1e-6;

fn vertices(obj: &str) -> Vec<[f64; 3]> {
    let rows = obj.lines().filter_map(|line| line.strip_prefix("v "));
    rows.map(|row| {
        let numbers: Vec<f64> = row.split_whitespace().map(|word| word.parse().expect("a number")).collect();
        <[f64; 3]>::try_from(numbers).expect("three coordinates")
    })
    .collect()
}

/// Asks, prints and asserts.
pub fn main() {
    let points = vertices(ROOF);
    assert_eq!(points.len(), 6);

    let answer = min_length(&points, EPSILON).expect("the points are finite");
    println!("total length {}, at most {} times the least", answer.value, answer.ratio());
    assert!(answer.lower_bound <= answer.value && answer.ratio() <= 1.0 + EPSILON);
    for &point in &points {
        assert_eq!(answer.body.contains(point), Ok(true));
    }

    // the box around the roof is a zonotope, too: half-lengths 2, 1 and 3/4
    assert!(answer.value < 2.0 + 1.0 + 0.75 + 1e-6);
}
