//! Descent from a point to the vertex at which Σ |a x + b y + c| is least, along lines, in doubles.
//!
//! Each line search ends where the slope changes its sign, which selection among the crossings ahead finds. Rounding
//! may make the descent end at a wrong vertex, no worse: the vertex is certified by others.

use crate::lad::of_generators::guess::crossings::CrossingList;
use crate::lad::of_generators::plane::rounded_lines::{LineBlock, RoundedLines};
use crate::numeric::lanes::octet::{LANES, slot};
use crate::numeric::reused::Reused;

/// The most line searches.
const LINE_SEARCH_LIMIT: usize = 40;

/// The most line searches that do not move the vertex.
const UNMOVED_LIMIT: usize = 2;

/// The number of lines, up to twice as many, from which the horizon of a line search is estimated: no crossing beyond
/// it is looked at.
const HORIZON_SAMPLE: usize = 64;

/// How much farther the horizon is taken than its estimate.
const HORIZON_MARGIN: f64 = 1.25;

/// The two lines through the optimal vertex of linear · x + Σ |a x + b y + c|, searched from a point near it; `None`
/// if no line crosses the line that is searched. Where many lines meet, the objective may rise along both lines of
/// the vertex and fall along another.
pub(crate) fn descend(lines: &RoundedLines, linear: [f64; 2], start: [f64; 2]) -> Option<[usize; 2]> {
    descend_nearly(lines, linear, start, 0.0)
}

/// [`descend`], but ending as well at a vertex from which the objective falls by at most `enough` times its kink
/// there.
pub(crate) fn descend_nearly(
    lines: &RoundedLines,
    linear: [f64; 2],
    start: [f64; 2],
    enough: f64,
) -> Option<[usize; 2]> {
    descend_from(lines, linear, start, nearest(lines, start)?, enough)
}

/// [`descend`], beginning along a given line.
pub(crate) fn descend_along(
    lines: &RoundedLines,
    linear: [f64; 2],
    start: [f64; 2],
    line: usize,
) -> Option<[usize; 2]> {
    descend_from(lines, linear, start, line, 0.0)
}

fn descend_from(
    lines: &RoundedLines,
    linear: [f64; 2],
    start: [f64; 2],
    mut line: usize,
    enough: f64,
) -> Option<[usize; 2]> {
    let mut point = start;
    let mut before = usize::MAX;
    let mut still = 0;
    let mut crossings = Crossings::of(lines.len());
    for _ in 0..LINE_SEARCH_LIMIT {
        let (other, vertex) = search(lines, linear, line, point, &mut crossings)?;
        still = if is_same(point, vertex) { still + 1 } else { 0 };
        point = vertex;
        let ([a, b, c, _], [other_a, other_b, ..]) = (lines.line(line), lines.line(other));
        let direction = [-other_b, other_a];
        // the slope along the other line at the vertex, without the two lines through it
        let turn = a * direction[0] + b * direction[1];
        let own = f64::copysign(1.0, a * point[0] + b * point[1] + c) * turn;
        let slope = lines.slope(linear, point, direction) - own;
        // where the line before comes again, or the vertex stays, rounding would go on in circles
        if slope.abs() <= turn.abs() * (1.0 + enough) || other == before || still > UNMOVED_LIMIT {
            return Some([line, other]);
        }
        (before, line) = (line, other);
    }
    Some([before, line])
}

fn is_same(a: [f64; 2], b: [f64; 2]) -> bool {
    (a[0] - b[0]).abs() + (a[1] - b[1]).abs() <= 64.0 * f64::EPSILON * (b[0].abs() + b[1].abs())
}

fn nearest(lines: &RoundedLines, [x, y]: [f64; 2]) -> Option<usize> {
    let (mut least, mut nearest) = (f64::INFINITY, None);
    for (block, LineBlock([a, b, c, _])) in lines.blocks().iter().enumerate() {
        for lane in 0..LANES {
            let value = a[lane] * x + b[lane] * y + c[lane];
            // not finite for a line without normal
            let square = value * value / (a[lane] * a[lane] + b[lane] * b[lane]);
            if square < least {
                (least, nearest) = (square, Some(slot(LANES * block + lane)));
            }
        }
    }
    nearest
}

/// The places at which lines cross the line that is searched.
struct Crossings {
    /// The place of the crossing of each slot's line, in multiples of the direction of the search.
    places: Reused<f64>,
    ahead: CrossingList,
}

impl Crossings {
    fn of(len: usize) -> Self {
        let places = Reused::with_capacity(len.next_multiple_of(LANES));
        Self { places, ahead: CrossingList::with_capacity(len.min(HORIZON_SAMPLE)) }
    }

    /// Gathers the crossings ahead that are no farther than `farthest`, and returns their total weight: half of what
    /// the slope gains at all of them.
    fn gather(&mut self, lines: &RoundedLines, direction: [f64; 2], farthest: f64) -> f64 {
        self.ahead.clear();
        let last = farthest.min(f64::MAX);
        let (places, _) = self.places.as_chunks::<LANES>();
        let mut gain = 0.0;
        // the lines that fill up the last block are crossed nowhere
        for (number, (LineBlock([a, b, ..]), places)) in lines.blocks().iter().zip(places).enumerate() {
            for row in 0..LANES {
                let lane = slot(row);
                if is_ahead(places[lane]) && places[lane] <= last {
                    gain += self.ahead.add(places[lane], [a[lane], b[lane]], direction, LANES * number + row);
                }
            }
        }
        gain
    }

    /// Gathers the crossings ahead of one line in `step`, and returns their total weight.
    fn gather_some(&mut self, lines: &RoundedLines, direction: [f64; 2], step: usize) -> f64 {
        self.ahead.clear();
        let mut gain = 0.0;
        for line in (0..lines.len()).step_by(step) {
            let place = self.places[slot(line)];
            if is_ahead(place) && place < f64::INFINITY {
                let [a, b, ..] = lines.line(line);
                gain += self.ahead.add(place, [a, b], direction, line);
            }
        }
        gain
    }

    /// A place that the wanted crossing is likely to be before.
    fn farthest(&mut self, lines: &RoundedLines, direction: [f64; 2], target: f64) -> f64 {
        let step = lines.len() / HORIZON_SAMPLE;
        if step < 2 {
            return f64::INFINITY;
        }
        let gain = self.gather_some(lines, direction, step);
        let target = HORIZON_MARGIN * target / step as f64 + 2.0 * gain / self.ahead.len() as f64;
        if target < gain {
            self.ahead.select(target).map_or(f64::INFINITY, |crossing| crossing.place)
        } else {
            f64::INFINITY
        }
    }
}

/// Zero is ahead where the slope was summed up with the sign before it.
#[inline(always)]
fn is_ahead(place: f64) -> bool {
    place.is_sign_positive()
}

/// The minimum along a line: the line that crosses it there, and the point.
fn search(
    lines: &RoundedLines,
    linear: [f64; 2],
    line: usize,
    [x, y]: [f64; 2],
    crossings: &mut Crossings,
) -> Option<(usize, [f64; 2])> {
    let [a, b, c, _] = lines.line(line);
    let off = (a * x + b * y + c) / (a * a + b * b);
    let foot = [x - off * a, y - off * b];
    let mut direction = [-b, a];
    // the line itself has no slope along itself, and no crossing
    let mut slope = lines.slope_and_crossings(linear, foot, direction, &mut crossings.places);
    if slope > 0.0 {
        (direction, slope) = (direction.map(|c| -c), -slope);
        for place in crossings.places.iter_mut() {
            *place = -*place;
        }
    }
    let target = -slope / 2.0;
    let farthest = crossings.farthest(lines, direction, target);
    let gain = crossings.gather(lines, direction, farthest);
    if gain < target && farthest < f64::INFINITY {
        crossings.gather(lines, direction, f64::INFINITY);
    }
    let found = crossings.ahead.select(target)?;
    Some((found.line, [0, 1].map(|k| foot[k] + found.place * direction[k])))
}
