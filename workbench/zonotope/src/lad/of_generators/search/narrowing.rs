//! The mainstream search: smaller and smaller cells around better and better guesses, until a few hundred lines are
//! left.
//!
//! 1. One pass over the generators sums up those whose sign is fixed in a cell around the guess (`cells`).
//! 2. Newton steps on the generators that cross the cell give a better guess (`guess`) and a smaller cell around it,
//!    which fewer lines cross; and so on.
//! 3. Among at most [`DESCENT_LINES`] lines a few Newton steps lead near the optimum; from there the descent goes from
//!    vertex to vertex, and the vertex is certified for all cells on the way.
//! 4. Where the vertex seems to be outside the last cell, that cell was too small: the lines of the cell before it
//!    are searched.

use super::Searched;
use crate::lad::of_generators::cells::nested::NestedCells;
use crate::lad::of_generators::cells::reduced::{Reduced, USUAL_LEVELS};
use crate::lad::of_generators::certify::rounded_optimum::{Certified, RoundedOptimum, Unproved};
use crate::lad::of_generators::guess::aim::Aim;
use crate::lad::of_generators::guess::vertex_descent::{descend, descend_along, descend_nearly};
use crate::lad::of_generators::plane::in_doubles::{Guess, RoundedLines};
use crate::lad::of_generators::problem::Problem;
use crate::numeric::reused::Reused;
use crate::tally::{Operation, Tally};

/// At most this many lines are searched from vertex to vertex without a smaller cell: a pass over them takes less than
/// to make sure of a guess, to sum lines up and to write the others down again.
pub(crate) const DESCENT_LINES: usize = 320;

/// A vertex that is farther from the guess than this, in terms of the cell's sides, comes from nearly parallel lines
/// and is not believed.
const BELIEVED_DISTANCE: f64 = 64.0;

/// The cell around a better guess, in standard deviations of the gradient of the lines in the guess's band.
const BAND_DEVIATIONS: f64 = 3.0;

/// The number of times that the descent goes on from a vertex in which many lines meet.
const MEETING_TURNS: usize = 8;

/// A vertex is tried if the objective falls from it by no more than this part of its kink there.
const NEARLY_OPTIMAL: f64 = 2e-8;

/// Why the optimum is not found in a cell.
#[derive(Debug)]
pub(crate) enum Missed {
    /// The optimum seems to be near another guess.
    At(Guess),
    /// Nothing is known of where the optimum is.
    Lost {
        /// The number of generators that cross the cell.
        crossing: usize,
    },
}

/// Searches the cell around a guess, `stretch` times as large as the guess says. O(n).
pub(crate) fn search_cell(
    problem: &Problem<'_>,
    guess: &Guess,
    stretch: f64,
    most_lines: usize,
    tally: &mut dyn Tally,
) -> Result<Searched, Missed> {
    tally.add(Operation::SearchStep, 1);
    let reduced = Reduced::of_query(problem.query, problem.chart.cell(guess, stretch));
    tally.add(Operation::GeneratorRead, reduced.fixed.read as u64);
    if !reduced.is_moderate() {
        return Ok(Searched::Doubtful { cells: NestedCells::default(), vertex: None });
    }
    narrow(problem, reduced, Some(guess), most_lines)
}

/// Searches a reduced problem; `most_lines` is how many lines the descent may at most be left with.
pub(crate) fn narrow(
    problem: &Problem<'_>,
    reduced: Reduced,
    start: Option<&Guess>,
    most_lines: usize,
) -> Result<Searched, Missed> {
    let lines = reduced.lines(&problem.chart);
    let mut levels = Reused::with_capacity(USUAL_LEVELS);
    levels.push(reduced);
    narrow_last(problem, levels, lines, start.copied(), most_lines)
}

/// The same from the last of some problems, each reduced from the one before, and its lines.
pub(crate) fn narrow_last(
    problem: &Problem<'_>,
    mut levels: Reused<Reduced>,
    mut lines: RoundedLines,
    mut guess: Option<Guess>,
    most_lines: usize,
) -> Result<Searched, Missed> {
    let chart = &problem.chart;
    let lost = Missed::Lost { crossing: lines.len() };
    while lines.len() > DESCENT_LINES {
        let last = levels.last().expect("there is always the first");
        let aim = Aim::new(lines.len(), lines.len(), BAND_DEVIATIONS);
        let Some(next) = lines.guess(last.linear(chart), guess.as_ref(), aim) else { break };
        guess = Some(next);
        let smaller = last.split(chart.cell(&next, 1.0));
        if 4 * smaller.vectors.len() > 3 * last.vectors.len() {
            break;
        }
        smaller.write_lines(chart, &mut lines);
        levels.push(smaller);
    }
    let last = levels.last().expect("there is always the first");
    let mut point = match problem.vertex {
        Some(vertex) => met(&lines, vertex).unwrap_or_default(),
        None => {
            let start = guess.map(|guess| (guess.point, guess.band));
            lines.approach(last.linear(chart), start).map_or([0.0; 2], |end| end.point)
        }
    };
    let mut is_found = false;
    if lines.len() > most_lines {
        return Err(lost);
    }
    if problem.is_seen_first()
        && let Some(vertex) = descend(&lines, last.linear(chart), point)
    {
        let generators = last.indices_of(vertex);
        if !problem.is_known(generators) && problem.ends_at(generators) {
            return Ok(Searched::Ended);
        }
        point = met(&lines, vertex).unwrap_or(point);
    }
    loop {
        let level = levels.last().expect("the first problem is never taken away");
        match descend_and_certify(problem, &levels, &lines, level.linear(chart), point) {
            Some(Ended { result: Ok(optimum), .. }) => {
                return Ok(Searched::Certified(optimum, NestedCells::of(levels)));
            }
            Some(Ended { point: found, result: Err(Unproved::Astray(_)), .. }) => {
                let is_believed = guess.is_none_or(|guess| guess.is_near(found, BELIEVED_DISTANCE));
                point = if is_believed { found } else { point };
                is_found |= is_believed;
            }
            Some(ended) => {
                let vertex = Some(level.indices_of(ended.vertex));
                return Ok(Searched::Doubtful { cells: NestedCells::of(levels), vertex });
            }
            None => {}
        }
        let wider = levels.len().checked_sub(2).map_or(0, |place| levels[place].vectors.len());
        if !(1..=most_lines).contains(&wider) {
            return Err(match guess {
                Some(guess) if is_found => Missed::At(Guess { point, ..guess }),
                _ => lost,
            });
        }
        levels.pop();
        levels[levels.len() - 1].write_lines(chart, &mut lines);
    }
}

/// The point in which two lines meet, if doubles have one.
fn met(lines: &RoundedLines, [first, second]: [usize; 2]) -> Option<[f64; 2]> {
    Some(lines.meet(first, second)).filter(|point| point.iter().all(|c| c.is_finite()))
}

/// The end of a descent.
pub(crate) struct Ended {
    /// The vertex, in the plane of the chart.
    pub(crate) point: [f64; 2],
    /// The positions of its two generators in the last level.
    pub(crate) vertex: [usize; 2],
    /// The vertex's certificate, or why there is none.
    pub(crate) result: Certified,
}

/// The vertex at which the descent from a point ends, with its certificate or the reason why there is none; `None` if
/// no line crosses the line that is searched.
///
/// The optimum is that of the last of `levels`, problems each of which was reduced from the one before; the
/// certificate holds for all of them. Where the objective falls along one of many lines that meet in a vertex, the
/// descent goes on along that line. From a vertex that is only nearly optimal the descent goes on once, if such a
/// vertex does not answer the question.
pub(crate) fn descend_and_certify(
    problem: &Problem<'_>,
    levels: &[Reduced],
    lines: &RoundedLines,
    linear: [f64; 2],
    point: [f64; 2],
) -> Option<Ended> {
    let mut vertex = descend_nearly(lines, linear, point, NEARLY_OPTIMAL)?;
    let mut is_last = false;
    for _ in 0..MEETING_TURNS {
        let point = lines.meet(vertex[0], vertex[1]);
        match RoundedOptimum::at(levels, &problem.p, vertex) {
            Err(Unproved::Falls(line)) => vertex = descend_along(lines, linear, point, line)?,
            Ok(optimum) if !is_last && !optimum.is_vertex() && !problem.is_answered_by(&optimum) => {
                is_last = true;
                let Some(next) = descend_nearly(lines, linear, point, 0.0) else {
                    return Some(Ended { point, vertex, result: Ok(optimum) });
                };
                vertex = next;
            }
            result => return Some(Ended { point, vertex, result }),
        }
    }
    Some(Ended { point, vertex, result: Err(Unproved::Doubt) })
}
