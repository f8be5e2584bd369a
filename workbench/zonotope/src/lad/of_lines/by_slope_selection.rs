//! Weighted least absolute deviations in the plane, by halving the vertices of the arrangement with vertical lines: the
//! paper's search.
//!
//! # Source
//! Section 4.1, Theorem 4.5, stated there for the area of the enclosing zonogon and used again in Theorem 5.2.
//! Departures:
//! - The paper reads the side off "the linear coefficient of f at O_ℓ", which is not defined, since O_ℓ lies on a line
//!   of the arrangement. The side is decided by the subdifferential there: by a line through O_ℓ along which the
//!   objective falls.
//! - Corollary 4.4 (unimodal) is too weak for that; the objective is convex.
//! - The paper assumes general position. Here ℓ passes through the median vertex, and every vertex on ℓ is discarded
//!   with it: ties and vertical lines are no special cases.
//! - The objective may be unbounded: then a line ℓ has no minimum or the vertices run out.
//!
//! # Method
//! 1. The candidates are the vertices in an open strip between two vertical lines: at first all.
//! 2. Select the median candidate ([`randomized`](crate::arrangement::slope_selection::randomized)) and search along
//!    the vertical line ℓ through it for the minimum O_ℓ (Lemma 4.2).
//! 3. If no line through O_ℓ descends, O_ℓ is a minimiser; when it is not a vertex, go along its line to one.
//! 4. Else every minimiser lies on the side to which that line descends: keep the part of the strip there, go on with
//!    2.
//! 5. When no candidate is left the descending line meets no further line: the objective falls for ever along it.
//!
//! # Complexity
//! n lines: expected O(n log² n), the paper's bound: at most 2 log₂ n vertical lines, since each leaves at most half of
//! the candidates, each with O(n log n) expected for the selection and for cutting the strip, and O(n) expected for the
//! minimum on it, where the paper sorts in O(n log n). Space O(n).
//!
//! # Numerics
//! Every decision (order along a line, order of abscissas, sign of a slope) is exact: filtered floating point, then
//! exact dyadic arithmetic.
//!
//! # Example
//! ```
//! use zonotope::lad::{LadProblem, WeightedLine, by_slope_selection};
//! use zonotope::lad::by_slope_selection::Side;
//! // |x − 1| + |y − 2| + |x + y| is 3 at its minimisers (1, 2), (1, −1), (−2, 2) and all points between.
//! let lines = [([1.0, 0.0], -1.0), ([0.0, 1.0], -2.0), ([1.0, 1.0], 0.0)];
//! let lines = lines.map(|(normal, offset)| WeightedLine::unweighted(normal, offset));
//! let problem = LadProblem::new(&lines, [0.0, 0.0]).unwrap();
//! let (outcome, steps) = by_slope_selection::trace(&problem, 0);
//! assert_eq!(outcome.optimum().unwrap().exact_value(&problem), Some(3.into()));
//! assert_eq!((steps[0].x, steps[0].vertices_before, steps[0].side), (1.0, 3, Side::Optimal));
//! ```

use std::cmp::Ordering;

use rand::SeedableRng;
use rand_pcg::Pcg64Mcg;

use super::by_pruning::tie_break;
use super::descent::{Decision, LineMinimum, SearchLine, Solution, TieBreak, at_vertex, decide, descend, solve_with};
use super::input::LadProblem;
use super::optimum::LadOutcome;
use super::subproblem::{Subdifferential, Subproblem, Vertex};
use crate::arrangement::ExactLine;
use crate::arrangement::fraction::Fraction;
use crate::arrangement::lines::{LineArrangement, LineSource};
use crate::arrangement::slope_selection::randomized::select;
use crate::arrangement::slope_selection::slab::Slab;
use crate::numeric::Rational;
use crate::numeric::dyadic::Dyadic;
use crate::numeric::scaling::scale_by_power_of_two;
use crate::tally::Tally;

/// One vertical line of the search, with what was found on it.
#[derive(Debug, Clone, PartialEq)]
pub struct SearchStep {
    /// The abscissa of the vertical line, within a relative 2^-50.
    pub x: f64,
    /// The exact abscissa of the vertical line.
    pub exact_x: Rational,
    /// The number of candidate vertices before the line was drawn.
    pub vertices_before: u64,
    /// The number of candidate vertices that the line leaves.
    pub vertices_after: u64,
    /// The point at which the objective is least on the line, if it is bounded there; each coordinate within a relative
    /// 2^-50.
    pub minimum: Option<[f64; 2]>,
    /// That point, exactly.
    pub exact_minimum: Option<[Rational; 2]>,
    /// The side of the vertical line on which the minimisers lie.
    pub side: Side,
}

/// The side of a vertical line on which the minimisers lie.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Side {
    /// The minimisers lie strictly left of the line, if there are any.
    Left,
    /// The minimum on the line is a minimiser.
    Optimal,
    /// The minimisers lie strictly right of the line, if there are any.
    Right,
    /// There is no minimiser: the objective is unbounded on the line.
    Unbounded,
}

impl SearchStep {
    /// The step at other coordinates.
    pub(crate) fn new(exact_x: Rational, exact_minimum: Option<[Rational; 2]>, step: Self) -> Self {
        let rounded = |value: &Rational| value.to_f64().value();
        let minimum = exact_minimum.as_ref().map(|point| point.each_ref().map(rounded));
        Self { x: rounded(&exact_x), exact_x, minimum, exact_minimum, ..step }
    }
}

/// Minimises a problem by the paper's search. `seed` decides the time, never the minimum.
pub fn minimize(problem: &LadProblem, seed: u64, tally: &mut impl Tally) -> LadOutcome {
    solve(problem, seed, tally, &mut |_, _| ())
}

/// [`minimize`], with every vertical line that the search draws; none when no two lines cross.
pub fn trace(problem: &LadProblem, seed: u64) -> (LadOutcome, Vec<SearchStep>) {
    let mut steps = Vec::new();
    let outcome = solve(problem, seed, &mut (), &mut |vertical, after| {
        steps.push(vertical.step(problem, after));
    });
    (outcome, steps)
}

fn solve<T: Tally>(
    problem: &LadProblem,
    seed: u64,
    tally: &mut T,
    record: &mut impl FnMut(&VerticalLine, u64),
) -> LadOutcome {
    let subproblem = Subproblem::whole(problem);
    let ties = tie_break(seed);
    LadOutcome::new(solve_with(&subproblem, &ties, tally, |_, tally| search(&subproblem, &ties, tally, record)))
}

/// Solves a subproblem in which two lines cross; `record` is given each vertical line and the number of candidates that
/// it leaves.
fn search<T: Tally>(
    subproblem: &Subproblem,
    ties: &TieBreak<T>,
    tally: &mut T,
    record: &mut impl FnMut(&VerticalLine, u64),
) -> Solution {
    let arrangement = LineArrangement::new(Box::new(Terms(subproblem)), tally);
    let mut random = Pcg64Mcg::seed_from_u64(ties.seed);
    let mut slab = Slab::whole(&arrangement);
    loop {
        let candidates = slab.vertex_count();
        let median = select(&arrangement, &slab, (candidates - 1) / 2, &mut random, tally);
        let vertical = VerticalLine::search(subproblem, arrangement.abscissa(median), candidates, ties, tally);
        let half = match vertical.side {
            Side::Left | Side::Right => {
                let cut = slab.cut(&arrangement, &vertical.x, tally);
                if vertical.side == Side::Left { slab.left_of(&arrangement, &cut) } else { slab.right_of(&cut) }
            }
            Side::Optimal | Side::Unbounded => Slab::empty(),
        };
        record(&vertical, half.vertex_count());
        if half.vertex_count() == 0 {
            return vertical.conclude(subproblem, ties, tally);
        }
        slab = half;
    }
}

/// A vertical line with what was found on it.
struct VerticalLine {
    x: Fraction,
    candidates: u64,
    minimum: Option<Box<Vertex>>,
    around: Subdifferential,
    verdict: Verdict,
    side: Side,
}

enum Verdict {
    Decided(Decision),
    Unbounded { upward: bool },
}

impl VerticalLine {
    /// Finds the minimum on the vertical line at an abscissa, and the side on which the minimisers lie.
    fn search<T: Tally>(
        subproblem: &Subproblem,
        x: Fraction,
        candidates: u64,
        ties: &TieBreak<T>,
        tally: &mut T,
    ) -> Self {
        let normal = [x.denominator.clone(), Dyadic::zero()];
        let line = SearchLine::free(ExactLine { normal, offset: -x.numerator.clone() });
        let mut around = Subdifferential::default();
        let (minimum, verdict) = match line.minimize(subproblem, &mut around, tally) {
            LineMinimum::At(vertex) => (Some(vertex), Verdict::Decided(decide(subproblem, &around, ties, tally))),
            LineMinimum::Unbounded { forward } => (None, Verdict::Unbounded { upward: forward }),
            LineMinimum::Flat => unreachable!("a line that is not vertical passes through the vertex on this line"),
        };
        let side = match &verdict {
            Verdict::Unbounded { .. } => Side::Unbounded,
            Verdict::Decided(Decision::Optimal { .. }) => Side::Optimal,
            Verdict::Decided(Decision::Descend { line, forward }) => {
                match SearchLine::of(subproblem, *line).oriented(subproblem, *forward)[0].sign() {
                    Ordering::Less => Side::Left,
                    Ordering::Greater => Side::Right,
                    Ordering::Equal => unreachable!("the minimum of a vertical line is not left along that line"),
                }
            }
        };
        Self { x, candidates, minimum, around, verdict, side }
    }

    /// The solution, where no candidate vertex is left.
    fn conclude<T: Tally>(self, subproblem: &Subproblem, ties: &TieBreak<T>, tally: &mut T) -> Solution {
        let unbounded = |direction| Solution::Unbounded { direction, along: None };
        match (self.verdict, self.minimum) {
            (Verdict::Decided(Decision::Optimal { through, basis, face_dimension }), Some(vertex)) => {
                if basis.len() == 2 {
                    at_vertex(subproblem, *vertex, self.around, through, basis, face_dimension)
                } else {
                    descend(subproblem, SearchLine::of(subproblem, basis[0]), ties, tally)
                }
            }
            (Verdict::Decided(Decision::Descend { line, forward }), _) => {
                unbounded(SearchLine::of(subproblem, line).oriented(subproblem, forward))
            }
            (Verdict::Unbounded { upward }, _) => {
                unbounded([Dyadic::zero(), Dyadic::from_f64(if upward { 1.0 } else { -1.0 })])
            }
            (_, None) => unreachable!("a minimiser on a line is its minimum"),
        }
    }

    fn step(&self, problem: &LadProblem, vertices_after: u64) -> SearchStep {
        let scale = problem.point_scale();
        let x = Fraction { numerator: self.x.numerator.clone().scaled(scale), ..self.x.clone() };
        let exact_minimum = self.minimum.as_ref().map(|vertex| {
            let [x, y, w] = vertex.exact(problem);
            [x, y].map(|c| c.clone().scaled(scale).to_rational() / w.to_rational())
        });
        SearchStep {
            x: x.to_f64(),
            exact_x: x.to_rational(),
            vertices_before: self.candidates,
            vertices_after,
            minimum: self.minimum.as_ref().map(|vertex| vertex.point.map(|v| scale_by_power_of_two(v, scale))),
            exact_minimum,
            side: self.side,
        }
    }
}

/// The lines of a subproblem.
#[derive(Debug)]
struct Terms<'i, 'p>(&'i Subproblem<'p>);

impl LineSource for Terms<'_, '_> {
    fn len(&self) -> usize {
        self.0.len()
    }

    fn line(&self, index: u32) -> ExactLine {
        self.0.exact_line(index)
    }
}

#[cfg(test)]
mod tests;
