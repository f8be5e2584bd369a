//! The optimum in a few passes over the generators: a sample, a cell around its optimum, and what crosses the cell.

use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;

use super::certain::{Certain, Unproved};
use super::chart::Chart;
use super::descend::{Stop, descend};
use super::lines::Lines;
use super::reduced::Reduced;
use super::smooth::{Aim, Guess};
use super::support::support;
use super::trail::Trail;
use crate::collision::Displacement;
use crate::numeric::bounded::{self, Bounded, BoundedVector};
use crate::numeric::exact_sum::exact_sum;
use crate::numeric::tolerance::UNIT;
use crate::tally::{Operation, Tally};

/// At most this many generators are all kept.
const SMALL: usize = 128;

/// At most this many lines are searched without a smaller cell.
const FEW: usize = 40;

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
    /// The optimum, proved in doubles, and the cells on the way to it.
    Certain(Box<Certain>, Trail),
    /// A direction that separates, certainly.
    Separated([f64; 3]),
    /// The cells on the way to a problem with few generators left to be solved exactly; no cell, no progress.
    Narrowed(Trail),
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
        return Found::Narrowed(Trail::default());
    }
    let chart = Chart::new(rounded);
    if question.len() <= SMALL {
        tally.add(Operation::GeneratorRead, question.len() as u64);
        let found = finish(Reduced::whole(question), &chart, p, None);
        return found.unwrap_or_else(|_| Found::Narrowed(Trail::default()));
    }
    let Some(mut guess) = sample_guess(question, &chart, tally) else { return Found::Narrowed(Trail::default()) };
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
        let reduced = Reduced::of_question(question, cell, question.len() / 16 + 64);
        if reduced.fixed.magnitude.is_nan() || reduced.fixed.magnitude > LARGEST {
            return Found::Narrowed(Trail::default());
        }
        match finish(reduced, &chart, p, Some(&guess)) {
            Ok(found) => return found,
            Err(point) => guess.point = point,
        }
    }
    Found::Narrowed(Trail::default())
}

/// Solves a reduced problem, or says where its optimum seems to be instead.
///
/// Smaller and smaller cells leave fewer and fewer lines. Where the vertex found seems to be outside the last cell, the lines of
/// the one before it are searched.
fn finish(reduced: Reduced, chart: &Chart, p: &BoundedVector, start: Option<&Guess>) -> Result<Found, [f64; 2]> {
    let mut levels = vec![reduced];
    let mut guess = start.copied();
    let mut lines = levels[0].lines(chart);
    while lines.len() > FEW {
        let last = levels.last().expect("there is always the first");
        let thickness = THICKNESS.max(lines.len().isqrt() as f64);
        let aim = Aim { thickness, population: lines.len(), deviations: BAND_DEVIATIONS };
        let Some(next) = lines.guess(last.linear(chart), guess.as_ref(), aim) else { break };
        guess = Some(next);
        let few = last.split(chart.cell(&next, 1.0));
        if 4 * few.vectors.len() > 3 * last.vectors.len() {
            break;
        }
        lines = few.lines(chart);
        levels.push(few);
    }
    let least_squares = |lines: &Lines| lines.least_squares().map_or([0.0; 2], |(point, _)| point);
    let mut point = guess.map_or_else(|| least_squares(&lines), |guess| guess.point);
    loop {
        let level = levels.last().expect("the first problem is never taken away");
        let doubt = match descend(&lines, level.linear(chart), point) {
            Ok(basis) => match Certain::at(&levels, p, basis) {
                Ok(certain) => return Ok(Found::Certain(Box::new(certain), trail(levels))),
                Err(Unproved::Doubt) => true,
                Err(Unproved::Astray) => {
                    point = lines.meet(basis[0], basis[1]);
                    false
                }
            },
            Err(stop) => stop == Stop::Undecided,
        };
        if doubt {
            return Ok(Found::Narrowed(trail(levels)));
        }
        if levels.len() == 1 {
            return Err(point);
        }
        levels.pop();
        lines = levels[levels.len() - 1].lines(chart);
    }
}

/// The cells of problems that were reduced one from the other.
fn trail(levels: Vec<Reduced>) -> Trail {
    Trail::new(levels.into_iter().filter_map(|level| Some((level.cell?, level.indices))).collect())
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
    let lines = chart.lines(picks.map(|pick| question.generator(pick)));
    let thickness = THICKNESS.max((size.isqrt()) as f64);
    lines.guess([0.0; 2], None, Aim { thickness, population: n, deviations: SAMPLE_DEVIATIONS })
}

/// Whether u · p > h(u), proved by one pass in doubles.
fn certainly_separates(question: &Displacement<'_, 3>, p: &BoundedVector, u: [f64; 3]) -> bool {
    let [first, second] = question.runs();
    let reach = support(first, &u) + support(second, &u);
    (bounded::dot(p, &bounded::exact(u)) - reach).is_positive()
}
