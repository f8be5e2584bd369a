//! From a point to the vertex at which Σ |a x + b y + c| is least, along lines, in doubles.
//!
//! Each line search ends where the slope changes its sign, found by selection among the crossings ahead. What it ends in is checked by
//! others; here rounding may at worst end the search at the wrong vertex.

use super::lines::Lines;

/// The most line searches.
const SEARCHES: usize = 40;

/// A crossing of the searched line: where, and half of what the slope gains there.
#[derive(Debug, Clone, Copy)]
struct Crossing {
    position: f64,
    weight: f64,
    line: usize,
}

/// Why a search ends without a vertex.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Stop {
    /// There is no line, or none that crosses the one that is searched.
    NoVertex,
    /// Many lines meet near a vertex, and rounding does not tell which to follow.
    Undecided,
}

/// The two lines through the optimal vertex of linear · x + Σ |a x + b y + c|, searched from a point near it.
pub(super) fn descend(lines: &Lines, linear: [f64; 2], start: [f64; 2]) -> Result<[usize; 2], Stop> {
    let mut line = nearest(lines, start).ok_or(Stop::NoVertex)?;
    let mut point = start;
    let mut before = usize::MAX;
    let mut ahead = Vec::with_capacity(lines.len());
    for _ in 0..SEARCHES {
        let (other, vertex) = search(lines, linear, line, point, &mut ahead).ok_or(Stop::NoVertex)?;
        point = vertex;
        // the slope along the other line at the vertex, without the two lines through it
        let [mut gx, mut gy] = linear;
        for (i, [a, b, c, _]) in lines.iter().enumerate() {
            if i != line && i != other {
                let sign = f64::copysign(1.0, a * point[0] + b * point[1] + c);
                gx += sign * a;
                gy += sign * b;
            }
        }
        let ([a, b, ..], [other_a, other_b, ..]) = (lines.line(line), lines.line(other));
        let (dx, dy) = (-other_b, other_a);
        let turn = (a * dx + b * dy).abs();
        if (gx * dx + gy * dy).abs() <= turn {
            return Ok([line, other]);
        }
        // least along both lines: where rounding would go on, it goes in circles
        if other == before {
            return Ok([line, other]);
        }
        (before, line) = (line, other);
    }
    Err(Stop::Undecided)
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
    let mut slope = linear[0] * dx + linear[1] * dy;
    for (i, [a, b, c, _]) in lines.iter().enumerate() {
        if i != line {
            slope += f64::copysign(1.0, a * foot[0] + b * foot[1] + c) * (a * dx + b * dy);
        }
    }
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

/// The first crossing at which the weights up to it reach `target`; the last one if they never do.
fn select(crossings: &mut [Crossing], target: f64) -> Option<Crossing> {
    let mut range = crossings;
    let mut missing = target;
    while range.len() > 1 {
        let middle = (range.len() - 1) / 2;
        range.select_nth_unstable_by(middle, |a, b| a.position.total_cmp(&b.position).then(a.line.cmp(&b.line)));
        let below: f64 = range[..=middle].iter().map(|c| c.weight).sum();
        if below >= missing {
            range = &mut range[..=middle];
        } else {
            missing -= below;
            range = &mut range[middle + 1..];
        }
    }
    range.first().copied()
}
