//! The zonogon of least area around points of the plane, with a lower bound that no zonogon around them can beat.

use zonotope::enclosing::min_area;

/// Asks, prints and asserts.
pub fn main() {
    // a regular heptagon, which no symmetry makes a zonogon
    let vertex = |k: u32| f64::from(k) * std::f64::consts::TAU / 7.0;
    let points: Vec<[f64; 2]> = (0..7).map(|k| [libm::cos(vertex(k)), libm::sin(vertex(k))]).collect();

    let answer = min_area(&points).expect("the points are finite");
    println!("area {}, and none has less than {}", answer.value, answer.lower_bound);
    assert!(answer.lower_bound <= answer.value && answer.relative_gap() < 1e-12);
    for &point in &points {
        assert_eq!(answer.body.contains(point), Ok(true));
    }

    // a zonogon around the heptagon that is no better: the box
    let low = points.iter().fold([f64::INFINITY; 2], |low, p| [low[0].min(p[0]), low[1].min(p[1])]);
    let high = points.iter().fold([f64::NEG_INFINITY; 2], |high, p| [high[0].max(p[0]), high[1].max(p[1])]);
    assert!(answer.value < (high[0] - low[0]) * (high[1] - low[1]));
}
