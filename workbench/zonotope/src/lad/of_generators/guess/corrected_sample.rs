//! The optimum by samples with the right gradient: slower than Newton steps on a smooth objective, but sure where many lines nearly meet.
//!
//! The optimum of a sample is found from vertex to vertex. One pass over all lines gives a cell around it, the lines that cross the cell, and the gradient of the
//! whole objective at that point. What the sample's gradient lacks there is added to the sample's objective, so that the next optimum differs from that of all lines
//! only by what the lines between the two points contribute. A cell that many lines cross is searched in the same way.

use crate::lad::of_generators::cells::direction_cone::Cell;
use crate::lad::of_generators::cells::reduced::Reduced;
use crate::lad::of_generators::certify::rounded_optimum::{Certain, Unproved};
use crate::lad::of_generators::guess::huber_newton::Aim;
use crate::lad::of_generators::guess::sample::Sample;
use crate::lad::of_generators::guess::vertex_descent::{descend_along, descend_nearly};
use crate::lad::of_generators::ladder::{SAMPLE_DEVIATIONS, aim, careful, is_moderate};
use crate::lad::of_generators::plane::rounded_chart::Chart;
use crate::lad::of_generators::plane::rounded_lines::Lines;
use crate::numeric::bounded::BoundedVector;
use crate::tally::{Operation, Tally};
use crate::zonotope::query::Query;

/// How often a sample is corrected.
const ROUNDS: usize = 5;

/// At most so many lines are searched without a sample.
const DIRECT: usize = 1200;

/// The least sample.
const LEAST: usize = 128;

/// A vertex found from other lines is tried if the sample's objective there is greater than its minimum by no more than this part.
const LIKELY: f64 = 1e-2;

/// The least size of a cell that only parallel lines cross, in terms of its centre: not even doubles tell where two of them meet.
const PARALLEL: f64 = 1e-6;

/// How often the descent goes on from a vertex in which many lines meet.
const TURNS: usize = 8;

/// A vertex is tried if the objective falls from it by no more than this, in terms of its kink there.
const NEARLY: f64 = 2e-8;

/// Problems, each reduced from the one before, that are searched for one optimum.
pub(crate) struct Settling<'a, 'q, T> {
    pub(crate) query: &'a Query<'q, 3>,
    pub(crate) chart: &'a Chart,
    pub(crate) p: &'a BoundedVector,
    pub(crate) is_enough: &'a dyn Fn(&Certain) -> bool,
    pub(crate) levels: Vec<Reduced>,
    pub(crate) tally: &'a mut T,
}

/// Why there is no optimum yet.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Unsettled {
    /// It is not in the cell of this level, the first one is 0; perhaps it is here.
    Outside(usize, Option<[f64; 2]>),
    /// Doubles do not tell.
    Doubt,
}

/// Lines that stand for all of a level.
struct Part {
    lines: Lines,
    /// How many of all they are.
    share: f64,
    linear: [f64; 2],
    aim: Aim,
}

impl Part {
    /// Whether the objective at a point is hardly greater than at the optimum.
    fn is_likely(&self, point: [f64; 2], optimum: [f64; 2]) -> bool {
        let [value, least] = [point, optimum].map(|point| self.lines.value(self.linear, point));
        value <= least + LIKELY * least.abs()
    }
}

/// The optimum of the last level from a point near it, proved for all levels.
///
/// Where the objective falls along one of many lines that meet in a vertex, the descent goes on; so it does from a vertex that is nearly optimal and not enough.
pub(crate) fn descend_and_prove(
    levels: &[Reduced],
    lines: &Lines,
    linear: [f64; 2],
    p: &BoundedVector,
    point: [f64; 2],
    is_enough: &dyn Fn(&Certain) -> bool,
) -> Option<([f64; 2], Result<Certain, Unproved>)> {
    let mut vertex = descend_nearly(lines, linear, point, NEARLY)?;
    let mut is_last = false;
    for _ in 0..TURNS {
        let found = lines.meet(vertex[0], vertex[1]);
        match Certain::at(levels, p, vertex) {
            Err(Unproved::Falls(line)) => vertex = descend_along(lines, linear, found, line)?,
            Ok(certain) if !is_last && !certain.is_vertex() && !is_enough(&certain) => {
                is_last = true;
                let Some(next) = descend_nearly(lines, linear, found, 0.0) else { return Some((found, Ok(certain))) };
                vertex = next;
            }
            result => return Some((found, result)),
        }
    }
    Some((point, Err(Unproved::Doubt)))
}

impl<T: Tally> Settling<'_, '_, T> {
    /// The optimum, seen from a sample of all generators.
    pub(crate) fn of_sample(&mut self, sample: &Sample) -> Result<Certain, Unsettled> {
        let (n, len) = (self.query.len(), sample.vectors.len());
        let lines = self.chart.lines(sample.vectors.iter().copied());
        let aim = Aim { longest: sample.longest, ..careful(aim(len, n, SAMPLE_DEVIATIONS)) };
        // generators that were made longer stand for the others already
        let share = if sample.longest < f64::INFINITY { 1.0 } else { len as f64 / n as f64 };
        self.narrow(Part { lines, share, linear: [0.0; 2], aim }, None)
    }

    /// The optimum of the last level.
    fn solve(&mut self, point: [f64; 2]) -> Result<Certain, Unsettled> {
        let depth = self.levels.len();
        let level = self.levels.last().ok_or(Unsettled::Doubt)?;
        let (lines, linear) = (level.lines(self.chart), level.linear(self.chart));
        if lines.len() > DIRECT {
            let share = (lines.len() / LEAST).min(lines.len().isqrt() / 5);
            let aim = careful(aim(lines.len() / share, lines.len(), SAMPLE_DEVIATIONS));
            let part = Part {
                lines: lines.part(share),
                share: 1.0 / share as f64,
                linear: linear.map(|c| c / share as f64),
                aim,
            };
            match self.narrow(part, Some(point)) {
                Err(Unsettled::Outside(place, _)) if place >= depth => {}
                result => return result,
            }
        }
        self.tally.add(Operation::GeneratorRead, lines.len() as u64);
        match descend_and_prove(&self.levels, &lines, linear, self.p, point, self.is_enough) {
            Some((_, Ok(certain))) => Ok(certain),
            Some((found, Err(Unproved::Astray(place)))) => Err(Unsettled::Outside(place, Some(found))),
            Some((_, Err(_))) => Err(Unsettled::Doubt),
            None => Err(Unsettled::Outside(depth - 1, None)),
        }
    }

    /// The optimum of the last level, or of all generators, seen from some of its lines.
    fn narrow(&mut self, mut part: Part, start: Option<[f64; 2]>) -> Result<Certain, Unsettled> {
        let depth = self.levels.len();
        let outside = Err(Unsettled::Outside(depth, None));
        let mut found = None;
        let mut before = None;
        let mut point = start.or_else(|| part.lines.least_squares().map(|(point, _)| point)).unwrap_or_default();
        for round in 0..ROUNDS {
            let Some(vertex) = part.lines.optimum(part.linear, point) else { return outside };
            point = found.take().filter(|found| part.is_likely(*found, vertex)).unwrap_or(vertex);
            let is_last = round + 1 == ROUNDS && depth == 0;
            if is_last {
                self.tally.add(Operation::GeneratorRead, self.query.len() as u64);
                let all = self.chart.lines(self.query.generators().copied().collect::<Vec<_>>().into_iter());
                point = all.optimum([0.0; 2], point).unwrap_or(point);
            }
            let cell = match part.lines.guess_at(point, before, part.aim) {
                Some(guess) => self.chart.cell(&guess, if is_last { 0.0 } else { 1.0 }),
                None => {
                    let center = self.chart.point(point);
                    let ball = PARALLEL * center.iter().fold(0.0f64, |m, c| m.max(c.abs()));
                    Cell { center, axes: None, ball }
                }
            };
            self.tally.add(Operation::SearchStep, 1);
            let (reduced, len) = match self.levels.last() {
                Some(level) => (level.split(cell), level.vectors.len()),
                None => {
                    let n = self.query.len();
                    self.tally.add(Operation::GeneratorRead, n as u64);
                    (Reduced::of_query(self.query, cell, n / 16 + 64), n)
                }
            };
            if !is_moderate(&reduced) {
                return Err(Unsettled::Doubt);
            }
            let (all, own) = (reduced.gradient(self.chart, point), part.lines.gradient(point));
            part.linear = [0, 1].map(|k| part.share * all[k] - own[k]);
            before = Some(point);
            let most = DIRECT.max(len / 4);
            if reduced.vectors.len() > most && (round + 1 < ROUNDS || 4 * reduced.vectors.len() > 3 * len) {
                continue;
            }
            self.levels.push(reduced);
            match self.solve(point) {
                Err(Unsettled::Outside(place, vertex)) if place >= depth => {
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
    use crate::lad::of_generators::certify::unit_gauge_bound::thickness;
    use crate::numeric::bounded::exact;
    use rand::{RngExt, SeedableRng};
    use rand_pcg::Pcg64Mcg;

    /// Generators of four kinds: even, nine in ten nearly in a plane, of lengths from 1 to thousands, in seven directions but for noise.
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
                    let (chart, sample) = (Chart::new(p), Sample::of(&query, &mut ()));
                    let (p, is_enough) = (exact(p), |_: &Certain| true);
                    let tally = &mut ();
                    let mut settling = Settling {
                        query: &query,
                        chart: &chart,
                        p: &p,
                        is_enough: &is_enough,
                        levels: Vec::new(),
                        tally,
                    };
                    if let Ok(certain) = settling.of_sample(&sample) {
                        assert!(certain.missing <= 1e-9 * certain.reach.value);
                        found += usize::from(certain.slack(thickness(&query, 1)) < 1e-9);
                    }
                }
                assert!(found >= 9, "kind {kind}, {n} generators: {found} of 10");
            }
        }
    }
}
