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
//! 4. One pass: sum up the lines that certainly miss the cell, keep the others. Their density and the gradient at the centre say where in
//!    the cell the optimum is expected, and how far off that may be: a smaller cell.
//! 5. If the optimum is expected far outside, move the cell there; if most lines cross the cell, take the smaller one; go to 4. Else solve
//!    the lines kept, recursively, starting with the smaller cell instead of a sample.
//! 6. If their optimum lies in the interior of the cell it is the answer; else move and enlarge the cell and go to 4.
//! 7. After `ROUNDS` cells, or when all lines cross one, descend from the last optimum found by line searches.
//!
//! # Complexity
//! n lines: expected O(n), with about one pass over the lines and O(n^(2/3) √(log n)) lines in the sample and kept; worst case that of line searches.
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
use super::descent::line_search::{SearchLine, weighted_select};
use super::descent::solution::{Near, Optimal, Solution};
use super::descent::solve::{descend, descend_from, solve_with};
use super::input::problem::LadProblem;
use super::optimum::LadOutcome;
use super::subproblem::instance::Instance;
use super::subproblem::vertex::Vertex;
use crate::tally::{Operation, Tally};

/// At most this many lines are solved by line searches alone, and a quarter of them where a cell is expected to contain the optimum.
const SMALL: usize = 50;

/// How many cells are tried.
const ROUNDS: usize = 5;

/// A cell that more than this share of the lines crosses is not worth a recursion.
const MOST: f64 = 0.8;

/// An optimum expected at more than this many radii from the centre is looked for there at once.
const FAR: f64 = 1.25;

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
    search_above(SMALL, instance, None, first, seed, tally)
}

/// [`minimize`], pruning whenever there are more than `small` lines.
#[cfg(test)]
pub(super) fn minimize_above(small: usize, problem: &LadProblem, seed: u64) -> LadOutcome {
    let instance = Instance::whole(problem);
    LadOutcome::new(solve_with(&instance, seed, &mut (), |first, tally| {
        search_above(small, &instance, None, first, seed, tally)
    }))
}

/// Searches in the cell that is expected to contain the optimum, if there is one.
fn search_above<T: Tally>(
    small: usize,
    instance: &Instance,
    expected: Option<Cell>,
    first: u32,
    seed: u64,
    tally: &mut T,
) -> Solution {
    let descend_from_first = |tally: &mut T| descend(instance, SearchLine::of(instance, first), seed, tally);
    if instance.len() <= if expected.is_some() { small / 4 } else { small } {
        return descend_from_first(tally);
    }
    let mut random = Pcg64Mcg::seed_from_u64(seed);
    let (cell, mut best) = match expected {
        Some(cell) => (Some(cell), None),
        None => match first_cell(small, instance, &mut random, tally) {
            Some((cell, vertex)) => (cell, Some(vertex)),
            None => return descend_from_first(tally),
        },
    };
    if let Some(cell) = cell
        && let Some(solution) = search_near(small, instance, cell, &mut best, &mut random, tally)
    {
        return solution;
    }
    match best {
        Some(vertex) => descend_from(instance, Vertex::at(vertex.exact), seed, tally),
        None if instance.len() > small => search_above(small, instance, None, first, random.random(), tally),
        None => descend_from_first(tally),
    }
}

/// Searches in a cell and in others near it; `best` is left at the last optimum of the lines that cross one.
fn search_near<T: Tally>(
    small: usize,
    instance: &Instance,
    mut cell: Cell,
    best: &mut Option<Vertex>,
    random: &mut Pcg64Mcg,
    tally: &mut T,
) -> Option<Solution> {
    for _ in 0..ROUNDS {
        tally.add(Operation::SearchStep, 1);
        let split = cell.split(instance, tally);
        let crossing = split.crossing.len();
        if crossing == instance.len() && crossing > small {
            return None;
        }
        let rest = [0, 1].map(|i| instance.linear[i] + split.sum[i]);
        let expected = match cell.expected(rest, &split.bend) {
            Some((narrower, distance)) if distance > FAR && crossing < instance.len() => {
                cell = narrower.moved(narrower.center, cell.radius);
                continue;
            }
            expected => expected.map(|(narrower, _)| narrower),
        };
        if crossing as f64 > MOST * instance.len() as f64 {
            cell = expected?;
            continue;
        }
        if let Solution::Optimal(optimal) = within(small, instance, cell, split, expected, random.random(), tally)
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
    small: usize,
    instance: &Instance,
    random: &mut Pcg64Mcg,
    tally: &mut T,
) -> Option<(Option<Cell>, Vertex)> {
    let sample = sample(small, instance, random);
    sample.count_pass(tally);
    let seed = random.random();
    let solution =
        solve_with(&sample, seed, tally, |first, tally| search_above(small, &sample, None, first, seed, tally));
    let Solution::Optimal(optimal) = solution else { return None };
    let vertex = optimal.vertex?;
    let center = vertex.point;
    let cell = Frame::of(&sample)
        .filter(|_| center.iter().all(|v| v.is_finite()))
        .and_then(|frame| Some(Cell::new(center, radius(&sample, instance.len(), center, frame, tally)?, frame)));
    Some((cell, vertex))
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
    instance.sample(&lines, linear)
}

fn integer_cube_root(n: usize) -> usize {
    (1..).find(|root: &usize| (root + 1).pow(3) > n).expect("cubes grow past every number of lines")
}

/// The radius at which the crossing lines can make up for the sampling error of the gradient at t = √(⅔ ln n) standard deviations:
/// the cell of n lines misses the optimum with probability about exp(−t²/2) = n^(−1/3), which is the share of the lines that it keeps.
///
/// A radius along an axis changes the gradient by 1 / (2 + 4/π) of the reach gathered on both sides of the centre, when the normals point
/// everywhere; the error there has 1 / (2 + 4/π) of the variance Σ reach². So √(2 + 4/π) = 1.81 deviations of that sum are gathered for one.
/// The radius is estimated from so many of the sample's lines that at least sixty cross.
fn radius<T: Tally>(sample: &Instance, n: usize, [cx, cy]: [f64; 2], frame: Frame, tally: &mut T) -> Option<f64> {
    let size = sample.len() as f64;
    let step = (size / (12.0 * size.sqrt())).max(1.0) as usize;
    let mut reached: Vec<(f64, f64)> = (0..sample.len())
        .step_by(step)
        .map(|i| {
            let ([x, y, b], _) = sample.lines.row(i);
            let reach = frame.reach(x, y);
            ((x * cx + y * cy + b).abs() / reach, reach)
        })
        .filter(|(distance, reach)| distance.is_finite() && *reach > 0.0)
        .collect();
    tally.add(Operation::PartEvaluation, reached.len() as u64);
    tally.add(Operation::Comparison, 2 * reached.len() as u64);
    let squares = reached.iter().map(|(_, reach)| reach * reach).sum::<f64>();
    let deviations = (2.0 / 3.0 * std::f64::consts::LN_2 * f64::from(n.ilog2())).sqrt();
    let needed = 1.81 * deviations * (squares / step as f64).sqrt();
    let smallest = reached.iter().map(|r| r.0).filter(|distance| *distance > 0.0).reduce(f64::min)?;
    let (distance, _) = *weighted_select(&mut reached, needed, |a, b| a.0.total_cmp(&b.0), |(_, reach)| *reach);
    Some(distance.max(smallest))
}

/// The solution of the lines that cross a cell, with the signs of all the others.
fn within<T: Tally>(
    small: usize,
    instance: &Instance,
    cell: Cell,
    split: Split,
    expected: Option<Cell>,
    seed: u64,
    tally: &mut T,
) -> Solution {
    let Split { crossing, rows, signs, sum, sum_error, .. } = split;
    let remainder = instance.remainder(&crossing, rows, signs, sum, sum_error);
    let solution = solve_with(&remainder, seed, tally, |first, tally| {
        search_above(small, &remainder, expected, first, seed, tally)
    });
    match solution {
        Solution::Optimal(optimal) => Solution::Optimal(Box::new(lift(*optimal, &remainder, Near { cell, crossing }))),
        unbounded => unbounded,
    }
}

/// A solution of the remainder, the lines that cross a cell, as one of the instance.
fn lift(optimal: Optimal, remainder: &Instance, near: Near) -> Optimal {
    let crossing = &near.crossing;
    let mut signs = remainder.fixed_signs().to_vec();
    for (&line, &sign) in crossing.iter().zip(&optimal.signs) {
        signs[line as usize] = sign;
    }
    let rename = |lines: Vec<u32>| lines.into_iter().map(|line| crossing[line as usize]).collect();
    let [defining, through, basis] = [optimal.defining, optimal.through, optimal.basis].map(rename);
    Optimal { defining, through, signs, basis, near: Some(near), ..optimal }
}
