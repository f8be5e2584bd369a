//! Weighted least absolute deviations in the plane, by solving a sample and summing up all lines that miss a small cell around
//! its optimum.
//!
//! # Statement
//! Input: lines with weights and a linear term ([`LadProblem`]). Output: an exact minimiser of
//! linear · x + Σ w |a · x + b| with a certificate, or a direction along which the objective falls without bound. When the minimiser is
//! not unique, one vertex of the set of minimisers and the dimension of that set. Parallel, equal, concurrent and
//! zero lines are ordinary input.
//!
//! # Source
//! Beyond the paper, whose search costs O(n log² n): linear time is due to Zemel, Inf. Proc. Letters 18 (1984) 123; the
//! sampling and the summed-up remainder follow Portnoy and Koenker, Statistical Science 12 (1997) 279. Departure: the
//! answer never rests on statistics. The sign of a summed-up line is certain throughout the cell, so a minimiser of the
//! small remainder in the interior of the cell is a minimiser of the whole, by convexity.
//!
//! # Method
//! 1. At most `SMALL` lines: descend by line searches.
//! 2. Solve a jittered strided sample of about n^(2/3) lines, recursively.
//! 3. Around its optimum take a cell, in coordinates in which the sample's normals point equally everywhere, that is crossed by as many
//!    sample lines as the sampling error of the gradient can shift the optimum across.
//! 4. One pass: sum up the lines that certainly miss the cell, keep the others; solve those recursively.
//! 5. If the optimum lies in the interior of the cell it is the answer; else move and enlarge the cell and go to 4.
//! 6. After `ROUNDS` failures, or when a cell keeps most of the lines, descend from the last optimum found by line searches.
//!
//! # Complexity
//! n lines: expected O(n), with about one pass over the lines and O(n^(2/3)) lines kept; worst case that of line searches.
//! Space O(n): one byte a line and the lines kept.
//!
//! # Shapes
//! `problem`: n lines in any order, duplicates allowed.
//!
//! # Numerics
//! A line is summed up only if a bound on every rounding error leaves no doubt about its side; all other decisions
//! are those of the line searches: filtered floating point, then exact dyadic arithmetic.
//!
//! # Errors
//! None: the problem was validated when it was made.
//!
//! # Panics
//! Never.
//!
//! # Checked by
//! [`brute_force`](super::brute_force), and [`verify`](super::verify::verify) on every answer.
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
//! let outcome = by_pruning::minimize(&problem, 7);
//! assert_eq!(outcome.optimum().unwrap().point(&problem), [499.0, 499.0]);
//! ```

use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;

use super::cell::{Cell, Frame, Split};
use super::instance::{ExactLinear, Instance};
use super::line_search::SearchLine;
use super::optimum::LadOutcome;
use super::problem::LadProblem;
use super::solution::{Optimal, Solution};
use super::solve::{descend, descend_from, solve_with};
use super::vertex::Vertex;
use crate::numeric::dyadic::Dyadic;
use crate::tally::{Operation, Tally};

/// At most this many lines are solved by line searches alone.
const SMALL: usize = 400;

/// How many cells are tried.
const ROUNDS: usize = 5;

/// The cell is crossed by so much weight of sample lines, in standard deviations of the sample's gradient.
const DEVIATIONS: f64 = 4.0;

/// Minimises a problem by pruning. `seed` decides the sample: the time, never the minimum.
pub fn minimize(problem: &LadProblem, seed: u64) -> LadOutcome {
    minimize_counted(problem, seed, &mut ())
}

/// [`minimize`], counting its operations.
pub fn minimize_counted(problem: &LadProblem, seed: u64, tally: &mut impl Tally) -> LadOutcome {
    let instance = Instance::whole(problem);
    LadOutcome::new(solve_with(&instance, seed, tally, |first, tally| search(&instance, first, seed, tally)))
}

/// Solves an instance in which two lines cross.
pub(crate) fn search<T: Tally>(instance: &Instance, first: u32, seed: u64, tally: &mut T) -> Solution {
    search_above(SMALL, instance, first, seed, tally)
}

/// [`minimize`], pruning whenever there are more than `small` lines.
#[cfg(test)]
pub(super) fn minimize_above(small: usize, problem: &LadProblem, seed: u64) -> LadOutcome {
    let instance = Instance::whole(problem);
    LadOutcome::new(solve_with(&instance, seed, &mut (), |first, tally| {
        search_above(small, &instance, first, seed, tally)
    }))
}

fn search_above<T: Tally>(small: usize, instance: &Instance, first: u32, seed: u64, tally: &mut T) -> Solution {
    if instance.len() <= small {
        return descend(instance, SearchLine::of(instance, first), seed, tally);
    }
    let mut random = Pcg64Mcg::seed_from_u64(seed);
    let Some((mut cell, mut best)) = first_cell(small, instance, &mut random, tally) else {
        return descend(instance, SearchLine::of(instance, first), seed, tally);
    };
    for _ in 0..ROUNDS {
        tally.add(Operation::SearchStep, 1);
        let split = cell.split(instance, tally);
        if 2 * split.crossing.len() > instance.len() {
            break;
        }
        match within(small, instance, split, random.random(), tally) {
            Solution::Optimal(optimal) => match &optimal.vertex {
                Some(vertex) if cell.contains(vertex.point) && optimal.defining.len() == 2 => {
                    return Solution::Optimal(optimal);
                }
                Some(vertex) => {
                    cell = cell.moved_towards(vertex.point, 4.0);
                    best = vertex.clone();
                }
                None => cell = cell.moved_towards(cell.center, 8.0),
            },
            Solution::Unbounded { .. } => cell = cell.moved_towards(cell.center, 8.0),
        }
    }
    descend_from(instance, Vertex::at(best.exact), seed, tally)
}

fn solve_above<T: Tally>(small: usize, instance: &Instance, seed: u64, tally: &mut T) -> Solution {
    solve_with(instance, seed, tally, |first, tally| search_above(small, instance, first, seed, tally))
}

/// The cell around the optimum of a sample, and that optimum.
fn first_cell<T: Tally>(
    small: usize,
    instance: &Instance,
    random: &mut Pcg64Mcg,
    tally: &mut T,
) -> Option<(Cell, Vertex)> {
    let sample = sample(small, instance, random);
    tally.add(Operation::LineEvaluation, sample.len() as u64);
    let Solution::Optimal(optimal) = solve_above(small, &sample, random.random(), tally) else { return None };
    let vertex = optimal.vertex?;
    let center = vertex.point;
    let frame = Frame::of(&sample)?;
    let radius = radius(&sample, center, frame)?;
    let cell = Cell::new(center, radius, frame);
    (center[0].is_finite() && center[1].is_finite()).then_some((cell, vertex))
}

/// About n^(2/3) lines, one from each of as many equal stretches, with the linear term in proportion.
fn sample<'p>(small: usize, instance: &Instance<'p>, random: &mut Pcg64Mcg) -> Instance<'p> {
    let n = instance.len();
    let size = (2 * integer_cube_root(n).pow(2)).clamp((small / 4).max(1), (n / 4).max(1));
    let lines: Vec<u32> = (0..size)
        .map(|i| {
            let (start, end) = (i * n / size, (i + 1) * n / size);
            random.random_range(start..end) as u32
        })
        .collect();
    let share = size as f64 / n as f64;
    let linear = instance.linear.map(|v| v * share);
    instance.selection(&lines, linear, ExactLinear::known(linear.map(Dyadic::from_f64)))
}

fn integer_cube_root(n: usize) -> usize {
    (1..).find(|root: &usize| (root + 1).pow(3) > n).expect("cubes grow past every number of lines")
}

/// The radius at which the crossing lines can make up for DEVIATIONS standard deviations of the sample's gradient.
fn radius(sample: &Instance, [cx, cy]: [f64; 2], frame: Frame) -> Option<f64> {
    let columns = &*sample.columns;
    let mut reached: Vec<(f64, f64)> = (0..sample.len())
        .map(|i| {
            let (x, y) = (columns.normal_x[i], columns.normal_y[i]);
            let reach = frame.reach(x, y);
            ((x * cx + y * cy + columns.offset[i]).abs() / reach, reach)
        })
        .filter(|(distance, reach)| distance.is_finite() && *reach > 0.0)
        .collect();
    let needed = DEVIATIONS * reached.iter().map(|(_, reach)| reach * reach).sum::<f64>().sqrt();
    reached.sort_unstable_by(|a, b| a.0.total_cmp(&b.0));
    let mut gathered = 0.0;
    reached.iter().find_map(|&(distance, reach)| {
        gathered += reach;
        (gathered >= needed && distance > 0.0).then_some(distance)
    })
}

/// The solution of the lines that cross a cell, with the signs of all the others.
fn within<T: Tally>(small: usize, instance: &Instance, split: Split, seed: u64, tally: &mut T) -> Solution {
    let Split { crossing, signs, sum, sum_error } = split;
    let remainder = instance.remainder(&crossing, signs, sum, sum_error);
    match solve_above(small, &remainder, seed, tally) {
        Solution::Optimal(optimal) => Solution::Optimal(Box::new(lift(*optimal, &remainder, &crossing))),
        unbounded => unbounded,
    }
}

/// A solution of the remainder as one of the instance.
fn lift(optimal: Optimal, remainder: &Instance, crossing: &[u32]) -> Optimal {
    let mut signs = remainder.fixed_signs().to_vec();
    for (&line, &sign) in crossing.iter().zip(&optimal.signs) {
        signs[line as usize] = sign;
    }
    let rename = |lines: Vec<u32>| lines.into_iter().map(|line| crossing[line as usize]).collect();
    Optimal { defining: rename(optimal.defining), basis: rename(optimal.basis), signs, ..optimal }
}
