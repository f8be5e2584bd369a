//! The optimum in a few passes over the generators: a sample, a cell around its optimum, and what crosses the cell.

use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;

use super::cell::Cell;
use super::chart::Chart;
use super::reduced::{End, Reduced};
use super::smooth::{Aim, Columns, Guess};
use super::support::support;
use crate::collision::Displacement;
use crate::numeric::bounded::{self, Bounded, BoundedVector};
use crate::numeric::exact_sum::exact_sum;
use crate::numeric::tolerance::UNIT;
use crate::tally::{Operation, Tally};

/// At most this many generators are all kept.
const SMALL: usize = 128;

/// At most this many lines are searched without a smaller cell.
const FEW: usize = 40;

/// At most this many lines are solved exactly rather than fewer.
const FEW_EXACTLY: usize = 300;

/// How many cells are tried around optima of samples.
const ROUNDS: usize = 3;

/// The cell of a sample in standard deviations, that of a band in the same sense.
const SAMPLE_DEVIATIONS: f64 = 2.7;
const BAND_DEVIATIONS: f64 = 3.0;

/// Lines in the thinnest band.
const THICKNESS: f64 = 10.0;

/// Magnitudes between which nothing overflows and underflow is below every bound's floor.
const LARGEST: f64 = f64::from_bits((1023 + 200) << 52);
const SMALLEST: f64 = f64::from_bits((1023 - 200) << 52);

/// The seed of the sample: it decides the time, never the answer.
const SEED: u64 = 0x7a;

/// How the search ends.
#[derive(Debug)]
pub(super) enum Found {
    /// The optimum, proved in doubles; the cell whose centre gives the signs that were not looked at.
    Certain(Box<super::certain::Certain>, Option<Cell>),
    /// A direction that separates, certainly.
    Separated([f64; 3]),
    /// A problem with few generators left to be solved exactly.
    Reduced(Reduced),
    /// Nothing.
    Nothing,
}

/// `to` − `from` as doubles.
pub(super) fn rounded_displacement(question: &Displacement<'_, 3>) -> BoundedVector {
    let (from, to) = (question.from(), question.to());
    [0, 1, 2].map(|i| {
        let (value, rest) = exact_sum(to[i], -from[i]);
        Bounded { value, error: if rest == 0.0 { 0.0 } else { UNIT * value.abs() } }
    })
}

/// Searches the optimum for a displacement that is not zero, or, if that is enough, a separating direction.
pub(super) fn search(
    question: &Displacement<'_, 3>,
    p: &BoundedVector,
    until_separated: bool,
    tally: &mut impl Tally,
) -> Found {
    let rounded = p.map(|c| c.value);
    let size = rounded.iter().fold(0.0f64, |m, c| m.max(c.abs()));
    if !(SMALLEST..LARGEST).contains(&size) {
        return Found::Nothing;
    }
    let chart = Chart::new(rounded);
    if question.len() <= SMALL {
        tally.add(Operation::GeneratorRead, question.len() as u64);
        return finish(Reduced::whole(question), &chart, p, None).unwrap_or(Found::Nothing);
    }
    let Some(mut guess) = sample_guess(question, &chart, tally) else { return Found::Nothing };
    if until_separated {
        tally.add(Operation::GeneratorRead, question.len() as u64);
        let direction = chart.point(guess.point);
        if certainly_separates(question, p, direction) {
            return Found::Separated(direction);
        }
    }
    for round in 0..ROUNDS {
        tally.add(Operation::SearchStep, 1);
        tally.add(Operation::GeneratorRead, question.len() as u64);
        let cell = chart.cell(&guess, f64::from(1 << round));
        let reduced = Reduced::of_question(question, cell);
        if reduced.fixed.magnitude.is_nan() || reduced.fixed.magnitude > LARGEST {
            return Found::Nothing;
        }
        match finish(reduced, &chart, p, Some(&guess)) {
            Ok(found) => return found,
            Err(point) => guess.point = point,
        }
    }
    Found::Nothing
}

/// Solves a reduced problem, or says where its optimum seems to be instead.
///
/// Smaller and smaller cells leave fewer and fewer lines. Where the vertex found seems to be outside the last cell, the lines of
/// the one before it are searched.
fn finish(reduced: Reduced, chart: &Chart, p: &BoundedVector, start: Option<&Guess>) -> Result<Found, [f64; 2]> {
    let mut levels = vec![reduced];
    let mut guess = start.copied();
    let mut columns = levels[0].columns(chart);
    while columns.len() > FEW {
        let last = levels.last().expect("there is always the first");
        let thickness = THICKNESS.max(columns.len().isqrt() as f64);
        let aim = Aim { thickness, population: columns.len(), deviations: BAND_DEVIATIONS };
        let Some(next) = columns.guess(last.linear(chart), guess.as_ref(), aim) else { break };
        guess = Some(next);
        let few = last.split(chart.cell(&next, 1.0));
        if 4 * few.vectors.len() > 3 * last.vectors.len() {
            break;
        }
        columns = few.columns(chart);
        levels.push(few);
    }
    let least_squares = |columns: &Columns| columns.least_squares().map_or([0.0; 2], |(point, _)| point);
    let mut point = guess.map_or_else(|| least_squares(&columns), |guess| guess.point);
    let cell = levels[0].cells.first().copied();
    while let Some(level) = levels.pop() {
        match level.solve(&columns, chart, p, point) {
            End::Certain(certain) => return Ok(Found::Certain(certain, cell)),
            End::Doubt => {
                // the widest problem that is still small for exact arithmetic has the surest cell
                let wider = levels.into_iter().find(|wider| wider.vectors.len() <= FEW_EXACTLY);
                return Ok(exactly(wider.unwrap_or(level)));
            }
            End::Astray(vertex) => point = vertex,
        }
        if let Some(wider) = levels.last() {
            columns = wider.columns(chart);
        }
    }
    Err(point)
}

/// What exact arithmetic has to solve: the reduced problem, unless nothing is gained by it.
fn exactly(reduced: Reduced) -> Found {
    if reduced.cells.is_empty() { Found::Nothing } else { Found::Reduced(reduced) }
}

/// The optimum of a sample: one generator from each of many equal stretches.
fn sample_guess(question: &Displacement<'_, 3>, chart: &Chart, tally: &mut impl Tally) -> Option<Guess> {
    let n = question.len();
    let size = (6 * n.isqrt() + n / 128).min(n);
    tally.add(Operation::GeneratorRead, size as u64);
    let mut random = Pcg64Mcg::seed_from_u64(SEED);
    let picks = (0..size).map(|i| {
        let (start, end) = (i * n / size, (i + 1) * n / size);
        start + ((u64::from(random.random::<u32>()) * (end - start) as u64) >> 32) as usize
    });
    let columns = Columns::collect(picks.map(|pick| chart.weighted_line(&question.generator(pick))));
    let thickness = THICKNESS.max((size.isqrt()) as f64);
    columns.guess([0.0; 2], None, Aim { thickness, population: n, deviations: SAMPLE_DEVIATIONS })
}

/// Whether u · p > h(u), proved by one pass in doubles.
fn certainly_separates(question: &Displacement<'_, 3>, p: &BoundedVector, u: [f64; 3]) -> bool {
    let [first, second] = question.runs();
    let reach = support(first, &u) + support(second, &u);
    (bounded::dot(p, &bounded::exact(u)) - reach).is_positive()
}
