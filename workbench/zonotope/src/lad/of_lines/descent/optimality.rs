//! Whether a point is a minimiser, and if not, along which line to leave it.
//!
//! At a vertex where two lines cross, four slopes decide. Where more lines meet, the [`TieBreak`] decides.

use std::cmp::Ordering;

use super::search_line::SearchLine;
use super::solution::Decision;
use super::tie_break::TieBreak;
use crate::lad::of_lines::subproblem::{Subdifferential, Subproblem};
use crate::tally::Tally;

/// Decides at a point that is minimal along some line through it. Expected O(k) for k lines through the point.
pub(crate) fn decide<T: Tally>(
    subproblem: &Subproblem,
    around: &Subdifferential,
    ties: &TieBreak<T>,
    tally: &mut T,
) -> Decision {
    match around.through[..] {
        [line] => decide_on_one(subproblem, around, line),
        [first, second] if subproblem.cross_sign(first, second) != Ordering::Equal => {
            decide_on_two(subproblem, around, [first, second])
        }
        _ => decide_where_all_meet(subproblem, around).unwrap_or_else(|| ties.decide(subproblem, around, tally)),
    }
}

/// Decides where all lines meet and there is no linear term: the objective is zero there, its least possible value.
///
/// So it is for the bisectors of a centrally symmetric polygon, whose normals are known to sum to zero: all
/// coefficients may be 1. Of a sample only the place of the optimum is asked for.
fn decide_where_all_meet(subproblem: &Subproblem, around: &Subdifferential) -> Option<Decision> {
    let lines = &around.through;
    let first = lines[0];
    let crossing = lines.iter().copied().find(|&line| subproblem.cross_sign(first, line) != Ordering::Equal)?;
    let sign = |line| i8::from(line != first && line != crossing);
    (lines.len() == subproblem.len() && subproblem.is_balanced()).then(|| Decision::Optimal {
        through: lines.iter().map(|&line| (line, sign(line))).collect(),
        basis: vec![first, crossing],
        face_dimension: 0,
    })
}

/// The signs of the slopes when leaving the point along a line, forward and backward.
fn slopes(subproblem: &Subproblem, around: &Subdifferential, line: u32) -> [Ordering; 2] {
    let along = SearchLine::of(subproblem, line);
    [true, false].map(|forward| along.slope_sign(subproblem, around, forward))
}

/// The descent along a line, if one of the slopes is negative.
fn falling(line: u32, slopes: [Ordering; 2]) -> Option<Decision> {
    let descend = |forward| Decision::Descend { line, forward };
    match slopes {
        [Ordering::Less, _] => Some(descend(true)),
        [_, Ordering::Less] => Some(descend(false)),
        _ => None,
    }
}

fn decide_on_one(subproblem: &Subproblem, around: &Subdifferential, line: u32) -> Decision {
    falling(line, slopes(subproblem, around, line)).unwrap_or_else(|| Decision::Optimal {
        through: Vec::new(),
        basis: vec![line],
        face_dimension: 1,
    })
}

fn decide_on_two(subproblem: &Subproblem, around: &Subdifferential, [first, second]: [u32; 2]) -> Decision {
    let along = [first, second].map(|line| slopes(subproblem, around, line));
    falling(first, along[0]).or_else(|| falling(second, along[1])).unwrap_or_else(|| {
        let flat = along.iter().filter(|slopes| slopes.contains(&Ordering::Equal)).count();
        Decision::Optimal { through: Vec::new(), basis: vec![first, second], face_dimension: flat as u8 }
    })
}
