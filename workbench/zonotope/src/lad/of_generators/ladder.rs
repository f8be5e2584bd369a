//! The ladder: which method answers a query, and which one is tried where it does not. The only file with fallbacks.
//!
//! Each rung is exact where it answers; where it does not, the ladder goes on with the rung that the table names.
//! Doubles come first because they nearly always suffice. Where they do not, the cells that they have found, which
//! probably hold the optimum, make the problem of the exact rungs small.
//!
//! | rung | tried | where it has no answer |
//! |---|---|---|
//! | `ZeroDisplacement` | always | the next one |
//! | `BestPair` | at most [`PAIRS_LIMIT`] generators | `AllInDoubles` |
//! | `AllInDoubles` | at most [`WHOLE_LIMIT`] generators | `FlatBody` |
//! | `ParallelClasses` | more, of few directions as far as a sample shows | `CorrectedSample` |
//! | `SeparatingGuess` | a sample has a smooth optimum, and the location is all that is asked | `SampledCell` |
//! | `SampledCell` | a sample has a smooth optimum, or the query a likely cell | `WiderCell` near the optimum, or as below |
//! | `WiderCell` | once | `CorrectedSample`; `ParallelClasses` where no sample was drawn |
//! | `CorrectedSample` | where guesses fail | `FlatBody` |
//! | `FlatBody` | doubles leave a doubt and all generators lie in a plane with the displacement | the next one |
//! | `CuttingPlanes` | more than [`WHOLE_LIMIT`] generators of which doubles leave a doubt | `ExactVertex` |
//! | `ExactVertex` | a search in doubles proved too little of its last vertex, or found none | `ExactInCells` |
//! | `ExactInCells` | cells are known | `LongestFirst` |
//! | `LongestFirst` | at least [`super::exact::longest_first::LEAST_COUNT`] generators | `ExactWhole` |
//! | `ExactWhole` | | always answers |
//!
//! A caller may see the vertices that a rung finds ([`AtVertex`]) and end the search there; then no optimum is the
//! answer.
//!
//! Displacements of a size outside [`MODERATE_SIZES`], for which products of doubles leave their range, begin at
//! `FlatBody`.

use super::cells::nested::NestedCells;
use super::cells::reduced::{Reduced, USUAL_LEVELS};
use super::certify::rounded_optimum::{DecidedOptimum, RoundedOptimum};
use super::exact::longest_first;
use super::exact::solve::ExactOptimum;
use super::goal::{AtVertex, Goal};
use super::guess::aim::Aim;
use super::guess::parallel_classes::ParallelClasses;
use super::guess::sample::Sample;
use super::optimum::{FlatOptimum, Optimum};
use super::plane::in_doubles::Guess;
use super::problem::Problem;
use super::seam::kernel_query::KernelQuery;
use super::search::Searched;
use super::search::best_pair::{PAIRS_LIMIT, best_pair};
use super::search::class_meetings::{ClassesFound, search_meetings};
use super::search::corrected_sample::{CorrectedSample, NotCertified};
use super::search::cutting_planes::cutting_planes;
use super::search::narrowing::{DESCENT_LINES, Missed, narrow, search_cell};
use super::span::flat::spare_axis;
use super::span::prism::Prism;
use crate::numeric::exact_linear::ExactVector;
use crate::numeric::lanes::bounded_sum;
use crate::numeric::lanes::rows::Rows;
use crate::numeric::reused::{Reused, ReusedBox};
use crate::numeric::tolerance::MODERATE_SIZES;
use crate::tally::{Operation, Rung, Tally};

/// At most this many generators are searched all at once, without a sample: as many as the descent takes.
pub(crate) const WHOLE_LIMIT: usize = DESCENT_LINES;

/// The vertex descent at the end of a search is given at most this many lines.
const CELL_LINES_LIMIT: usize = 1200;

/// The vertex descent at the end of the last search in doubles is given at most this many lines.
const LAST_LINES_LIMIT: usize = 4096;

/// A direction is tried as a separating one where the gauge of the sample exceeds 1 by more than this times the
/// standard error of a sampled sum, which is nearly that sum over the root of the sample's size.
const CLEAR_DEVIATIONS: f64 = 1.0;

/// Generators whose images in doubles may be farther off than this part of their length are left to exact arithmetic.
const GENERATOR_ERROR_LIMIT: f64 = 1e-9;

/// The size of the second cell in terms of the first where the optimum seemed to be outside of the first cell.
const STRETCH_AROUND: f64 = 8.0;

/// A cell that fewer lines cross, those of the optimum not among them, was too small.
const CROSSING_OF_EMPTY: usize = 128;

/// The size of the second cell in terms of the first where few lines crossed the first cell, and the lines of the
/// optimum were not among them.
const STRETCH_OF_EMPTY: f64 = 8.0;

/// The optimum of a query, and the rung that answered.
///
/// A displacement that doubles round to zero is not zero unless its error is zero, too.
pub(crate) fn climb(
    query: &dyn KernelQuery,
    goal: Goal,
    at_vertex: Option<AtVertex<'_>>,
    vertex: Option<[usize; 2]>,
    tally: &mut dyn Tally,
) -> (Optimum, Rung) {
    let p = query.rounded_displacement();
    if p.iter().all(|c| c.value == 0.0 && c.error == 0.0) {
        return (Optimum::Center, Rung::ZeroDisplacement);
    }
    let problem = Problem { vertex, at_vertex, ..Problem::new(query, p, goal) };
    let mut climb = Climb { problem: &problem, tally, sample: None, guess: None, known: Known::default() };
    let size = p.iter().fold(0.0f64, |m, c| m.max(c.value.abs()));
    // where the generators are known to few digits, doubles have nothing to say of them
    let is_known = MODERATE_SIZES.contains(&size) && query.relative_error() < GENERATOR_ERROR_LIMIT;
    let mut rung = match query.len() {
        _ if !is_known => Rung::FlatBody,
        n if n <= PAIRS_LIMIT => Rung::BestPair,
        n if n <= WHOLE_LIMIT => Rung::AllInDoubles,
        _ => climb.first_of_many(),
    };
    loop {
        let attempt = match rung {
            Rung::BestPair => climb.best_pair(),
            Rung::AllInDoubles => climb.all_in_doubles(),
            Rung::ParallelClasses => climb.parallel_classes(),
            Rung::SeparatingGuess => climb.separating_guess(),
            Rung::SampledCell => climb.sampled_cell(),
            Rung::WiderCell => climb.wider_cell(),
            Rung::CuttingPlanes => climb.cutting_planes(),
            Rung::CorrectedSample => climb.corrected_sample(),
            Rung::ExactVertex => climb.exact_vertex(),
            Rung::FlatBody => climb.flat_body(),
            _ => {
                let (optimum, rung) = exact_near(query, &query.exact(), &climb.known.cells, climb.tally);
                return (Optimum::Exact(Box::new(optimum)), rung);
            }
        };
        match attempt {
            Ok(optimum) => return (optimum, rung),
            Err(next) => rung = next,
        }
    }
}

/// The exact optimum after a search that ended at a vertex; `None` where it is not found near that vertex.
fn exact_at(
    query: &dyn KernelQuery,
    p: &ExactVector,
    vertex: &Vertex,
    cells: &NestedCells,
    tally: &mut dyn Tally,
) -> Option<ExactOptimum> {
    match vertex {
        Vertex::Found(optimum) => exact_at_found(query, p, optimum, cells, tally),
        Vertex::Likely(basis) => ExactOptimum::from_likely_vertex(query, p, *basis, cells, tally),
    }
}

fn exact_at_found(
    query: &dyn KernelQuery,
    p: &ExactVector,
    optimum: &RoundedOptimum,
    cells: &NestedCells,
    tally: &mut dyn Tally,
) -> Option<ExactOptimum> {
    if optimum.is_vertex() {
        return Some(ExactOptimum::at_vertex(query, p, optimum, cells));
    }
    ExactOptimum::from_likely_vertex(query, p, optimum.basis, cells, tally)
}

/// The exact optimum where one that was decided in doubles leaves no room for a proof in doubles.
pub(crate) fn exact_of(
    query: &dyn KernelQuery,
    p: &ExactVector,
    decided: &DecidedOptimum,
    tally: &mut dyn Tally,
) -> ExactOptimum {
    exact_at_found(query, p, &decided.optimum, &decided.cells, tally)
        .unwrap_or_else(|| exact_near(query, p, &decided.cells, tally).0)
}

/// The exact optimum after a search that left cells, and the rung that answered: the second half of the ladder.
fn exact_near(
    query: &dyn KernelQuery,
    p: &ExactVector,
    cells: &NestedCells,
    tally: &mut dyn Tally,
) -> (ExactOptimum, Rung) {
    if let Some(optimum) = ExactOptimum::in_cells(query, p, cells, tally) {
        return (optimum, Rung::ExactInCells);
    }
    tally.add(Operation::ExactFallback, 1);
    match longest_first::optimum(query, p, tally) {
        Ok(optimum) => (optimum, Rung::LongestFirst),
        Err(center) => (ExactOptimum::of_whole(query, p, center, tally), Rung::ExactWhole),
    }
}

/// A query on its way up the ladder, with what the rungs below found out.
struct Climb<'a, 'q> {
    problem: &'a Problem<'q>,
    tally: &'a mut dyn Tally,
    sample: Option<Sample>,
    /// The guess around which the next cell is taken, and the factor by which the cell is larger than the guess says.
    guess: Option<(Guess, f64)>,
    known: Known,
}

/// The remainder that searches in doubles leave for the exact rungs.
#[derive(Default)]
struct Known {
    /// Cells that probably hold the optimum.
    cells: NestedCells,
    /// A vertex at which a search ended.
    vertex: Option<Vertex>,
}

/// A vertex at which a search in doubles ended.
enum Vertex {
    /// One that is the optimum or near it, whose gauge doubles cannot tell from 1.
    Found(ReusedBox<RoundedOptimum>),
    /// The generators of one of which doubles prove nothing.
    Likely([usize; 2]),
}

/// The answer of a rung, or the rung to go on with.
type Attempt = Result<Optimum, Rung>;

impl Climb<'_, '_> {
    /// The first rung of many generators: a cell that the query itself finds likely needs no sample.
    fn first_of_many(&mut self) -> Rung {
        match self.problem.query.likely_cell(self.tally) {
            Some(cell) => {
                self.guess = Some((self.problem.chart.guess_of(&cell), 1.0));
                Rung::SampledCell
            }
            None => Rung::ParallelClasses,
        }
    }

    /// The rung after cells that do not hold the optimum.
    fn after_cells(&self) -> Rung {
        if self.sample.is_some() { Rung::CorrectedSample } else { Rung::ParallelClasses }
    }

    fn best_pair(&mut self) -> Attempt {
        best_pair(self.problem, self.tally).map_or(Err(Rung::AllInDoubles), |searched| self.decide(searched))
    }

    fn all_in_doubles(&mut self) -> Attempt {
        let query = self.problem.query;
        self.tally.add(Operation::GeneratorRead, query.len() as u64);
        match narrow(self.problem, Reduced::whole(query), None, CELL_LINES_LIMIT) {
            Ok(searched) => self.decide(searched),
            Err(_) => Err(Rung::FlatBody),
        }
    }

    fn parallel_classes(&mut self) -> Attempt {
        let (query, chart) = (self.problem.query, &self.problem.chart);
        let sample = self.sample.insert(Sample::of(query, self.tally));
        if sample.longest == f64::INFINITY
            && let Some(classes) = ParallelClasses::of(&sample.vectors, sample.part_of(query), chart)
        {
            return match search_meetings(self.problem, classes, self.tally) {
                Some(ClassesFound::Separated(direction)) => Ok(Optimum::Separated(direction)),
                Some(ClassesFound::Searched(searched)) => self.decide(searched),
                None => Err(Rung::CorrectedSample),
            };
        }
        let lines = chart.lines(&sample.vectors);
        let guess = lines.guess([0.0; 2], None, Aim::of_sample(sample, query.len()));
        self.guess = guess.map(|guess| (guess, 1.0));
        Err(match (guess, self.problem.goal) {
            (None, _) => Rung::CorrectedSample,
            (Some(_), Goal::Location) => Rung::SeparatingGuess,
            (Some(_), Goal::Gauge) => Rung::SampledCell,
        })
    }

    fn separating_guess(&mut self) -> Attempt {
        let (query, sample) = (self.problem.query, self.sample());
        let direction = self.problem.chart.point(self.guess().0.point);
        // the pass over all generators is made only where the sample says that the direction is likely to separate; a
        // sample by length says nothing of that
        let error = CLEAR_DEVIATIONS / (sample.vectors.len() as f64).sqrt();
        let is_likely = sample.longest < f64::INFINITY
            || bounded_sum(Rows::new(&sample.vectors), &direction).value < sample.part_of(query) * (1.0 - error);
        if is_likely {
            self.tally.add(Operation::GeneratorRead, query.len() as u64);
            if query.separates(&self.problem.p, &direction) {
                return Ok(Optimum::Separated(direction));
            }
        }
        Err(Rung::SampledCell)
    }

    fn sampled_cell(&mut self) -> Attempt {
        let (guess, stretch) = self.guess();
        match search_cell(self.problem, &guess, stretch, CELL_LINES_LIMIT, self.tally) {
            Ok(searched) => return self.decide(searched),
            Err(Missed::At(nearer)) => self.guess = Some((nearer, STRETCH_AROUND)),
            Err(Missed::Lost { crossing }) if crossing < CROSSING_OF_EMPTY => {
                self.guess = Some((guess, stretch * STRETCH_OF_EMPTY));
            }
            Err(Missed::Lost { .. }) => return Err(self.after_cells()),
        }
        Err(Rung::WiderCell)
    }

    fn wider_cell(&mut self) -> Attempt {
        let (guess, stretch) = self.guess();
        match search_cell(self.problem, &guess, stretch, CELL_LINES_LIMIT, self.tally) {
            Ok(searched) => self.decide(searched),
            Err(_) => Err(self.after_cells()),
        }
    }

    fn cutting_planes(&mut self) -> Attempt {
        let start = self.guess.map_or([0.0; 2], |(guess, _)| guess.point);
        let searched = cutting_planes(self.problem, start, LAST_LINES_LIMIT, self.tally);
        // the body is not flat
        searched.map_or(Err(Rung::ExactVertex), |searched| self.decide(searched)).map_err(|_| Rung::ExactVertex)
    }

    fn corrected_sample(&mut self) -> Attempt {
        let sample = self.sample.as_ref().expect("a sample was taken by the rung of parallel classes");
        let (problem, tally) = (self.problem, &mut *self.tally);
        let mut search = CorrectedSample { problem, levels: Reused::with_capacity(USUAL_LEVELS), vertex: None, tally };
        let found = search.of_sample(sample);
        let CorrectedSample { levels, vertex, .. } = search;
        let searched = match found {
            Ok(optimum) => Searched::Certified(optimum, NestedCells::of(levels)),
            Err(NotCertified::Doubt) => Searched::Doubtful { cells: NestedCells::of(levels), vertex },
            Err(NotCertified::Outside(..)) => Searched::Doubtful { cells: NestedCells::default(), vertex },
        };
        self.decide(searched)
    }

    fn exact_vertex(&mut self) -> Attempt {
        let query = self.problem.query;
        let found = match &self.known.vertex {
            Some(vertex) => exact_at(query, &query.exact(), vertex, &self.known.cells, self.tally),
            None if self.sample.is_some() => ExactOptimum::from_line_of_longest(query, &query.exact(), self.tally),
            None => None,
        };
        found.map_or(Err(Rung::ExactInCells), |optimum| Ok(Optimum::Exact(Box::new(optimum))))
    }

    fn flat_body(&mut self) -> Attempt {
        let Problem { query, goal, at_vertex, .. } = *self.problem;
        // of few generators, or of sizes that are not moderate, planes tell no more than the search before
        let next = if self.sample.is_some() { Rung::CuttingPlanes } else { Rung::ExactVertex };
        let rows = query.in_doubles().ok_or(next)?;
        let query = rows.query();
        let axis = spare_axis(&query, &query.exact()).ok_or(next)?;
        let prism = Prism::without(axis, &query);
        let (optimum, _) = climb(&prism.query(), goal, at_vertex, None, self.tally);
        Ok(Optimum::Flat(Box::new(FlatOptimum { axis, prism, optimum })))
    }

    /// The answer of a search in doubles, or the rung that takes over what the search found out.
    fn decide(&mut self, searched: Searched) -> Attempt {
        let (optimum, cells) = match searched {
            Searched::Doubtful { cells, vertex } => {
                if vertex.is_some_and(|vertex| self.ends_at(vertex)) {
                    return Ok(Optimum::Ended);
                }
                self.known = Known { cells, vertex: vertex.map(Vertex::Likely) };
                return Err(Rung::FlatBody);
            }
            Searched::Ended => return Ok(Optimum::Ended),
            Searched::Certified(optimum, cells) => (optimum, cells),
        };
        match DecidedOptimum::new(self.problem.query, optimum, cells, self.problem.goal) {
            Ok(decided) => Ok(Optimum::Rounded(decided)),
            Err((optimum, cells)) => {
                if self.ends_at(optimum.basis) {
                    return Ok(Optimum::Ended);
                }
                self.known = Known { cells, vertex: Some(Vertex::Found(optimum)) };
                Err(Rung::ExactVertex)
            }
        }
    }

    /// Whether the caller ends the search at a vertex of which doubles certify too little, which was not seen before.
    fn ends_at(&mut self, vertex: [usize; 2]) -> bool {
        if self.problem.at_vertex.is_none() || self.problem.is_seen_first() {
            return false;
        }
        self.tally.add(Operation::GeneratorRead, self.problem.query.len() as u64);
        self.problem.ends_at(vertex)
    }

    fn sample(&self) -> &Sample {
        self.sample.as_ref().expect("a sample was taken by the rung of parallel classes")
    }

    fn guess(&self) -> (Guess, f64) {
        self.guess.expect("a guess leads to the rungs that use it")
    }
}
