//! The outline of a trapezoid in a window, rounded, for pictures.

use super::trapezoid::{Trapezoid, Wall};
use crate::arrangement::{LineArrangement, LineIndex};

impl Trapezoid {
    /// The corners of the part in the window from `low` to `high`, counter-clockwise; none where the trapezoid lies
    /// beside the window. `lines` are those of the cutting.
    pub fn outline(&self, lines: &LineArrangement<'_>, [low, high]: [[f64; 2]; 2]) -> Vec<[f64; 2]> {
        let mut corners = vec![low, [high[0], low[1]], high, [low[0], high[1]]];
        let abscissa = |wall: &Wall| match wall {
            Wall::Through([a, b]) => {
                let [x, _, w] = lines.exact_line(*a).meet(&lines.exact_line(*b));
                x.ratio(&w)
            }
            Wall::Along(line) => {
                let line = lines.exact_line(*line);
                -line.offset.ratio(&line.normal[0])
            }
        };
        if let Some(x) = self.left.as_ref().map(abscissa) {
            corners = clipped(&corners, |corner| corner[0] - x);
        }
        if let Some(x) = self.right.as_ref().map(abscissa) {
            corners = clipped(&corners, |corner| x - corner[0]);
        }
        let height = |line: LineIndex| {
            let line = lines.exact_line(line);
            let [slope, at_zero] = [&line.normal[0], &line.offset].map(|value| -value.ratio(&line.normal[1]));
            move |corner: &[f64; 2]| corner[1] - (slope * corner[0] + at_zero)
        };
        if let Some(above) = self.bottom.map(height) {
            corners = clipped(&corners, above);
        }
        if let Some(above) = self.top.map(height) {
            corners = clipped(&corners, |corner| -above(corner));
        }
        corners
    }
}

/// The part of a convex polygon where a linear function is not negative.
fn clipped(corners: &[[f64; 2]], value: impl Fn(&[f64; 2]) -> f64) -> Vec<[f64; 2]> {
    let mut kept = Vec::with_capacity(corners.len() + 1);
    for (index, corner) in corners.iter().enumerate() {
        let next = &corners[(index + 1) % corners.len()];
        let [here, there] = [value(corner), value(next)];
        if here >= 0.0 {
            kept.push(*corner);
        }
        if (here > 0.0 && there < 0.0) || (here < 0.0 && there > 0.0) {
            let part = here / (here - there);
            kept.push([0, 1].map(|k| corner[k] + part * (next[k] - corner[k])));
        }
    }
    kept
}
