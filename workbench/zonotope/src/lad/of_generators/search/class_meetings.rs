//! The search where generators have few directions: the optimum is nearly always where two classes of parallel
//! generators meet.

use super::Searched;
use super::narrowing::narrow;
use crate::lad::of_generators::cells::nested::NestedCells;
use crate::lad::of_generators::cells::reduced::Reduced;
use crate::lad::of_generators::certify::rounded_optimum::RoundedOptimum;
use crate::lad::of_generators::goal::Goal;
use crate::lad::of_generators::guess::parallel_classes::ParallelClasses;
use crate::lad::of_generators::problem::Problem;
use crate::numeric::reused::Reused;
use crate::tally::{Operation, Tally};

/// The number of meetings that are tried: each corrects the gradient of the classes by one pass.
const MEETINGS: usize = 8;

/// The outcome of the search.
pub(crate) enum ClassesFound {
    /// A direction that separates, where the location is all that was asked.
    Separated([f64; 3]),
    /// A vertex, or cells.
    Searched(Searched),
}

/// Searches the optimum among the meetings of classes; `None` if the optimum is not found there.
///
/// A corrected sample may lead back to a meeting that is not optimal, as its sums of the classes are not those of all
/// generators. Then these are summed up, once.
pub(crate) fn search_meetings(
    problem: &Problem<'_>,
    mut classes: ParallelClasses,
    tally: &mut dyn Tally,
) -> Option<ClassesFound> {
    let (query, chart) = (problem.query, &problem.chart);
    let mut seen = Reused::<[f64; 2]>::with_capacity(MEETINGS);
    let mut is_whole = false;
    for round in 0..MEETINGS {
        let meeting = classes.meeting(chart)?;
        if problem.goal == Goal::Location && round == 0 {
            tally.add(Operation::GeneratorRead, query.len() as u64);
            let direction = chart.point(meeting.guess.point);
            if query.separates(&problem.p, &direction) {
                return Some(ClassesFound::Separated(direction));
            }
        }
        tally.add(Operation::SearchStep, 1);
        let reduced = Reduced::of_query(query, chart.cell(&meeting.guess, 1.0));
        tally.add(Operation::GeneratorRead, reduced.fixed.read as u64);
        if !reduced.is_moderate() {
            return None;
        }
        let is_corrected = classes.is_corrected(&meeting, &reduced, chart);
        let is_seen = seen.contains(&meeting.guess.point);
        if is_corrected && is_seen && !is_whole {
            tally.add(Operation::GeneratorRead, query.len() as u64);
            (classes, is_whole) = (ParallelClasses::of_all(query, chart)?, true);
            seen.clear();
            continue;
        }
        seen.push(meeting.guess.point);
        if !is_corrected || is_seen {
            let levels = [reduced];
            let vertex = classes.vertex(&meeting, &levels[0]);
            let optimum = vertex.and_then(|vertex| RoundedOptimum::at(&levels, &problem.p, vertex).ok());
            let [reduced] = levels;
            let searched = match optimum {
                Some(optimum) => Searched::Certified(optimum, NestedCells::of([reduced].into_iter().collect())),
                None => narrow(problem, reduced, Some(&meeting.guess), usize::MAX).ok()?,
            };
            return Some(ClassesFound::Searched(searched));
        }
    }
    None
}
