//! The optimum in a few passes over the generators: a sample, a cell around its optimum, and what crosses the cell.

use crate::lad::of_generators::cells::nested::Trail;
use crate::lad::of_generators::cells::reduced::Reduced;
use crate::lad::of_generators::certify::rounded_optimum::{Certain, Unproved};
use crate::lad::of_generators::guess::corrected_sample::{Settling, Unsettled, descend_and_prove};
use crate::lad::of_generators::guess::huber_newton::{Aim, Guess};
use crate::lad::of_generators::guess::parallel_classes::Bundles;
use crate::lad::of_generators::guess::sample::Sample;
use crate::lad::of_generators::plane::rounded_chart::Chart;
use crate::lad::of_generators::plane::rounded_lines::Lines;
use crate::lad::of_generators::support::separates;
use crate::numeric::bounded::{Bounded, BoundedVector};
use crate::numeric::exact_sum::exact_sum;
use crate::numeric::tolerance::UNIT;
use crate::tally::{Operation, Tally};
use crate::zonotope::passes::bounded_sum;
use crate::zonotope::query::Query;

/// At most this many generators are all kept.
const SMALL: usize = 128;

/// At most this many lines are searched without a smaller cell.
const FEW: usize = 40;

/// A point whose gauge exceeds 1 by less than about this, in the sample, is solved for at once.
const CLEAR: f64 = 0.02;

/// The most meetings of bundles.
const MEETINGS: usize = 5;

/// More lines are not searched by descent around a first guess.
const MANY: usize = 1200;

/// How many cells are tried around optima of samples.
const ROUNDS: usize = 2;

/// The cell around an optimum that seemed to be outside its cell, in terms of that cell.
const AROUND: f64 = 8.0;

/// An optimum that seems to be farther from its cell, in terms of it, is none.
const FAR: f64 = 64.0;

/// How much wider a cell is taken that few lines cross and not the right ones.
const WIDER: f64 = 8.0;

/// The cell of a sample in standard deviations, that of a band in the same sense.
pub(crate) const SAMPLE_DEVIATIONS: f64 = 2.7;
const BAND_DEVIATIONS: f64 = 3.0;

/// Lines in the thinnest band.
const THICKNESS: f64 = 10.0;
const SHARE: f64 = 0.16;

/// Magnitudes between which nothing overflows and underflow is below every bound's floor.
const LARGEST: f64 = f64::from_bits((1023 + 200) << 52);
const SMALLEST: f64 = f64::from_bits((1023 - 200) << 52);

/// How the search ends.
#[derive(Debug)]
pub(crate) enum Found {
    /// The optimum, proved in doubles, and the cells on the way to it.
    Certain(Box<Certain>, Trail),
    /// A direction that separates, certainly.
    Separated([f64; 3]),
    /// The cells on the way to a problem with few generators left to be solved exactly; no cell, no progress.
    Narrowed(Trail),
}

/// Why an optimum is not found in a cell.
#[derive(Debug)]
enum Missed {
    /// It seems to be elsewhere.
    At(Guess),
    /// Nothing is known of where it is.
    Lost,
}

/// `to` − `from` as doubles.
pub(crate) fn rounded_displacement(query: &Query<'_, 3>) -> BoundedVector {
    let (from, to) = (query.from(), query.to());
    [0, 1, 2].map(|i| {
        let (value, rest) = exact_sum(to[i], -from[i]);
        Bounded { value, error: if rest == 0.0 { 0.0 } else { UNIT * value.abs() } }
    })
}

/// Searches the optimum for a displacement that is not zero, or, if that is enough, a separating direction.
pub(crate) fn search(
    query: &Query<'_, 3>,
    p: &BoundedVector,
    until_separated: bool,
    is_enough: &dyn Fn(&Certain) -> bool,
    tally: &mut impl Tally,
) -> Found {
    let rounded = p.map(|c| c.value);
    let size = rounded.iter().fold(0.0f64, |m, c| m.max(c.abs()));
    if !(SMALLEST..LARGEST).contains(&size) {
        return Found::Narrowed(Trail::default());
    }
    let chart = Chart::new(rounded);
    if query.len() <= SMALL {
        tally.add(Operation::GeneratorRead, query.len() as u64);
        let found = finish(Reduced::whole(query), &chart, p, None, MANY, is_enough);
        return found.unwrap_or_else(|_| Found::Narrowed(Trail::default()));
    }
    let sample = Sample::of(query, tally);
    let part = sample.vectors.len() as f64 / query.len() as f64;
    if sample.longest == f64::INFINITY
        && let Some(bundles) = Bundles::of(&sample.vectors, part, &chart)
    {
        let found = search_bundles(query, p, until_separated, &chart, bundles, is_enough, tally);
        return found.unwrap_or_else(|| settle(query, p, &chart, &sample, is_enough, tally));
    }
    let Some(mut guess) = sample_guess(&sample, query.len(), &chart) else {
        return settle(query, p, &chart, &sample, is_enough, tally);
    };
    if until_separated {
        let direction = chart.point(guess.point);
        // one pass: not where the sample says that it would be for nothing
        if sample.longest < f64::INFINITY || bounded_sum(&sample.vectors, &direction).value < part * (1.0 - CLEAR) {
            tally.add(Operation::GeneratorRead, query.len() as u64);
            if separates(query, p, &direction) {
                return Found::Separated(direction);
            }
        }
    }
    let mut stretch = 1.0;
    for _ in 0..ROUNDS {
        tally.add(Operation::SearchStep, 1);
        tally.add(Operation::GeneratorRead, query.len() as u64);
        let reduced = Reduced::of_query(query, chart.cell(&guess, stretch), query.len() / 16 + 64);
        if !is_moderate(&reduced) {
            return Found::Narrowed(Trail::default());
        }
        let crossing = reduced.vectors.len();
        match finish(reduced, &chart, p, Some(&guess), MANY, is_enough) {
            Ok(found) => return found,
            Err(Missed::At(nearer)) => (guess, stretch) = (nearer, AROUND),
            // of one bundle, perhaps, or none at all
            Err(Missed::Lost) if crossing < SMALL => stretch *= WIDER,
            Err(Missed::Lost) => break,
        }
    }
    settle(query, p, &chart, &sample, is_enough, tally)
}

/// The optimum where a first guess did not help.
fn settle(
    query: &Query<'_, 3>,
    p: &BoundedVector,
    chart: &Chart,
    sample: &Sample,
    is_enough: &dyn Fn(&Certain) -> bool,
    tally: &mut impl Tally,
) -> Found {
    let mut settling = Settling { query, chart, p, is_enough, levels: Vec::new(), tally };
    match settling.of_sample(sample) {
        Ok(certain) => Found::Certain(Box::new(certain), trail(settling.levels)),
        Err(Unsettled::Doubt) => Found::Narrowed(trail(settling.levels)),
        Err(Unsettled::Outside(..)) => Found::Narrowed(Trail::default()),
    }
}

/// Solves a reduced problem, or says what is known of its optimum.
///
/// Smaller and smaller cells leave fewer and fewer lines. Where the vertex found seems to be outside the last cell, the lines of
/// the one before it are searched, if they are not too `many`.
fn finish(
    reduced: Reduced,
    chart: &Chart,
    p: &BoundedVector,
    start: Option<&Guess>,
    many: usize,
    is_enough: &dyn Fn(&Certain) -> bool,
) -> Result<Found, Missed> {
    let mut levels = vec![reduced];
    let mut guess = start.copied();
    let mut lines = levels[0].lines(chart);
    while lines.len() > FEW {
        let last = levels.last().expect("there is always the first");
        let aim = aim(lines.len(), lines.len(), BAND_DEVIATIONS);
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
    let mut is_found = false;
    if lines.len() > many {
        return Err(Missed::Lost);
    }
    loop {
        let level = levels.last().expect("the first problem is never taken away");
        let linear = level.linear(chart);
        let doubt = match descend_and_prove(&levels, &lines, linear, p, point, is_enough) {
            Some((_, Ok(certain))) => return Ok(Found::Certain(Box::new(certain), trail(levels))),
            Some((found, Err(Unproved::Astray(_)))) => {
                // lines of one bundle meet far away: where the search started is better
                if guess.is_none_or(|guess| guess.is_near(found, FAR)) {
                    (point, is_found) = (found, true);
                }
                false
            }
            Some(_) => true,
            None => false,
        };
        if doubt {
            return Ok(Found::Narrowed(trail(levels)));
        }
        let wider = levels.len().checked_sub(2).map_or(0, |place| levels[place].vectors.len());
        if !(1..=many).contains(&wider) {
            let at = |guess| Missed::At(Guess { point, ..guess });
            return Err(if is_found { guess.map_or(Missed::Lost, at) } else { Missed::Lost });
        }
        levels.pop();
        lines = levels[levels.len() - 1].lines(chart);
    }
}

/// Whether nothing overflowed, or will.
pub(crate) fn is_moderate(reduced: &Reduced) -> bool {
    // false for NaN as well
    reduced.fixed.magnitude <= LARGEST
}

/// What the guess from some lines is to allow for.
pub(crate) fn aim(len: usize, population: usize, deviations: f64) -> Aim {
    let thinnest = THICKNESS.max((len as f64).sqrt());
    let thickness = thinnest.max(SHARE * len as f64);
    Aim { thickness, thinnest, population, longest: f64::INFINITY, deviations }
}

/// The same with a band as thin as can be: where generators are uneven, a wide band hides what is in it.
pub(crate) fn careful(aim: Aim) -> Aim {
    Aim { thickness: aim.thinnest, ..aim }
}

/// The cells of problems that were reduced one from the other.
fn trail(levels: Vec<Reduced>) -> Trail {
    Trail::new(levels.into_iter().filter_map(|level| Some((level.cell?, level.indices))).collect())
}

/// The optimum of a sample, with a thin band if lengths are uneven.
fn sample_guess(sample: &Sample, population: usize, chart: &Chart) -> Option<Guess> {
    let lines = chart.lines(sample.vectors.iter().copied());
    let aim = Aim { longest: sample.longest, ..aim(lines.len(), population, SAMPLE_DEVIATIONS) };
    lines.guess([0.0; 2], None, if sample.longest < f64::INFINITY { careful(aim) } else { aim })
}

/// The optimum where two of few bundles of parallel generators meet; none if it is not found there.
fn search_bundles(
    query: &Query<'_, 3>,
    p: &BoundedVector,
    until_separated: bool,
    chart: &Chart,
    mut bundles: Bundles,
    is_enough: &dyn Fn(&Certain) -> bool,
    tally: &mut impl Tally,
) -> Option<Found> {
    let mut before = None;
    for round in 0..MEETINGS {
        let meeting = bundles.meeting(chart)?;
        if until_separated && round == 0 {
            tally.add(Operation::GeneratorRead, query.len() as u64);
            let direction = chart.point(meeting.guess.point);
            if separates(query, p, &direction) {
                return Some(Found::Separated(direction));
            }
        }
        tally.add(Operation::SearchStep, 1);
        tally.add(Operation::GeneratorRead, query.len() as u64);
        let reduced = Reduced::of_query(query, chart.cell(&meeting.guess, 1.0), query.len() / 8 + 64);
        if !is_moderate(&reduced) {
            return None;
        }
        let is_corrected = bundles.is_corrected(&meeting, &reduced, chart);
        if !is_corrected || before.replace(meeting.guess.point) == Some(meeting.guess.point) {
            let levels = [reduced];
            let vertex = bundles.vertex(&meeting, &levels[0]);
            let certain = vertex.and_then(|vertex| Certain::at(&levels, p, vertex).ok());
            let [reduced] = levels;
            return match certain {
                Some(certain) => Some(Found::Certain(Box::new(certain), trail(vec![reduced]))),
                None => finish(reduced, chart, p, Some(&meeting.guess), usize::MAX, is_enough).ok(),
            };
        }
    }
    None
}
