//! Unit vectors that are spread evenly, along a spiral.

/// The golden angle in turns: the part of a turn between one vector and the next.
const GOLDEN_TURN: f64 = 0.381_966_011_250_105_1;

/// Unit vectors above the equator, along a spiral: each stands for the same area.
pub fn spread_over_hemisphere(count: usize) -> Vec<[f64; 3]> {
    (0..count).map(|index| on_spiral(index, (index as f64 + 0.5) / count as f64)).collect()
}

/// Unit vectors along a spiral from pole to pole: each stands for the same area.
pub fn spread_over_sphere(count: usize) -> Vec<[f64; 3]> {
    (0..count).map(|index| on_spiral(index, (2.0 * index as f64 + 1.0) / count as f64 - 1.0)).collect()
}

fn on_spiral(index: usize, height: f64) -> [f64; 3] {
    let (sine, cosine) = libm::sincos(std::f64::consts::TAU * GOLDEN_TURN * index as f64);
    let radius = (1.0 - height * height).sqrt();
    [radius * cosine, radius * sine, height]
}
