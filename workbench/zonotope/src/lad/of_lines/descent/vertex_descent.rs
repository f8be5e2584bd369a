//! The descent from vertex to vertex of the arrangement, each strictly lower than the one before.
//!
//! A vertex is kept as the pair of lines that meet in it, with its exact homogeneous coordinates: rounded to doubles it
//! would lie on neither line, and the sides on which it lies of lines close by would be lost.

use std::cmp::Ordering;

use super::line_minimum::LineMinimum;
use super::optimality::decide;
use super::search_line::SearchLine;
use super::solution::{Decision, Optimal, Solution};
use super::tie_break::TieBreak;
use crate::lad::of_lines::subproblem::{Subdifferential, Subproblem, Vertex};
use crate::tally::Tally;

/// Descends to a minimiser: to the lowest point of a line, from there along a line on which the objective falls, and so
/// on.
pub(crate) fn descend<T: Tally>(
    subproblem: &Subproblem,
    first: SearchLine,
    ties: &TieBreak<T>,
    tally: &mut T,
) -> Solution {
    let mut line = first;
    let mut around = Subdifferential::default();
    loop {
        match line.minimize(subproblem, &mut around, tally) {
            LineMinimum::At(vertex) => match decide(subproblem, &around, ties, tally) {
                Decision::Optimal { through, basis, face_dimension } if basis.len() == 2 => {
                    return at_vertex(subproblem, *vertex, around, through, basis, face_dimension);
                }
                Decision::Optimal { basis, .. } => line = SearchLine::of(subproblem, basis[0]),
                Decision::Descend { line: next, .. } => line = SearchLine::of(subproblem, next),
            },
            LineMinimum::Unbounded { forward } => {
                let along = line.index.map(|index| (index, forward));
                return Solution::Unbounded { direction: line.oriented(subproblem, forward), along };
            }
            LineMinimum::Flat => unreachable!("where two lines cross, no line is parallel to both"),
        }
    }
}

/// Descends from a point that lies on a line of the subproblem. Where two lines cross in it, it may itself be a
/// minimiser.
pub(crate) fn descend_from<T: Tally>(
    subproblem: &Subproblem,
    start: Vertex,
    ties: &TieBreak<T>,
    tally: &mut T,
) -> Solution {
    let mut around = Subdifferential::default();
    subproblem.read_at(&start, &mut around, tally);
    let first = *around.through.first().expect("the point is on a line of the subproblem");
    if around.through.iter().all(|&line| subproblem.cross_sign(first, line) == Ordering::Equal) {
        return descend(subproblem, SearchLine::of(subproblem, first), ties, tally);
    }
    let line = match decide(subproblem, &around, ties, tally) {
        Decision::Optimal { through, basis, face_dimension } if basis.len() == 2 => {
            return at_vertex(subproblem, start, around, through, basis, face_dimension);
        }
        Decision::Optimal { basis, .. } => basis[0],
        Decision::Descend { line, .. } => line,
    };
    descend(subproblem, SearchLine::of(subproblem, line), ties, tally)
}

/// The solution at a vertex that is optimal, from what was decided of the lines through it.
pub(crate) fn at_vertex(
    subproblem: &Subproblem,
    vertex: Vertex,
    around: Subdifferential,
    through: Vec<(u32, i8)>,
    basis: Vec<u32>,
    face_dimension: u8,
) -> Solution {
    let first = around.through[0];
    let crossing = around.through.iter().copied().find(|&line| subproblem.cross_sign(first, line) != Ordering::Equal);
    let Subdifferential { mut signs, through: lines_through, .. } = around;
    for (line, sign) in through {
        signs[line as usize] = sign;
    }
    let defining = [Some(first), crossing].into_iter().flatten().collect();
    Solution::Optimal(Box::new(Optimal {
        vertex: Some(vertex),
        defining,
        through: lines_through,
        signs,
        basis,
        face_dimension,
        near: None,
    }))
}
