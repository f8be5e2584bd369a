//! The frame around every method: what lines of rank 0 and 1 mean, and the descent from vertex to vertex.

use std::cmp::Ordering;

use super::decide::decide;
use super::line_search::{LineMinimum, SearchLine};
use super::solution::{Decision, Optimal, Solution};
use crate::arrangement::ExactLine;
use crate::lad::of_lines::by_pruning;
use crate::lad::of_lines::subproblem::instance::{Instance, Surroundings};
use crate::lad::of_lines::subproblem::vertex::Vertex;
use crate::numeric::dyadic::Dyadic;
use crate::tally::Tally;

/// Solves an instance by the default method for its size.
pub(crate) fn solve<T: Tally>(instance: &Instance, seed: u64, tally: &mut T) -> Solution {
    solve_with(instance, seed, tally, |line, tally| by_pruning::search(instance, line, seed, tally))
}

/// Solves an instance: by `search`, which is given a first line, when two lines cross; else directly.
pub(crate) fn solve_with<T: Tally>(
    instance: &Instance,
    seed: u64,
    tally: &mut T,
    search: impl FnOnce(u32, &mut T) -> Solution,
) -> Solution {
    let lines = 0..instance.len() as u32;
    let Some(first) = lines.clone().find(|&line| !instance.has_zero_normal(line)) else {
        return without_lines(instance);
    };
    if lines.clone().skip(1).any(|line| instance.cross_sign(first, line) != Ordering::Equal) {
        return search(first, tally);
    }
    with_parallel_lines(instance, first, seed, tally)
}

/// From line to line through the vertices, each strictly lower than the one before, to a minimiser.
pub(crate) fn descend(instance: &Instance, first: SearchLine, seed: u64, tally: &mut impl Tally) -> Solution {
    let mut line = first;
    let mut around = Surroundings::default();
    loop {
        match line.minimize(instance, &mut around, tally) {
            LineMinimum::At(vertex) => match decide(instance, &around, seed, tally) {
                Decision::Optimal { through, basis, face_dimension } if basis.len() == 2 => {
                    return at_vertex(instance, *vertex, around, through, basis, face_dimension);
                }
                Decision::Optimal { basis, .. } => line = SearchLine::of(instance, basis[0]),
                Decision::Descend { line: next, .. } => line = SearchLine::of(instance, next),
            },
            LineMinimum::Unbounded { forward } => {
                let along = line.index.map(|index| (index, forward));
                return Solution::Unbounded { direction: oriented(line.exact(instance).direction(), forward), along };
            }
            LineMinimum::Flat => unreachable!("where two lines cross, no line is parallel to both"),
        }
    }
}

/// From a point on a line of the instance: where two lines cross decides there, and descends if it is not a minimiser.
pub(crate) fn descend_from(instance: &Instance, start: Vertex, seed: u64, tally: &mut impl Tally) -> Solution {
    let mut around = Surroundings::default();
    instance.read_at(&start, &mut around, tally);
    let first = *around.through.first().expect("the point is on a line of the instance");
    if around.through.iter().all(|&line| instance.cross_sign(first, line) == Ordering::Equal) {
        return descend(instance, SearchLine::of(instance, first), seed, tally);
    }
    let line = match decide(instance, &around, seed, tally) {
        Decision::Optimal { through, basis, face_dimension } if basis.len() == 2 => {
            return at_vertex(instance, start, around, through, basis, face_dimension);
        }
        Decision::Optimal { basis, .. } => basis[0],
        Decision::Descend { line, .. } => line,
    };
    descend(instance, SearchLine::of(instance, line), seed, tally)
}

/// The solution at a vertex that was decided to be optimal.
pub(crate) fn at_vertex(
    instance: &Instance,
    vertex: Vertex,
    around: Surroundings,
    through: Vec<(u32, i8)>,
    basis: Vec<u32>,
    face_dimension: u8,
) -> Solution {
    let first = around.through[0];
    let crossing = around.through.iter().copied().find(|&line| instance.cross_sign(first, line) != Ordering::Equal);
    let Surroundings { mut signs, through: lines_through, .. } = around;
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

fn without_lines(instance: &Instance) -> Solution {
    let linear = instance.exact_linear().clone();
    if linear.iter().all(Dyadic::is_zero) {
        return Solution::Optimal(Box::new(Optimal {
            vertex: None,
            defining: Vec::new(),
            through: Vec::new(),
            signs: (0..instance.len() as u32).map(|line| instance.exact_line(line).offset.sign() as i8).collect(),
            basis: Vec::new(),
            face_dimension: 2,
            near: None,
        }));
    }
    Solution::Unbounded { direction: linear.map(|v| -v), along: None }
}

fn with_parallel_lines(instance: &Instance, line: u32, seed: u64, tally: &mut impl Tally) -> Solution {
    let along = SearchLine::of(instance, line);
    let [dx, dy] = along.exact(instance).direction();
    let [cx, cy] = instance.exact_linear();
    let slope = (cx * &dx + cy * &dy).sign();
    if slope != Ordering::Equal {
        let forward = slope.is_lt();
        return Solution::Unbounded { direction: oriented([dx, dy], forward), along: Some((line, forward)) };
    }
    let across = SearchLine::free(ExactLine { normal: [dx, dy], offset: Dyadic::zero() });
    let mut around = Surroundings::default();
    match across.minimize(instance, &mut around, tally) {
        LineMinimum::At(vertex) => match decide(instance, &around, seed, tally) {
            Decision::Optimal { through, basis, .. } => {
                let flat = [true, false].iter().any(|&f| across.slope_sign(instance, &around, f) == Ordering::Equal);
                at_vertex(instance, *vertex, around, through, basis, 1 + u8::from(flat))
            }
            Decision::Descend { .. } => unreachable!("the objective is constant along parallel lines"),
        },
        LineMinimum::Unbounded { forward } => {
            Solution::Unbounded { direction: oriented(across.exact(instance).direction(), forward), along: None }
        }
        LineMinimum::Flat => unreachable!("the line across meets every line"),
    }
}

fn oriented(direction: [Dyadic; 2], forward: bool) -> [Dyadic; 2] {
    if forward { direction } else { direction.map(|v| -v) }
}
