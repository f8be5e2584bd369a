//! From a point to the vertex at which Σ |a x + b y + c| is least, along lines, in doubles.
//!
//! Each line search ends where the slope changes its sign, found by selection among the crossings ahead. What it ends in is checked by
//! others; here rounding may at worst end the search at the wrong vertex.

use super::lines::Lines;
use super::median::{Crossing, select};

/// The most line searches.
const SEARCHES: usize = 40;

/// The most of them that do not move the vertex.
const STILL: usize = 2;

/// The two lines through the optimal vertex of linear · x + Σ |a x + b y + c|, searched from a point near it; none if no line crosses the one that is
/// searched. Where many lines meet, it may be a vertex along both of whose lines the objective rises, but not along another.
pub(super) fn descend(lines: &Lines, linear: [f64; 2], start: [f64; 2]) -> Option<[usize; 2]> {
    descend_along(lines, linear, start, nearest(lines, start)?)
}

/// The same, along a line first.
pub(super) fn descend_along(lines: &Lines, linear: [f64; 2], start: [f64; 2], mut line: usize) -> Option<[usize; 2]> {
    let mut point = start;
    let mut before = usize::MAX;
    let mut still = 0;
    let mut ahead = Vec::with_capacity(lines.len());
    for _ in 0..SEARCHES {
        let (other, vertex) = search(lines, linear, line, point, &mut ahead)?;
        still = if is_same(point, vertex) { still + 1 } else { 0 };
        point = vertex;
        let ([a, b, c, _], [other_a, other_b, ..]) = (lines.line(line), lines.line(other));
        let direction = [-other_b, other_a];
        // the slope along the other line at the vertex, without the two lines through it
        let turn = a * direction[0] + b * direction[1];
        let own = f64::copysign(1.0, a * point[0] + b * point[1] + c) * turn;
        let slope = lines.slope(linear, point, direction) - own;
        // where the line before comes again, or the vertex stays, rounding would go on in circles
        if slope.abs() <= turn.abs() || other == before || still > STILL {
            return Some([line, other]);
        }
        (before, line) = (line, other);
    }
    Some([before, line])
}

fn is_same(a: [f64; 2], b: [f64; 2]) -> bool {
    (a[0] - b[0]).abs() + (a[1] - b[1]).abs() <= 64.0 * f64::EPSILON * (b[0].abs() + b[1].abs())
}

fn nearest(lines: &Lines, [x, y]: [f64; 2]) -> Option<usize> {
    let distance = |[a, b, c, _]: [f64; 4]| {
        let value = a * x + b * y + c;
        value * value / (a * a + b * b)
    };
    let lines = lines.iter().enumerate().map(|(i, line)| (distance(line), i)).filter(|(d, _)| d.is_finite());
    lines.min_by(|a, b| a.0.total_cmp(&b.0)).map(|(_, i)| i)
}

/// The minimum along a line: the line that crosses it there, and where.
fn search(
    lines: &Lines,
    linear: [f64; 2],
    line: usize,
    [x, y]: [f64; 2],
    ahead: &mut Vec<Crossing>,
) -> Option<(usize, [f64; 2])> {
    let [a, b, c, _] = lines.line(line);
    let off = (a * x + b * y + c) / (a * a + b * b);
    let foot = [x - off * a, y - off * b];
    let (mut dx, mut dy) = (-b, a);
    // the line itself has no slope along itself
    let mut slope = lines.slope(linear, foot, [dx, dy]);
    if slope > 0.0 {
        (dx, dy, slope) = (-dx, -dy, -slope);
    }
    ahead.clear();
    for (i, [a, b, c, _]) in lines.iter().enumerate() {
        let value = a * foot[0] + b * foot[1] + c;
        let rate = a * dx + b * dy;
        // the sign that the slope was summed up with, also where the value is zero
        if i != line && f64::copysign(1.0, value) * rate < 0.0 {
            ahead.push(Crossing { position: -value / rate, weight: rate.abs(), line: i });
        }
    }
    let found = select(ahead, -slope / 2.0)?;
    Some((found.line, [foot[0] + found.position * dx, foot[1] + found.position * dy]))
}
