//! The steps that all methods in floating point share: from the normals that a method begins with to a proven answer.
//!
//! The steps in the order of the code, each with the file that takes it:
//! 1. the span of the directions, exactly, and points off it: `span`;
//! 2. coordinates of ordinary size, one direction for each line: `scaled`;
//! 3. normals and coefficients, guessed in doubles: `by_row_generation`;
//! 4. multipliers that add up to zero exactly, and the lower bound that they prove: `lower_bound`;
//! 5. centre and coefficients in doubles that contain every point: `contain`;
//! 6. where the bounds are apart and the problem is small, the optimum in rationals: `rational`.

use super::answer::{DirectedZonotope, Effort, Enclosure, OffSpan};
use super::by_row_generation::Generation;
use super::contain::contain;
use super::contain::flat_center::{cheapest_center, nearest_doubles};
use super::lower_bound::proven_bound;
use super::problem::{FixedDirections, FixedDirectionsError};
use super::rational::refine;
use super::scaled::{Scaled, Setting};
use super::span::{Span, rational};
use crate::enclosing::outward::rounded_towards;
use crate::tally::Tally;

/// Solves from the normals that `seed` adds on: it gets the generation that begins with the axes as normals, adds those that a
/// method knows beforehand, and returns how many rows the method's own program had.
///
/// # Errors
/// When a coefficient of the answer is no double.
pub(super) fn solve_with<const D: usize, T: Tally>(
    problem: &FixedDirections<'_, D>,
    tally: &mut T,
    seed: impl FnOnce(&Scaled<D>, &mut Generation<'_, D>, &mut T) -> Result<usize, FixedDirectionsError>,
) -> Result<Enclosure<D>, FixedDirectionsError> {
    let span = Span::of(problem.directions());
    if let Some(departure) = span.first_departure(problem.points()) {
        return Ok(Enclosure::Infeasible(OffSpan { points: [0, departure.point], functional: departure.functional }));
    }
    let scaled = Scaled::new(problem, &span);
    if scaled.rank == 0 {
        return Ok(Enclosure::Optimal(DirectedZonotope {
            center: problem.points()[0],
            coefficients: vec![0.0; problem.directions().len()],
            value: 0.0,
            lower_bound: 0.0,
            multipliers: Vec::new(),
            effort: Effort::default(),
        }));
    }
    let vectors = scaled.directions.iter().map(|d| d.vector).collect();
    let weights = scaled.directions.iter().map(|d| d.weight).collect();
    let mut generation = Generation::new(scaled.rank, &scaled.points, vectors, weights, tally);
    let given_rows = seed(&scaled, &mut generation, tally)?;
    // A generation that gets stuck has a guess all the same. It is contained as any other, and the bounds tell how good it is.
    let _ = generation.run(tally);
    let mut answer = prove(Setting { problem, scaled: &scaled, span: &span }, &mut generation)?;
    answer.effort.rows = answer.effort.rows.max(given_rows);
    Ok(Enclosure::Optimal(answer))
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
    let lower_bound = rounded_towards(&bound, f64::NEG_INFINITY);
    let effort =
        Effort { rows: program.rows().len(), rounds: generation.rounds, passes: generation.passes, exact: false };
    let coefficients = program.coefficients().to_vec();
    let mut active: Vec<usize> = program.rows().iter().map(|row| row.point).collect();
    active.push(0);
    let nearest = nearest_doubles(problem, scaled, &program.center());
    let is_flat = scaled.rank < D;
    let center = if is_flat { cheapest_center(setting, &nearest.map(rational), &coefficients) } else { nearest };
    let mut answer = contain(problem, scaled, center, &coefficients, &mut generation.map)?.zonotope;
    (answer.lower_bound, answer.multipliers, answer.effort) = (lower_bound, multipliers, effort);
    if !answer.is_tight() {
        refine(setting, active, &mut generation.map, &mut answer)?;
    }
    if answer.value == f64::INFINITY { Err(FixedDirectionsError::OutOfRange) } else { Ok(answer) }
}
