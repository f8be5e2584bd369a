//! The steps that all methods in floating point share, from the normals that a method begins with to a proven answer.
//!
//! The steps in the order of the code, each with the file that takes it:
//! 1. `span` finds the span of the directions exactly, and a point off it if there is one;
//! 2. `equilibrated` stretches the axes along which all directions are thin, by powers of two;
//! 3. `scaled` takes coordinates of ordinary size, and one direction for each line;
//! 4. `row_generation` guesses normals, centre and coefficients in doubles;
//! 5. `lower_bound` rounds the multipliers so that they add up to zero exactly, and computes the bound that they prove;
//! 6. `contain` finds centre and coefficients in doubles with which every point is inside, exactly;
//! 7. `refine` takes the optimum in rationals from `rational` where the bounds do not meet and the problem is small.

mod equilibrated;
mod refine;

use std::cell::Cell;

use self::equilibrated::Equilibrated;
use self::refine::refine;
use super::answer::{DirectedZonotope, Enclosure, OffSpan};
use super::contain::contain;
use super::contain::flat_center::{cheapest_center, nearest_doubles};
use super::lower_bound::proven_bound;
use super::problem::{FixedDirections, FixedDirectionsError};
use super::row_generation::generation::Generation;
use super::scaled::{KeptDirection, Scaled, Setting};
use crate::enclosing::answer::Effort;
use crate::enclosing::fixed_directions::departure::first_departure;
use crate::numeric::Rational;
use crate::numeric::exact_linear::{Span, rational};
use crate::numeric::outward::at_most;
use crate::numeric::scaling::scale_by_power_of_two;
use crate::tally::Tally;
use crate::zonotope::ray_exit::FacetMap;

/// The work that exact numbers may take in all for the sake of a better answer, in products of words: some half a
/// second. Programs of a hundred normals in numbers of like sizes take less, those of numbers of all sizes would take
/// far more.
const EXACT_WORK_LIMIT: u64 = 1 << 25;

/// A function that adds the normals which a method knows beforehand to the generation that begins with the axes as
/// normals, and returns the number of rows of the method's own program.
pub(super) trait AddNormals<const D: usize>:
    Fn(&Scaled<D>, &mut Generation<'_, D>, &mut dyn Tally) -> Result<usize, FixedDirectionsError>
{
}

impl<const D: usize, F> AddNormals<D> for F where
    F: Fn(&Scaled<D>, &mut Generation<'_, D>, &mut dyn Tally) -> Result<usize, FixedDirectionsError>
{
}

/// Solves a problem.
///
/// # Errors
/// When a coefficient of the answer exceeds the largest double.
pub(super) fn solve_with<const D: usize>(
    problem: &FixedDirections<'_, D>,
    tally: &mut dyn Tally,
    add_known_normals: impl AddNormals<D>,
) -> Result<Enclosure<D>, FixedDirectionsError> {
    let span = Span::of_doubles(problem.directions());
    if let Some(departure) = first_departure(&span, problem.points()) {
        return Ok(Enclosure::Infeasible(OffSpan { points: [0, departure.point], functional: departure.functional }));
    }
    if let Some(equilibrated) = Equilibrated::new(problem) {
        let problem = equilibrated.problem(problem);
        let answer = solve_in_span(&problem, &Span::of_doubles(problem.directions()), tally, &add_known_normals)?;
        if let Some(answer) = equilibrated.restored(answer) {
            return Ok(Enclosure::Optimal(answer));
        }
    }
    solve_in_span(problem, &span, tally, &add_known_normals).map(Enclosure::Optimal)
}

/// Solves a problem whose points differ by vectors of the directions' span.
fn solve_in_span<const D: usize>(
    problem: &FixedDirections<'_, D>,
    span: &Span,
    tally: &mut dyn Tally,
    add_known_normals: &impl AddNormals<D>,
) -> Result<DirectedZonotope<D>, FixedDirectionsError> {
    let scaled = Scaled::new(problem, span);
    if scaled.rank == 0 {
        return Ok(DirectedZonotope {
            center: problem.points()[0],
            coefficients: vec![0.0; problem.directions().len()],
            value: 0.0,
            lower_bound: 0.0,
            multipliers: Vec::new(),
            effort: Effort::default(),
        });
    }
    let vectors = scaled.directions.iter().map(|d| d.vector).collect();
    let weights = scaled.directions.iter().map(|d| d.weight).collect();
    let mut generation = Generation::new(scaled.rank, &scaled.points, vectors, weights, tally);
    let given_rows = add_known_normals(&scaled, &mut generation, tally)?;
    // A generation that gets stuck leaves a guess all the same. It is proven like any other, and the bounds say how
    // good it is.
    let _ = generation.run(tally);
    let mut answer = prove(Setting { problem, scaled: &scaled, span }, &mut generation)?;
    answer.effort.rows = answer.effort.rows.max(given_rows);
    Ok(answer)
}

/// The zonotope of a generation, made to contain every point, with the lower bound that its multipliers prove.
fn prove<const D: usize>(
    setting: Setting<'_, D>,
    generation: &mut Generation<'_, D>,
) -> Result<DirectedZonotope<D>, FixedDirectionsError> {
    let Setting { problem, scaled, .. } = setting;
    let program = &generation.program;
    let unbalanced: Vec<(usize, [f64; D])> =
        program.multipliers().map(|(row, y)| (row.point, row.normal.map(|c| c * y))).collect();
    let (bound, multipliers) = proven_bound(problem, scaled, &unbalanced);
    let lower_bound = at_most(&bound);
    let effort = Effort {
        rows: program.rows().len(),
        rounds: generation.rounds,
        passes: generation.passes,
        ..Effort::default()
    };
    let coefficients = program.coefficients().to_vec();
    let mut active: Vec<usize> = program.rows().iter().map(|row| row.point).collect();
    active.push(0);
    let nearest = nearest_doubles(problem, scaled, &program.center());
    let is_flat = scaled.rank < D;
    let center = if is_flat { cheapest_center(setting, &nearest.map(rational), &coefficients) } else { nearest };
    // A guess may be off by more than doubles allow where numbers are of many sizes; from a point of its own the
    // zonotope needs no guess.
    let exact_work = Cell::new(EXACT_WORK_LIMIT);
    let mut answer = contain(problem, scaled, center, &coefficients, &mut generation.map, &exact_work)
        .or_else(|_| {
            contain(
                problem,
                scaled,
                problem.points()[0],
                &vec![0.0; coefficients.len()],
                &mut generation.map,
                &exact_work,
            )
        })?
        .zonotope;
    (answer.lower_bound, answer.multipliers, answer.effort) = (lower_bound, multipliers, effort);
    if !answer.is_tight() {
        refine(setting, active, &mut generation.map, &exact_work, &mut answer)?;
    }
    if answer.value == f64::INFINITY { Err(FixedDirectionsError::OutOfRange) } else { Ok(answer) }
}

/// Coefficients with which the zonotope along the directions of a problem contains every point, from a centre, which
/// stays, and a guess of the coefficients, which are enlarged where a point needs it. `None` if there are none, or if
/// one leaves the range of doubles.
pub(crate) fn contained<const D: usize>(
    problem: &FixedDirections<'_, D>,
    center: [f64; D],
    coefficients: &[f64],
) -> Option<Vec<f64>> {
    let span = Span::of_doubles(problem.directions());
    if first_departure(&span, problem.points()).is_some() {
        return None;
    }
    let scaled = Scaled::new(problem, &span);
    let vectors: Vec<[f64; D]> = scaled.directions.iter().map(|d| d.vector).collect();
    let guess = |d: &KeptDirection<D>| scale_by_power_of_two(coefficients[d.index], d.exponent - scaled.exponent);
    let guess: Vec<f64> = scaled.directions.iter().map(guess).collect();
    let mut map = FacetMap::new(scaled.rank, &vectors);
    let container = contain(problem, &scaled, center, &guess, &mut map, &Cell::new(EXACT_WORK_LIMIT)).ok()?;
    Some(container.zonotope.coefficients)
}

/// The centre of doubles from which a generator along one direction reaches points of that line and is nearly as short
/// as from an exact centre. `None` if the points and the direction are no problem.
pub(crate) fn cheapest_center_along<const D: usize>(
    points: &[[f64; D]],
    direction: &[f64; D],
    exact: &[Rational; D],
) -> Option<[f64; D]> {
    let problem = FixedDirections::new(points, std::slice::from_ref(direction), &[1.0]).ok()?;
    let span = Span::of_doubles(problem.directions());
    let scaled = Scaled::new(&problem, &span);
    Some(cheapest_center(Setting { problem: &problem, scaled: &scaled, span: &span }, exact, &[1.0]))
}
