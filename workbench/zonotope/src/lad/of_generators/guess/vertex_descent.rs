//! Descent from a point to the vertex at which Σ |a x + b y + c| is least, along lines, in doubles.
//!
//! Each line is searched from the vertex on it that the line before led to. The pass that tells whether that vertex is
//! optimal also tells where the next line is crossed, so each line takes one pass over all lines. Rounding may make
//! the descent end at a wrong vertex, no worse: the vertex is certified by others.
//!
//! The minimum along a line is the crossing at which the slope changes its sign. A search that begins near the minimum
//! passes a few crossings, so the next crossing is looked for until the slope changes its sign: each takes one pass
//! over the places of all crossings, without a list of them. Where lines are many, or the minimum is far, the crossings
//! ahead are gathered instead and the weighted median of them is selected, which takes the same time wherever the
//! minimum is.

use fearless_simd::{Simd, dispatch, f64x8, prelude::*};

use super::crossings::{Crossing, CrossingList};
use crate::lad::of_generators::plane::in_doubles::{LineBlock, RoundedLines, load};
use crate::numeric::lanes::level::level;
use crate::numeric::lanes::octet::{LANES, slot};
use crate::numeric::reused::Reused;

/// The most line searches.
const LINE_SEARCH_LIMIT: usize = 40;

/// The most line searches that do not move the vertex.
const UNMOVED_LIMIT: usize = 2;

/// Among at most this many lines the search goes from crossing to crossing.
const STEPWISE_LINES: usize = 320;

/// The most crossings that a search passes one by one before it gathers those that are left.
const STEPWISE_CROSSINGS: usize = 12;

/// The number of lines, up to twice as many, from which the horizon of a line search is estimated: no crossing beyond
/// it is looked at.
const HORIZON_SAMPLE: usize = 64;

/// The factor by which the horizon is taken farther than its estimate.
const HORIZON_MARGIN: f64 = 1.25;

/// The two lines through the optimal vertex of linear · x + Σ |a x + b y + c|, searched from a point near it; `None`
/// if no line crosses the line that is searched. Where many lines meet, the objective may rise along both lines of
/// the vertex and fall along another.
pub(crate) fn descend(lines: &RoundedLines, linear: [f64; 2], start: [f64; 2]) -> Option<[usize; 2]> {
    descend_nearly(lines, linear, start, 0.0)
}

/// [`descend`], but ending as well at a vertex from which the objective falls by at most `enough` times its kink there.
pub(crate) fn descend_nearly(
    lines: &RoundedLines,
    linear: [f64; 2],
    start: [f64; 2],
    enough: f64,
) -> Option<[usize; 2]> {
    let mut search = LineSearch::new(lines, linear);
    dispatch!(level(), simd => {
        let line = nearest_line(simd, lines.blocks(), start);
        line.and_then(|line| descend_from(simd, lines, &mut search, start, line, enough))
    })
}

/// [`descend`], beginning along a given line.
pub(crate) fn descend_along(
    lines: &RoundedLines,
    linear: [f64; 2],
    start: [f64; 2],
    line: usize,
) -> Option<[usize; 2]> {
    let mut search = LineSearch::new(lines, linear);
    dispatch!(level(), simd => descend_from(simd, lines, &mut search, start, line, 0.0))
}

#[inline(always)]
fn descend_from<S: Simd>(
    simd: S,
    lines: &RoundedLines,
    search: &mut LineSearch<'_>,
    start: [f64; 2],
    mut line: usize,
    enough: f64,
) -> Option<[usize; 2]> {
    let mut outlook = search.look_along(simd, line, start);
    let mut point = start;
    let mut before = usize::MAX;
    let mut still = 0;
    for _ in 0..LINE_SEARCH_LIMIT {
        let (other, vertex) = search.minimum(simd, &outlook)?;
        still = if is_same(point, vertex) { still + 1 } else { 0 };
        point = vertex;
        outlook = search.look_along(simd, other, point);
        let (slope, turn) = outlook.slope_without(lines.line(line));
        // where the line before comes again, or the vertex stays, rounding would go on in circles
        if slope.abs() <= turn.abs() * (1.0 + enough) || other == before || still > UNMOVED_LIMIT {
            return Some([line, other]);
        }
        (before, line) = (line, other);
    }
    Some([before, line])
}

#[inline(always)]
fn is_same(a: [f64; 2], b: [f64; 2]) -> bool {
    (a[0] - b[0]).abs() + (a[1] - b[1]).abs() <= 64.0 * f64::EPSILON * (b[0].abs() + b[1].abs())
}

/// The line nearest to a point, one of several; `None` where no line has a normal.
#[inline(always)]
fn nearest_line<S: Simd>(simd: S, blocks: &[LineBlock], [x, y]: [f64; 2]) -> Option<usize> {
    let (mut square, mut place) = (f64x8::splat(simd, f64::INFINITY), f64x8::splat(simd, -1.0));
    for (number, block) in blocks.iter().enumerate() {
        let [a, b, c, _] = load(simd, block);
        let value = a * x + b * y + c;
        // not finite for a line without normal
        let own = value * value / (a * a + b * b);
        let is_nearer = own.simd_lt(square);
        place = is_nearer.select(f64x8::splat(simd, number as f64), place);
        square = is_nearer.select(own, square);
    }
    let (mut squares, mut places) = ([0.0; LANES], [0.0; LANES]);
    square.store_slice(&mut squares);
    place.store_slice(&mut places);
    let mut least = 0;
    for lane in 1..LANES {
        if squares[lane] < squares[least] {
            least = lane;
        }
    }
    (places[least] >= 0.0).then(|| LANES * places[least] as usize + slot(least))
}

/// A line that is searched, seen from a point on it.
struct Outlook {
    foot: [f64; 2],
    direction: [f64; 2],
    /// The slope along the direction where the search begins.
    slope: f64,
}

/// The search along one line after the other, with the places at which the line that is searched is crossed.
struct LineSearch<'l> {
    lines: &'l RoundedLines,
    linear: [f64; 2],
    /// The place of the crossing of each slot's line, in multiples of the direction.
    places: Reused<f64>,
    ahead: CrossingList,
}

impl<'l> LineSearch<'l> {
    fn new(lines: &'l RoundedLines, linear: [f64; 2]) -> Self {
        let mut places = Reused::with_capacity(LANES * lines.blocks().len());
        places.resize(LANES * lines.blocks().len(), 0.0);
        Self { lines, linear, places, ahead: CrossingList::with_capacity(lines.len().min(HORIZON_SAMPLE)) }
    }

    /// Finds the slope along a line at its point nearest to a point, and where the line is crossed. One pass.
    #[inline(always)]
    fn look_along<S: Simd>(&mut self, simd: S, line: usize, [x, y]: [f64; 2]) -> Outlook {
        let [a, b, c, _] = self.lines.line(line);
        let off = (a * x + b * y + c) / (a * a + b * b);
        let (foot, direction) = ([x - off * a, y - off * b], [-b, a]);
        // the line itself has no slope along itself, and no crossing
        let slope = self.lines.slope_and_crossings(simd, self.linear, foot, direction, &mut self.places);
        Outlook { foot, direction, slope }
    }

    /// The minimum along the line that was looked along last: the line that crosses it there, and the point; `None` if
    /// no line does.
    #[inline(always)]
    fn minimum<S: Simd>(&mut self, simd: S, outlook: &Outlook) -> Option<(usize, [f64; 2])> {
        let is_rising = outlook.slope > 0.0;
        let direction = if is_rising { outlook.direction.map(|c| -c) } else { outlook.direction };
        let target = outlook.slope.abs() / 2.0;
        let found = if self.lines.len() <= STEPWISE_LINES {
            self.next_crossings(simd, is_rising, direction, target)?
        } else {
            if is_rising {
                self.places.iter_mut().for_each(|place| *place = -*place);
            }
            self.select(direction, target)?
        };
        Some((found.line, [0, 1].map(|k| outlook.foot[k] + found.place * direction[k])))
    }

    /// Passes the crossings ahead one by one until their weights reach `target`; crossings that are passed are taken
    /// off the places.
    #[inline(always)]
    fn next_crossings<S: Simd>(
        &mut self,
        simd: S,
        is_rising: bool,
        direction: [f64; 2],
        target: f64,
    ) -> Option<Crossing> {
        let mut nearest = keep_those_ahead(simd, &mut self.places, is_rising);
        let (mut passed, mut last) = (0.0, None);
        for _ in 0..STEPWISE_CROSSINGS {
            let Some(crossing) = nearest.crossing() else { return last };
            let [a, b, ..] = self.lines.line(crossing.line);
            passed += (a * direction[0] + b * direction[1]).abs();
            if passed >= target {
                return Some(crossing);
            }
            self.places[slot(crossing.line)] = f64::INFINITY;
            last = Some(crossing);
            nearest = nearest_of(simd, &self.places);
        }
        self.select(direction, target - passed).or(last)
    }

    /// Selects the crossing ahead at which the weights reach `target`.
    #[inline(never)]
    fn select(&mut self, direction: [f64; 2], target: f64) -> Option<Crossing> {
        let farthest = self.farthest(direction, target);
        let gain = self.gather(direction, farthest);
        if gain < target && farthest < f64::INFINITY {
            self.gather(direction, f64::INFINITY);
        }
        self.ahead.select(target)
    }

    /// Gathers the crossings ahead that are no farther than `farthest`, and returns their total weight: half of what
    /// the slope gains at all of them.
    fn gather(&mut self, direction: [f64; 2], farthest: f64) -> f64 {
        self.ahead.clear();
        let last = farthest.min(f64::MAX);
        let (places, _) = self.places.as_chunks::<LANES>();
        let mut gain = 0.0;
        // the lines that fill up the last block are crossed nowhere
        for (number, (LineBlock([a, b, ..]), places)) in self.lines.blocks().iter().zip(places).enumerate() {
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
    fn gather_some(&mut self, direction: [f64; 2], step: usize) -> f64 {
        self.ahead.clear();
        let mut gain = 0.0;
        for line in (0..self.lines.len()).step_by(step) {
            let place = self.places[slot(line)];
            if is_ahead(place) && place < f64::INFINITY {
                let [a, b, ..] = self.lines.line(line);
                gain += self.ahead.add(place, [a, b], direction, line);
            }
        }
        gain
    }

    /// A place that the wanted crossing is likely to be before.
    fn farthest(&mut self, direction: [f64; 2], target: f64) -> f64 {
        let step = self.lines.len() / HORIZON_SAMPLE;
        if step < 2 {
            return f64::INFINITY;
        }
        let gain = self.gather_some(direction, step);
        let target = HORIZON_MARGIN * target / step as f64 + 2.0 * gain / self.ahead.len() as f64;
        if target < gain {
            self.ahead.select(target).map_or(f64::INFINITY, |crossing| crossing.place)
        } else {
            f64::INFINITY
        }
    }
}

impl Outlook {
    /// The slope at the point, less the contribution of another line through it, and the slope of that line.
    #[inline(always)]
    fn slope_without(&self, [a, b, c, _]: [f64; 4]) -> (f64, f64) {
        let turn = a * self.direction[0] + b * self.direction[1];
        let own = f64::copysign(1.0, a * self.foot[0] + b * self.foot[1] + c) * turn;
        (self.slope - own, turn)
    }
}

/// Zero is ahead where the slope was summed up with the sign before it.
#[inline(always)]
fn is_ahead(place: f64) -> bool {
    place.is_sign_positive()
}

/// The nearest place of each lane, and the number of its block.
struct Nearest {
    places: [f64; LANES],
    blocks: [f64; LANES],
}

impl Nearest {
    /// The nearest crossing, the first in the order of the lines where several are as near.
    #[inline(always)]
    fn crossing(&self) -> Option<Crossing> {
        let mut nearest = Crossing { place: f64::INFINITY, line: usize::MAX };
        for lane in 0..LANES {
            let (place, line) = (self.places[lane], LANES * self.blocks[lane] as usize + slot(lane));
            if place < nearest.place || (place == nearest.place && line < nearest.line) {
                nearest = Crossing { place, line };
            }
        }
        (nearest.place < f64::INFINITY).then_some(nearest)
    }
}

/// The nearest places so far.
struct Lanes<S: Simd> {
    places: f64x8<S>,
    blocks: f64x8<S>,
}

impl<S: Simd> Lanes<S> {
    #[inline(always)]
    fn new(simd: S) -> Self {
        Self { places: f64x8::splat(simd, f64::INFINITY), blocks: f64x8::splat(simd, 0.0) }
    }

    #[inline(always)]
    fn read(&mut self, simd: S, place: f64x8<S>, block: usize) {
        let is_nearer = place.simd_lt(self.places);
        self.blocks = is_nearer.select(f64x8::splat(simd, block as f64), self.blocks);
        self.places = is_nearer.select(place, self.places);
    }

    #[inline(always)]
    fn nearest(&self) -> Nearest {
        let mut nearest = Nearest { places: [0.0; LANES], blocks: [0.0; LANES] };
        self.places.store_slice(&mut nearest.places);
        self.blocks.store_slice(&mut nearest.blocks);
        nearest
    }
}

/// Negates the places if the search goes against the direction, makes those behind infinite, and finds the nearest.
#[inline(always)]
fn keep_those_ahead<S: Simd>(simd: S, places: &mut [f64], is_turned: bool) -> Nearest {
    let (one, never) = (f64x8::splat(simd, 1.0), f64x8::splat(simd, f64::INFINITY));
    let turn = f64x8::splat(simd, if is_turned { -1.0 } else { 1.0 });
    let mut lanes = Lanes::new(simd);
    for (number, own) in places.as_chunks_mut::<LANES>().0.iter_mut().enumerate() {
        let place = f64x8::from_slice(simd, own) * turn;
        // by the sign, as zero is ahead or behind; no comparison holds for what is not a number
        let is_ahead = one.copysign(place).simd_gt(0.0) & place.simd_lt(never);
        let place = is_ahead.select(place, never);
        place.store_slice(own);
        lanes.read(simd, place, number);
    }
    lanes.nearest()
}

#[inline(always)]
fn nearest_of<S: Simd>(simd: S, places: &[f64]) -> Nearest {
    let mut lanes = Lanes::new(simd);
    for (number, own) in places.as_chunks::<LANES>().0.iter().enumerate() {
        lanes.read(simd, f64x8::from_slice(simd, own), number);
    }
    lanes.nearest()
}
