//! The search by samples with a corrected gradient: slower than Newton steps on a smooth objective, but safe where
//! many lines nearly meet.
//!
//! 1. The optimum of a sample's objective is found by descent from vertex to vertex.
//! 2. One pass over all generators gives a cell around that point, the lines that cross the cell, and the gradient of
//!    the whole objective at the point.
//! 3. The difference between that gradient and the sample's is added to the sample's objective as a linear term. Then
//!    the next optimum of the sample differs from that of all lines only by the contribution of the lines between the
//!    two points.
//! 4. A cell that many lines cross is searched in the same way, by a sample of those lines.

use super::narrowing::{Ended, descend_and_certify};
use crate::lad::of_generators::cells::reduced::Reduced;
use crate::lad::of_generators::certify::rounded_optimum::{RoundedOptimum, Unproved};
use crate::lad::of_generators::guess::aim::{Aim, SAMPLE_DEVIATIONS};
use crate::lad::of_generators::guess::sample::Sample;
use crate::lad::of_generators::plane::in_doubles::RoundedLines;
use crate::lad::of_generators::problem::Problem;
use crate::lad::of_generators::seam::direction_cone::DirectionCone;
use crate::numeric::reused::{Reused, ReusedBox};
use crate::tally::{Operation, Tally};

/// The number of times that a sample is corrected.
const CORRECTIONS: usize = 3;

/// At most this many lines of a level are searched without a sample of them.
const DESCENT_LINES: usize = 1200;

/// The least number of lines in a sample of a level.
const LEAST_SAMPLE: usize = 128;

/// A vertex found from other lines is tried if the sample's objective there exceeds its minimum by no more than this
/// part.
const LIKELY_EXCESS: f64 = 1e-2;

/// The size, in terms of its centre, of a cell that only parallel lines cross: doubles cannot tell where two such
/// lines meet.
const PARALLEL_CELL: f64 = 1e-6;

/// Problems, each reduced from the one before, that are searched for one optimum.
pub(crate) struct CorrectedSample<'a, 'q> {
    pub(crate) problem: &'a Problem<'q>,
    pub(crate) levels: Reused<Reduced>,
    /// The generators of the vertex at which the last descent ended.
    pub(crate) vertex: Option<[usize; 2]>,
    pub(crate) tally: &'a mut dyn Tally,
}

/// Why there is no optimum yet.
#[derive(Debug, Clone, Copy)]
pub(crate) enum NotCertified {
    /// The optimum is not in the cell of this level, 0 being the first; perhaps it is at this point.
    Outside(usize, Option<[f64; 2]>),
    /// Doubles do not tell.
    Doubt,
}

/// A part of the lines of a level, which stands for all of them.
struct Part {
    lines: RoundedLines,
    /// The part's share of all lines.
    share: f64,
    linear: [f64; 2],
    aim: Aim,
}

impl Part {
    /// Whether the objective at a point is hardly greater than at the optimum.
    fn is_likely(&self, point: [f64; 2], optimum: [f64; 2]) -> bool {
        let [value, least] = [point, optimum].map(|point| self.lines.value(self.linear, point));
        value <= least + LIKELY_EXCESS * least.abs()
    }
}

impl CorrectedSample<'_, '_> {
    /// The optimum, seen from a sample of all generators.
    pub(crate) fn of_sample(&mut self, sample: &Sample) -> Result<ReusedBox<RoundedOptimum>, NotCertified> {
        let (n, len) = (self.problem.query.len(), sample.vectors.len());
        let lines = self.problem.chart.lines(&sample.vectors);
        let aim = Aim { longest: sample.longest, ..Aim::new(len, n, SAMPLE_DEVIATIONS).thin() };
        // in a sample by length, generators that were made longer stand for the others already
        let share = if sample.longest < f64::INFINITY { 1.0 } else { len as f64 / n as f64 };
        self.narrow(Part { lines, share, linear: [0.0; 2], aim }, None)
    }

    /// The optimum of the last level.
    fn solve(&mut self, point: [f64; 2]) -> Result<ReusedBox<RoundedOptimum>, NotCertified> {
        let depth = self.levels.len();
        let level = self.levels.last().ok_or(NotCertified::Doubt)?;
        let (lines, linear) = (level.lines(&self.problem.chart), level.linear(&self.problem.chart));
        if lines.len() > DESCENT_LINES {
            let share = (lines.len() / LEAST_SAMPLE).min(lines.len().isqrt() / 5);
            let aim = Aim::new(lines.len() / share, lines.len(), SAMPLE_DEVIATIONS).thin();
            let part = Part {
                lines: lines.part(share),
                share: 1.0 / share as f64,
                linear: linear.map(|c| c / share as f64),
                aim,
            };
            match self.narrow(part, Some(point)) {
                Err(NotCertified::Outside(place, _)) if place >= depth => {}
                result => return result,
            }
        }
        self.tally.add(Operation::GeneratorRead, lines.len() as u64);
        let ended = descend_and_certify(self.problem, &self.levels, &lines, linear, point);
        let Some(Ended { point, vertex, result }) = ended else {
            return Err(NotCertified::Outside(depth - 1, None));
        };
        self.vertex = self.levels.last().map(|level| level.indices_of(vertex));
        result.map_err(|unproved| match unproved {
            Unproved::Astray(place) => NotCertified::Outside(place, Some(point)),
            Unproved::Doubt | Unproved::Falls(_) => NotCertified::Doubt,
        })
    }

    /// The optimum of the last level, or of all generators, seen from some of its lines.
    fn narrow(&mut self, mut part: Part, start: Option<[f64; 2]>) -> Result<ReusedBox<RoundedOptimum>, NotCertified> {
        let depth = self.levels.len();
        let outside = Err(NotCertified::Outside(depth, None));
        let mut found = None;
        let mut before = None;
        let mut point = start.or_else(|| part.lines.least_squares().map(|(point, _)| point)).unwrap_or_default();
        for round in 0..CORRECTIONS {
            let Some(vertex) = part.lines.optimum(part.linear, point) else { return outside };
            point = found.take().filter(|found| part.is_likely(*found, vertex)).unwrap_or(vertex);
            let cell = match part.lines.guess_at(point, before, part.aim) {
                Some(guess) => self.problem.chart.cell(&guess, 1.0),
                None => {
                    let center = self.problem.chart.point(point);
                    let ball = PARALLEL_CELL * center.iter().fold(0.0f64, |m, c| m.max(c.abs()));
                    DirectionCone { center, axes: None, ball }
                }
            };
            self.tally.add(Operation::SearchStep, 1);
            let (reduced, len) = match self.levels.last() {
                Some(level) => (level.split(cell), level.vectors.len()),
                None => {
                    let reduced = Reduced::of_query(self.problem.query, cell);
                    self.tally.add(Operation::GeneratorRead, reduced.fixed.read as u64);
                    (reduced, self.problem.query.len())
                }
            };
            if !reduced.is_moderate() {
                return Err(NotCertified::Doubt);
            }
            let (all, own) = (reduced.gradient(&self.problem.chart, point), part.lines.gradient(point));
            part.linear = [0, 1].map(|k| part.share * all[k] - own[k]);
            before = Some(point);
            let most = DESCENT_LINES.max(len / 4);
            if reduced.vectors.len() > most && (round + 1 < CORRECTIONS || 4 * reduced.vectors.len() > 3 * len) {
                continue;
            }
            self.levels.push(reduced);
            match self.solve(point) {
                Err(NotCertified::Outside(place, vertex)) if place >= depth => {
                    found = vertex;
                    self.levels.truncate(depth);
                }
                result => return result,
            }
        }
        outside
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::lad::of_generators::cells::reduced::USUAL_LEVELS;
    use crate::lad::of_generators::certify::unit_gauge_bound::unit_gauge_bound;
    use crate::lad::of_generators::goal::Goal;
    use crate::zonotope::query::Query;
    use rand::{RngExt, SeedableRng};
    use rand_pcg::Pcg64Mcg;

    /// Generators of four kinds: even; nine in ten nearly in a plane; of lengths from 1 to thousands; in seven
    /// directions but for noise.
    fn body(kind: usize, n: usize, random: &mut Pcg64Mcg) -> Vec<[f64; 3]> {
        let directions: Vec<[f64; 3]> = (0..7).map(|_| [0, 1, 2].map(|_| random.random_range(-1.0..1.0))).collect();
        let mut vector = |i: usize| {
            let v = [0, 1, 2].map(|_| random.random_range(-1.0..1.0f64));
            match kind {
                0 => v,
                1 if i.is_multiple_of(10) => v,
                1 => [v[0], v[1], v[0] + 1e-6 * v[2]],
                2 => v.map(|c| c / (1.0 - random.random_range(0.0..1.0f64))),
                _ => [0, 1, 2].map(|k| directions[i % 7][k] + 1e-9 * v[k]),
            }
        };
        (0..n).map(&mut vector).collect()
    }

    #[test]
    fn the_optimum_is_found_where_lines_nearly_meet_and_where_they_do_not() {
        let random = &mut Pcg64Mcg::seed_from_u64(11);
        for kind in 0..4 {
            for n in [300, 2000] {
                let mut found = 0;
                for _ in 0..10 {
                    let body = body(kind, n, random);
                    let p = [0, 1, 2].map(|_| random.random_range(-1.0..1.0));
                    let query = Query::new([0.0; 3], p, &body).expect("finite");
                    let sample = Sample::of(&query, &mut ());
                    let problem = Problem::new(&query, crate::numeric::bounded::exact(p), Goal::Location);
                    let tally = &mut ();
                    let mut search = CorrectedSample {
                        problem: &problem,
                        levels: Reused::with_capacity(USUAL_LEVELS),
                        vertex: None,
                        tally,
                    };
                    if let Ok(optimum) = search.of_sample(&sample) {
                        assert!(optimum.missing <= 1e-9 * optimum.reach.value);
                        found += usize::from(optimum.slack(unit_gauge_bound(&query, 1)) < 1e-9);
                    }
                }
                assert!(found >= 9, "kind {kind}, {n} generators: {found} of 10");
            }
        }
    }
}
