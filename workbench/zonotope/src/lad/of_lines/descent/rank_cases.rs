//! Subproblems by the rank of their normals: 0 (no lines), 1 (parallel lines), or 2, which is left to a search.

use std::cmp::Ordering;

use super::line_minimum::LineMinimum;
use super::optimality::decide;
use super::search_line::SearchLine;
use super::solution::{Decision, Optimal, Solution};
use super::tie_break::TieBreak;
use super::vertex_descent::at_vertex;
use crate::arrangement::ExactLine;
use crate::lad::of_lines::subproblem::{Subdifferential, Subproblem};
use crate::numeric::dyadic::Dyadic;
use crate::tally::Tally;

/// Solves a subproblem: where two lines cross by `search`, which is given a line with a normal, else directly.
pub(crate) fn solve_with<T: Tally>(
    subproblem: &Subproblem,
    ties: &TieBreak<T>,
    tally: &mut T,
    search: impl FnOnce(u32, &mut T) -> Solution,
) -> Solution {
    let lines = 0..subproblem.len() as u32;
    let Some(first) = lines.clone().find(|&line| !subproblem.has_zero_normal(line)) else {
        return without_lines(subproblem);
    };
    if lines.clone().skip(1).any(|line| subproblem.cross_sign(first, line) != Ordering::Equal) {
        return search(first, tally);
    }
    with_parallel_lines(subproblem, first, ties, tally)
}

/// Solves a subproblem whose normals are all zero: only the linear term depends on the point.
fn without_lines(subproblem: &Subproblem) -> Solution {
    if let Some(direction) = subproblem.certain_descent() {
        return Solution::Unbounded { direction: direction.map(Dyadic::from_f64), along: None };
    }
    let linear = subproblem.exact_linear().clone();
    if linear.iter().all(Dyadic::is_zero) {
        return Solution::Optimal(Box::new(Optimal {
            vertex: None,
            defining: Vec::new(),
            through: Vec::new(),
            signs: (0..subproblem.len() as u32).map(|line| subproblem.exact_line(line).offset.sign() as i8).collect(),
            basis: Vec::new(),
            face_dimension: 2,
            near: None,
        }));
    }
    Solution::Unbounded { direction: linear.map(|v| -v), along: None }
}

/// Solves a subproblem of parallel lines, one of them given: along them the objective is linear, across them a search
/// along one line decides.
fn with_parallel_lines<T: Tally>(subproblem: &Subproblem, line: u32, ties: &TieBreak<T>, tally: &mut T) -> Solution {
    let along = SearchLine::of(subproblem, line);
    let [dx, dy] = along.exact(subproblem).direction();
    let [cx, cy] = subproblem.exact_linear();
    let slope = (cx * &dx + cy * &dy).sign();
    if slope != Ordering::Equal {
        let forward = slope.is_lt();
        return Solution::Unbounded { direction: along.oriented(subproblem, forward), along: Some((line, forward)) };
    }
    let across = SearchLine::free(ExactLine { normal: [dx, dy], offset: Dyadic::zero() });
    let mut around = Subdifferential::default();
    match across.minimize(subproblem, &mut around, tally) {
        LineMinimum::At(vertex) => match decide(subproblem, &around, ties, tally) {
            Decision::Optimal { through, basis, .. } => {
                let flat = [true, false].iter().any(|&f| across.slope_sign(subproblem, &around, f) == Ordering::Equal);
                at_vertex(subproblem, *vertex, around, through, basis, 1 + u8::from(flat))
            }
            Decision::Descend { .. } => unreachable!("the objective is constant along parallel lines"),
        },
        LineMinimum::Unbounded { forward } => {
            Solution::Unbounded { direction: across.oriented(subproblem, forward), along: None }
        }
        LineMinimum::Flat => unreachable!("the line across meets every line"),
    }
}
