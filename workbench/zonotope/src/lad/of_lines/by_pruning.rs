//! Weighted least absolute deviations in the plane, by solving a sample and summing up all lines that miss a small cell
//! around its optimum.
//!
//! # Source
//! Beyond the paper, whose search costs O(n log² n): linear time is due to Zemel, Inf. Proc. Letters 18 (1984) 123; the
//! sampling and the summed-up remainder follow Portnoy and Koenker, Statistical Science 12 (1997) 279. Departure: the
//! answer never rests on statistics. The sign of a summed-up line is certain throughout the cell, so a minimiser of the
//! small remainder in the interior of the cell is a minimiser of the whole, by convexity.
//!
//! Why around the optimum of a sample: the step of Zemel's method gets rid of a constant share of the lines, at the
//! cost of several passes, and the rest needs another step, so its constant is large. A sample of n^(2/3) lines places
//! the optimum so well that a single pass rids the search of all lines but about n^(2/3). The price is that the cell
//! may miss the optimum, which the solution of the remainder shows, and then another cell is tried.
//!
//! # Method
//! 1. At most `LINE_SEARCH_LIMIT` lines: descend by line searches.
//! 2. If a point is known that is expected to be on one side of all lines and is so, in a balanced problem, descend
//!    from a line nearest to it (`one_side`).
//! 3. Solve a sample of about n^(2/3) lines recursively, one line at random from each of as many equal strata.
//! 4. Around the sample's optimum take a cell, in coordinates in which the normals point about equally everywhere. Its
//!    radius is such that the sampling error of the gradient can hardly move the optimum across more lines than cross
//!    the cell.
//! 5. In one pass sum up the lines that certainly miss the cell and keep the others. The gradient at the centre and the
//!    density of the lines kept give a Newton step to where the optimum is expected, and with the error of that step a
//!    smaller cell.
//! 6. If no line crosses the cell, enlarge it where the objective changes over it; else the whole cell is optimal, and
//!    a line nearest to its centre leads to a vertex. If the optimum is expected far outside, move the cell there; if
//!    most lines cross the cell, take the smaller one; go to 5. Else solve the lines kept, recursively, starting with
//!    the smaller cell instead of a sample.
//! 7. If the optimum of the lines kept lies in the interior of the cell, it is the answer; else move and enlarge the
//!    cell and go to 5.
//! 8. After `CELL_LIMIT` cells, or when all lines cross one, descend by line searches from the last optimum found.
//!
//! # Complexity
//! n lines: expected O(n), with about one pass over the lines and O(n^(2/3) √(log n)) lines in the sample and kept;
//! worst case that of line searches. Space O(n): one byte a line and the lines kept.
//!
//! # Numerics
//! A line is summed up only if a bound on every rounding error leaves no doubt about its side; all other decisions
//! are those of the line searches: filtered floating point, then exact dyadic arithmetic.
//!
//! # Example
//! ```
//! use zonotope::lad::{LadProblem, WeightedLine, by_pruning};
//! // The median line of 0 … 998 in x and in y: Σ |x − k| + |y − k| is least at (499, 499).
//! let axes = [[1.0, 0.0], [0.0, 1.0]];
//! let lines: Vec<_> = (0..999)
//!     .flat_map(|k| axes.map(|normal| WeightedLine::unweighted(normal, -f64::from(k))))
//!     .collect();
//! let problem = LadProblem::new(&lines, [0.0, 0.0]).unwrap();
//! let outcome = by_pruning::minimize(&problem, 7, &mut ());
//! assert_eq!(outcome.optimum().unwrap().point(&problem), Some([499.0, 499.0]));
//! ```

mod one_side;
mod sample;

use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;

use super::cells::{Cell, Frame, Split};
use super::descent::{Near, Optimal, SearchLine, Solution, TieBreak, descend, descend_from, solve_with};
use super::input::LadProblem;
use super::optimum::{LadOutcome, Minimizer};
use super::subproblem::{Subproblem, Vertex};
use crate::tally::{Operation, Tally};

/// Number of lines up to which line searches alone solve a subproblem; a quarter of it where a cell is expected to hold
/// the optimum.
const LINE_SEARCH_LIMIT: usize = 50;

/// Number of cells that are tried before line searches take over.
const CELL_LIMIT: usize = 5;

/// Share of the lines above which the lines that cross a cell are too many to recurse on.
const LARGEST_CROSSING_SHARE: f64 = 0.8;

/// Distance, in radii of the cell, up to which an optimum expected outside the cell does not yet move the cell.
const LARGEST_TRUSTED_DISTANCE: f64 = 1.25;

/// A cell of the search, with the lines that it was taken among.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct TracedCell {
    /// The positions in the problem of the lines of the subproblem, or of a sample of it.
    pub(crate) lines: Vec<usize>,
    /// Those of the lines that may cross the cell.
    pub(crate) crossing: Vec<usize>,
    /// The corners of the cell in the scaled frame, counter-clockwise.
    pub(crate) corners: [[f64; 2]; 4],
}

/// The course of a search: the number of lines above which it prunes, and the visitor of each cell with the lines that
/// may cross it.
struct Course<'r> {
    limit: usize,
    at_cell: &'r mut dyn FnMut(&Subproblem, &Cell, &[u32]),
}

/// Minimises a problem by pruning. `seed` decides the samples, and with them the time, never the minimum.
pub fn minimize(problem: &LadProblem, seed: u64, tally: &mut impl Tally) -> LadOutcome {
    LadOutcome::new(solve(&Subproblem::whole(problem), seed, tally))
}

/// [`minimize`], pruning whenever there are more than `limit` lines, with every cell of the search in order; those
/// within a vertex where many lines meet are left out.
pub(crate) fn trace(problem: &LadProblem, limit: usize, seed: u64) -> (LadOutcome, Vec<TracedCell>) {
    let mut cells = Vec::new();
    let mut at_cell = |subproblem: &Subproblem, cell: &Cell, crossing: &[u32]| {
        let position = |line: u32| subproblem.position(line);
        cells.push(TracedCell {
            lines: (0..subproblem.len() as u32).map(position).collect(),
            crossing: crossing.iter().map(|&line| position(line)).collect(),
            corners: cell.corners(),
        });
    };
    let mut course = Course { limit, at_cell: &mut at_cell };
    let outcome = LadOutcome::new(solve_above(&mut course, &Subproblem::whole(problem), seed, &mut ()));
    (outcome, cells)
}

/// A minimiser of a problem that is bounded below, without the coefficients that prove it.
///
/// Of lines without a linear term the objective is bounded below, by zero.
pub(crate) fn minimizer(problem: &LadProblem, seed: u64, tally: &mut impl Tally) -> Minimizer {
    let outcome = LadOutcome::new(solve(&Subproblem::whole(problem).without_coefficients(), seed, tally));
    outcome.optimum().expect("the caller knows the objective to be bounded below").minimizer
}

/// Solves a subproblem by pruning, the default wherever one arises.
pub(crate) fn solve<T: Tally>(subproblem: &Subproblem, seed: u64, tally: &mut T) -> Solution {
    solve_above(&mut Course { limit: LINE_SEARCH_LIMIT, at_cell: &mut |_, _, _| () }, subproblem, seed, tally)
}

/// The decision at vertices where many lines meet, by this method again: what every method uses.
pub(crate) fn tie_break<T: Tally>(seed: u64) -> TieBreak<T> {
    TieBreak { seed, solve }
}

/// [`solve`], pruning whenever there are more lines than the course's limit.
fn solve_above<T: Tally>(course: &mut Course<'_>, subproblem: &Subproblem, seed: u64, tally: &mut T) -> Solution {
    solve_with(subproblem, &tie_break(seed), tally, |first, tally| {
        search_above(course, subproblem, None, first, seed, tally)
    })
}

/// [`minimize`], pruning whenever there are more than `limit` lines.
#[cfg(test)]
pub(super) fn minimize_above(limit: usize, problem: &LadProblem, seed: u64) -> LadOutcome {
    trace(problem, limit, seed).0
}

/// Searches in a cell that is expected to contain the optimum, where the caller has one, else around the optimum of a
/// sample.
fn search_above<T: Tally>(
    course: &mut Course<'_>,
    subproblem: &Subproblem,
    expected: Option<Cell>,
    first: u32,
    seed: u64,
    tally: &mut T,
) -> Solution {
    let descend_from_first =
        |tally: &mut T| descend(subproblem, SearchLine::of(subproblem, first), &tie_break(seed), tally);
    if subproblem.len() <= if expected.is_some() { course.limit / 4 } else { course.limit } {
        return descend_from_first(tally);
    }
    let mut random = Pcg64Mcg::seed_from_u64(seed);
    let (cell, mut best) = match expected {
        Some(cell) => (Some(cell), None),
        None => {
            let sample = sample::draw(course.limit, subproblem, &mut random);
            sample.count_pass(tally);
            if let Some(line) = one_side::boundary_line(subproblem, &sample, tally) {
                return descend(subproblem, SearchLine::of(subproblem, line), &tie_break(seed), tally);
            }
            match first_cell(course, subproblem, &sample, &mut random, tally) {
                Some((cell, vertex)) => (cell, Some(vertex)),
                None => return descend_from_first(tally),
            }
        }
    };
    if let Some(cell) = cell
        && let Some(solution) = search_near(course, subproblem, cell, &mut best, &mut random, tally)
    {
        return solution;
    }
    match best {
        Some(vertex) => descend_from(subproblem, vertex.unnamed(), &tie_break(seed), tally),
        None if subproblem.len() > course.limit => {
            search_above(course, subproblem, None, first, random.random(), tally)
        }
        None => descend_from_first(tally),
    }
}

/// Searches in a cell and in others near it. `best` is left at the optimum of the lines that crossed the last cell
/// solved.
fn search_near<T: Tally>(
    course: &mut Course<'_>,
    subproblem: &Subproblem,
    mut cell: Cell,
    best: &mut Option<Vertex>,
    random: &mut Pcg64Mcg,
    tally: &mut T,
) -> Option<Solution> {
    for _ in 0..CELL_LIMIT {
        tally.add(Operation::SearchStep, 1);
        let split = cell.split(subproblem, tally);
        (course.at_cell)(subproblem, &cell, &split.crossing);
        let crossing = split.crossing.len();
        if crossing == 0 {
            if split.is_certainly_slanted(subproblem) {
                cell = cell.moved(cell.center, 2.0 * cell.radius);
                continue;
            }
            let nearest = subproblem.nearest_line(cell.center, tally)?;
            return Some(descend(subproblem, SearchLine::of(subproblem, nearest), &tie_break(random.random()), tally));
        }
        if crossing == subproblem.len() && crossing > course.limit {
            return None;
        }
        let rest = [0, 1].map(|i| subproblem.linear[i] + split.sum[i]);
        let expected = match cell.expected(rest, &split.model) {
            Some((narrower, distance)) if distance > LARGEST_TRUSTED_DISTANCE && crossing < subproblem.len() => {
                cell = narrower.moved(narrower.center, cell.radius);
                continue;
            }
            expected => expected.map(|(narrower, _)| narrower),
        };
        if crossing as f64 > LARGEST_CROSSING_SHARE * subproblem.len() as f64 {
            cell = expected?;
            continue;
        }
        if let Solution::Optimal(optimal) = within(course, subproblem, cell, split, expected, random.random(), tally)
            && let Some(vertex) = &optimal.vertex
        {
            if cell.contains(vertex.point) && optimal.defining.len() == 2 {
                return Some(Solution::Optimal(optimal));
            }
            *best = Some(vertex.clone());
        }
        cell = cell.moved(expected.map_or(cell.center, |narrower| narrower.center), 2.0 * cell.radius);
    }
    None
}

/// The optimum of a sample, and a cell around it unless all lines of the sample meet there.
fn first_cell<T: Tally>(
    course: &mut Course<'_>,
    subproblem: &Subproblem,
    sample: &Subproblem,
    random: &mut Pcg64Mcg,
    tally: &mut T,
) -> Option<(Option<Cell>, Vertex)> {
    let seed = random.random();
    let solution = solve_above(course, sample, seed, tally);
    let Solution::Optimal(optimal) = solution else { return None };
    let vertex = optimal.vertex?;
    let center = vertex.point;
    let cell = Frame::of(sample).filter(|_| center.iter().all(|v| v.is_finite())).and_then(|frame| {
        Some(Cell::new(center, sample::radius(sample, subproblem.len(), center, frame, tally)?, frame))
    });
    Some((cell, vertex))
}

/// The solution of the lines that cross a cell, with the signs of all the others.
fn within<T: Tally>(
    course: &mut Course<'_>,
    subproblem: &Subproblem,
    cell: Cell,
    split: Split,
    expected: Option<Cell>,
    seed: u64,
    tally: &mut T,
) -> Solution {
    let Split { crossing, rows, signs, sum, sum_error, .. } = split;
    let remainder = subproblem.remainder(&crossing, rows, signs, sum, sum_error);
    let solution = solve_with(&remainder, &tie_break(seed), tally, |first, tally| {
        search_above(course, &remainder, expected, first, seed, tally)
    });
    match solution {
        Solution::Optimal(optimal) => {
            Solution::Optimal(Box::new(lift(*optimal, &remainder, Near { cells: vec![cell], crossing })))
        }
        unbounded => unbounded,
    }
}

/// A solution of the remainder, the lines that cross a cell, as one of the subproblem.
fn lift(optimal: Optimal, remainder: &Subproblem, near: Near) -> Optimal {
    let crossing = near.crossing.clone();
    let mut signs = remainder.fixed_signs().to_vec();
    for (&line, &sign) in crossing.iter().zip(&optimal.signs) {
        signs[line as usize] = sign;
    }
    let rename = |lines: Vec<u32>| lines.into_iter().map(|line| crossing[line as usize]).collect();
    let [defining, through, basis] = [optimal.defining, optimal.through, optimal.basis].map(rename);
    let near = match optimal.near {
        Some(inner) => near.narrowed(inner),
        None => near,
    };
    Optimal { defining, through, signs, basis, near: Some(near), ..optimal }
}
