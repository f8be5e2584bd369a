//! Descent from a point to the vertex at which Σ |a x + b y + c| is least, along lines, in doubles.
//!
//! Each line is searched from the vertex on it that the line before led to. The pass that tells whether that vertex is
//! optimal also tells where the next line is crossed, so each line takes one pass over all lines. Rounding may make
//! the descent end at a wrong vertex, no worse: the vertex is certified by others.

use fearless_simd::{Simd, dispatch, f64x8, prelude::*};

use super::line_search::LineSearch;
use crate::lad::of_generators::plane::rounded_lines::{LineBlock, RoundedLines, load};
use crate::numeric::lanes::level::level;
use crate::numeric::lanes::octet::{LANES, slot};

/// The most line searches.
const LINE_SEARCH_LIMIT: usize = 40;

/// The most line searches that do not move the vertex.
const UNMOVED_LIMIT: usize = 2;

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
        let line = nearest(simd, lines.blocks(), start);
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
fn nearest<S: Simd>(simd: S, blocks: &[LineBlock], [x, y]: [f64; 2]) -> Option<usize> {
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
