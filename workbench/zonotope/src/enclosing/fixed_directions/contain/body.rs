//! The zonotope whose containment is being proved: a centre and coefficients in doubles, with a basis of directions.

use std::cell::Cell;

use dashu_int::ops::Abs;

use super::basis::{exact_inverse, long_basis};
use crate::enclosing::fixed_directions::problem::FixedDirections;
use crate::enclosing::fixed_directions::scaled::Scaled;
use crate::numeric::Rational;
use crate::numeric::dyadic::Dyadic;
use crate::numeric::exact_linear::sum_of_products;
use crate::numeric::linear::inverse;
use crate::numeric::scaling::scale_by_power_of_two;

/// The work of an exact product of doubles and its sum with another one.
const WORK_PER_PRODUCT: u64 = 16;

/// A zonotope along the kept directions of a problem, whose containment of points is proved.
pub(super) struct Body<'a, const D: usize> {
    pub(super) problem: &'a FixedDirections<'a, D>,
    pub(super) scaled: &'a Scaled<D>,
    pub(super) center: [f64; D],
    /// The coefficient of each kept direction, in units of the input.
    pub(super) coefficients: Vec<f64>,
    /// The generators in the scaled coordinates, rounded.
    pub(super) generators: Vec<[f64; D]>,
    /// The sum of the coefficients in scaled units: what a generator loses to underflow is as much for each of them.
    pub(super) coefficient_sum: f64,
    /// A basis of the directions' span: kept directions, preferably those with long generators.
    pub(super) basis: Vec<usize>,
    /// The inverse of the basis's matrix in scaled coordinates, in doubles.
    pub(super) basis_inverse: [[f64; D]; D],
    /// The inverse of the basis's matrix in the coordinates of the input, exactly.
    pub(super) exact_inverse: Vec<Vec<Rational>>,
    /// The work that is left for exact numbers, in products of words.
    pub(super) exact_work: &'a Cell<u64>,
}

/// The generators in scaled coordinates, rounded, from coefficients in scaled units.
pub(in crate::enclosing::fixed_directions) fn generators<const D: usize>(
    scaled: &Scaled<D>,
    coefficients: &[f64],
) -> Vec<[f64; D]> {
    scaled.directions.iter().zip(coefficients).map(|(d, &c)| d.vector.map(|v| v * c)).collect()
}

impl<'a, const D: usize> Body<'a, D> {
    /// The zonotope with a centre and coefficients in units of the input.
    pub(super) fn new(
        problem: &'a FixedDirections<'a, D>,
        scaled: &'a Scaled<D>,
        center: [f64; D],
        coefficients: Vec<f64>,
        exact_work: &'a Cell<u64>,
    ) -> Self {
        let units = scaled.directions.iter().map(|d| d.exponent - scaled.exponent);
        let in_scale: Vec<f64> = coefficients.iter().zip(units).map(|(&c, u)| scale_by_power_of_two(c, u)).collect();
        let generators = generators(scaled, &in_scale);
        let coefficient_sum = in_scale.iter().sum();
        let basis = long_basis(problem, scaled, &generators);
        let exact_inverse = exact_inverse(problem, scaled, &basis);
        let mut columns = [[0.0; D]; D];
        for (i, &b) in basis.iter().enumerate() {
            for (row, &v) in columns.iter_mut().zip(&scaled.directions[b].vector) {
                row[i] = v;
            }
        }
        // A singular matrix gets an inverse that `basis_inverse_error` refuses.
        let basis_inverse = inverse(scaled.rank, &columns).unwrap_or([[f64::INFINITY; D]; D]);
        Self {
            problem,
            scaled,
            center,
            coefficients,
            generators,
            coefficient_sum,
            basis,
            basis_inverse,
            exact_inverse,
            exact_work,
        }
    }

    /// The coefficient of a kept direction in units of the scaled problem.
    pub(super) fn coefficient(&self, direction: usize) -> f64 {
        let exponent = self.scaled.directions[direction].exponent - self.scaled.exponent;
        scale_by_power_of_two(self.coefficients[direction], exponent)
    }

    /// The magnitudes of the coordinates of a vector with respect to the basis, exactly.
    pub(super) fn magnitudes_in_basis(&self, vector: &[Dyadic]) -> Vec<Rational> {
        let vector: Vec<Rational> = vector.iter().map(Dyadic::to_rational).collect();
        self.exact_inverse.iter().map(|row| sum_of_products(row, &vector).abs()).collect()
    }

    /// The residual point − p − Σ δ_i c_i v_i in the coordinates of the span, exactly.
    pub(super) fn residual(&self, point: &[f64; D], deltas: &[f64]) -> Vec<Dyadic> {
        let coordinates = &self.scaled.coordinates;
        let products = self.generators.len() as u64 * coordinates.len() as u64;
        self.exact_work.set(self.exact_work.get().saturating_sub(WORK_PER_PRODUCT * products));
        let mut rest: Vec<Dyadic> =
            coordinates.iter().map(|&c| Dyadic::from_f64(point[c]) - Dyadic::from_f64(self.center[c])).collect();
        for ((direction, &c), &delta) in self.scaled.directions.iter().zip(&self.coefficients).zip(deltas) {
            if c == 0.0 || delta == 0.0 {
                continue;
            }
            let factor = &Dyadic::from_f64(c) * &Dyadic::from_f64(delta);
            let v = &self.problem.directions()[direction.index];
            for (rest, &a) in rest.iter_mut().zip(coordinates) {
                *rest = &*rest - &(&factor * &Dyadic::from_f64(v[a]));
            }
        }
        rest
    }
}
