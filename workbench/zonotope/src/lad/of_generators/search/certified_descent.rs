//! Descent from vertex to vertex until one is certified as the optimum.

use crate::lad::of_generators::cells::reduced::Reduced;
use crate::lad::of_generators::certify::rounded_optimum::{Certified, RoundedOptimum, Unproved};
use crate::lad::of_generators::guess::vertex_descent::{descend_along, descend_nearly};
use crate::lad::of_generators::plane::in_doubles::RoundedLines;
use crate::lad::of_generators::problem::Problem;

/// The number of times that the descent goes on from a vertex in which many lines meet.
const MEETING_TURNS: usize = 8;

/// A vertex is tried if the objective falls from it by no more than this part of its kink there.
const NEARLY_OPTIMAL: f64 = 2e-8;

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
