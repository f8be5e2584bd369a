//! From a program over normals to a proven answer: what all methods share.

use super::answer::{DirectedZonotope, Effort, Enclosure, Force, OffSpan};
use super::brute_force;
use super::by_row_generation::Generation;
use super::contain::flat_center::{Wanted, nearest_doubles};
use super::contain::{below, contain_exactly, exact_inverse, generators, long_basis, value_above};
use super::lower_bound::proven_bound;
use super::problem::{FixedDirections, FixedDirectionsError};
use super::scaled::Scaled;
use super::span::{Span, rational};
use crate::enclosing::outward::rounded_towards;
use crate::numeric::Rational;
use crate::numeric::dyadic::Dyadic;
use crate::tally::Tally;
use crate::zonotope::ray_exit::FacetMap;

/// A relative gap with which floating point is left alone.
const TIGHT: f64 = 1e-13;

/// What a miss along a free direction counts for, beside the cheapest that is not.
const FREE: f64 = 1e-6;

/// Rational programs with more normals than this are not tried.
const MOST_NORMALS: usize = 130;

/// Rational programs with more points than this are not tried.
const MOST_POINTS: usize = 80;

/// Begins with some normals, finds the others as they are needed, and proves the answer. `seed` adds what a method knows beforehand.
pub(crate) fn solve_with<const D: usize, T: Tally>(
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
            forces: Vec::new(),
            effort: Effort::default(),
        }));
    }
    let vectors = scaled.directions.iter().map(|d| d.vector).collect();
    let weights = scaled.directions.iter().map(|d| d.weight).collect();
    let mut generation = Generation::new(scaled.rank, &scaled.points, vectors, weights, tally);
    let given_rows = seed(&scaled, &mut generation, tally)?;
    // Where it gets stuck, what it has is repaired all the same, and the bounds tell how good that is.
    let _ = generation.run(tally);
    let mut answer = Proof { problem, scaled: &scaled, span: &span }.of(&mut generation)?;
    answer.effort.rows = answer.effort.rows.max(given_rows);
    Ok(Enclosure::Optimal(answer))
}

struct Proof<'a, const D: usize> {
    problem: &'a FixedDirections<'a, D>,
    scaled: &'a Scaled<D>,
    span: &'a Span<D>,
}

impl<const D: usize> Proof<'_, D> {
    fn of(&self, generation: &mut Generation<'_, D>) -> Result<DirectedZonotope<D>, FixedDirectionsError> {
        let program = &generation.program;
        let pulls: Vec<(usize, [f64; D])> =
            program.multipliers().map(|(row, y)| (row.point, row.normal.map(|c| c * y))).collect();
        let (bound, forces) = proven_bound(self.problem, self.scaled, &pulls);
        let lower_bound = rounded_towards(&bound, f64::NEG_INFINITY);
        let effort =
            Effort { rows: program.rows().len(), rounds: generation.rounds, passes: generation.passes, exact: false };
        let coefficients = program.coefficients().to_vec();
        let guess = nearest_doubles(self.problem, self.scaled, &program.center());
        let center = if self.scaled.rank == D { guess } else { self.center(&guess.map(rational), &coefficients) };
        let (mut answer, _) = self.around(center, &coefficients, &mut generation.map)?;
        (answer.lower_bound, answer.forces, answer.effort) = (lower_bound, forces, effort);
        let is_tight = answer.value - answer.lower_bound <= TIGHT * answer.lower_bound;
        if !is_tight || answer.lower_bound == 0.0 && answer.value > 0.0 {
            self.improve_exactly(generation, &mut answer)?;
        }
        if answer.value == f64::INFINITY { Err(FixedDirectionsError::OutOfRange) } else { Ok(answer) }
    }

    /// Doubles from which the directions with coefficients other than zero have least to make up for, nearly.
    fn center(&self, place: &[Rational; D], coefficients: &[f64]) -> [f64; D] {
        let basis = long_basis(self.problem, self.scaled, &generators(self.scaled, coefficients));
        let weights = basis.iter().map(|&b| rational(self.problem.weights()[self.scaled.directions[b].index]));
        let weights: Vec<Rational> = weights.collect();
        // what is free may be missed by more, but not by anything
        let least = weights.iter().filter(|w| !w.is_zero()).min();
        let free = least.map_or(Rational::ONE, |least| least * rational(FREE));
        let mut cost = exact_inverse(self.problem, self.scaled, &basis);
        for (row, weight) in cost.iter_mut().zip(&weights) {
            let weight = if weight.is_zero() { &free } else { weight };
            row.iter_mut().for_each(|entry| *entry *= weight);
        }
        let place = self.scaled.coordinates.iter().map(|&c| place[c].clone()).collect();
        Wanted { problem: self.problem, span: self.span, place, cost }.center()
    }

    /// Doubles for the centre of the optimum, the most promising first.
    fn centers(&self, place: &[Rational; D], is_free: bool, coefficients: &[f64]) -> Vec<[f64; D]> {
        if is_free {
            return vec![self.problem.points()[0]];
        }
        let nearest = place.clone().map(|c| c.to_f64_fast().clamp(-f64::MAX, f64::MAX));
        let cheap = self.center(place, coefficients);
        if self.scaled.rank == D && nearest != cheap { vec![nearest, cheap] } else { vec![cheap] }
    }

    /// The zonotope around a centre that contains all points, and the point that was missed by most.
    fn around(
        &self,
        center: [f64; D],
        coefficients: &[f64],
        map: &mut FacetMap<D>,
    ) -> Result<(DirectedZonotope<D>, Option<usize>), FixedDirectionsError> {
        let repaired = contain_exactly(self.problem, self.scaled, center, coefficients, map)?;
        let value = value_above(self.problem.weights(), &repaired.coefficients);
        let (center, coefficients) = (repaired.center, repaired.coefficients);
        let (forces, effort) = (Vec::new(), Effort::default());
        Ok((DirectedZonotope { center, coefficients, value, lower_bound: 0.0, forces, effort }, repaired.worst))
    }

    /// Small programs in rationals: the optimum of the points that matter, then of those that it leaves outside.
    fn improve_exactly(
        &self,
        generation: &mut Generation<'_, D>,
        answer: &mut DirectedZonotope<D>,
    ) -> Result<(), FixedDirectionsError> {
        let kept = &self.scaled.directions;
        if normal_count(kept.len(), self.scaled.rank) > MOST_NORMALS {
            return Ok(());
        }
        let directions: Vec<[f64; D]> = kept.iter().map(|d| self.problem.directions()[d.index]).collect();
        let weights: Vec<f64> = kept.iter().map(|d| self.problem.weights()[d.index]).collect();
        let mut active: Vec<usize> = generation.program.rows().iter().map(|row| row.point).collect();
        active.push(0);
        loop {
            active.sort_unstable();
            active.dedup();
            if active.len() > MOST_POINTS {
                return Ok(());
            }
            let points: Vec<[f64; D]> = active.iter().map(|&j| self.problem.points()[j]).collect();
            let part = FixedDirections::new(&points, &directions, &weights)?;
            let Some(optimum) = brute_force::least_length(&part) else { return Ok(()) };
            let lower_bound = below(&optimum.value);
            let scaled = |exact: &Rational, exponent: i64| {
                let two = Dyadic::new(1.into(), -exponent).to_rational();
                (exact * two).to_f64_fast()
            };
            // Where free directions suffice they do so, twice as long, around the first point, and no rounding of a centre costs anything.
            let is_free = optimum.value.is_zero();
            let longer = i64::from(is_free);
            let coefficients: Vec<f64> = kept
                .iter()
                .zip(&optimum.coefficients)
                .map(|(d, c)| scaled(c, self.scaled.exponent - d.exponent - longer))
                .collect();
            answer.effort.exact = true;
            if lower_bound >= answer.lower_bound {
                answer.lower_bound = lower_bound;
                let forces = optimum.forces.into_iter();
                answer.forces = forces.map(|(point, vector)| Force { point: active[point], vector }).collect();
            }
            let mut missed = None;
            for center in self.centers(&optimum.center, is_free, &coefficients) {
                let (candidate, worst) = self.around(center, &coefficients, &mut generation.map)?;
                let is_tight = candidate.value - lower_bound <= TIGHT * lower_bound;
                if candidate.value < answer.value {
                    (answer.center, answer.coefficients, answer.value) =
                        (candidate.center, candidate.coefficients, candidate.value);
                }
                if is_tight {
                    return Ok(());
                }
                missed = worst.filter(|point| !active.contains(point)).or(missed);
            }
            match missed {
                Some(point) => active.push(point),
                None => return Ok(()),
            }
        }
    }
}

/// C(k, rank − 1), or a larger number than anyone counts to.
fn normal_count(k: usize, rank: usize) -> usize {
    let size = rank.saturating_sub(1);
    if size > k {
        return 0;
    }
    (0..size).fold(1, |count: usize, i| count.saturating_mul(k - i) / (i + 1))
}
