//! Makes a guess for centre and coefficients contain every point, exactly.
//!
//! The centre is rounded to doubles first and stays. For each point coefficients δ with Σ δ_i c_i v_i ≈ point − p come from the facet that its ray meets.
//! A point clearly inside needs no more than an error bound: what the sum misses, expressed in a basis of directions, fits between δ and 1.
//! For a point near the boundary what is missing is computed exactly, and the coefficients of the basis are enlarged by the most that any point misses.

mod basis;
pub(super) mod flat_center;
mod thickened;

use super::problem::{FixedDirections, FixedDirectionsError};
use super::rational::simplex::{Column, maximize};
use super::scaled::Scaled;
use super::span::rational;
use crate::enclosing::outward::rounded_towards;
use crate::numeric::Rational;
use crate::numeric::dyadic::{Dyadic, scale_by_power_of_two};
use crate::numeric::tolerance::{UNDERFLOW, UNIT};
use crate::zonotope::ray_exit::{Exit, FacetMap, dot, inverse};
use basis::independent;
use thickened::Lengthened;

pub(super) use basis::{exact_inverse, long_basis};

/// A centre and coefficients in units of the input.
pub(crate) struct Repaired<const D: usize> {
    pub(crate) center: [f64; D],
    /// One for each direction of the problem.
    pub(crate) coefficients: Vec<f64>,
    /// The point that was missed by most.
    pub(crate) worst: Option<usize>,
}

/// A point nearer to the boundary than this, relatively, is looked at exactly.
const NEAR: f64 = 1e-9;

/// A ray that leaves beyond this multiple less than 1, relatively, has reached its point.
const REACHED: f64 = 1e-12;

/// A generator shorter than this, beside the longest, is left out: what it would have reached others do.
const NOISE: f64 = 1e-14;

/// Programs of at most this many directions are solved in rationals when floating point finds no coefficients.
const FEW: usize = 12;

struct Repair<'a, const D: usize> {
    problem: &'a FixedDirections<'a, D>,
    scaled: &'a Scaled<D>,
    center: [f64; D],
    /// In units of the input, one for each kept direction.
    coefficients: Vec<f64>,
    generators: Vec<[f64; D]>,
    basis: Vec<usize>,
    basis_inverse: [[f64; D]; D],
    exact_inverse: Vec<Vec<Rational>>,
}

/// The nearest doubles to the guess, enlarged until every point is inside.
pub(crate) fn contain_exactly<const D: usize>(
    problem: &FixedDirections<'_, D>,
    scaled: &Scaled<D>,
    center: [f64; D],
    coefficients: &[f64],
    map: &mut FacetMap<D>,
) -> Result<Repaired<D>, FixedDirectionsError> {
    let mut all = vec![0.0; problem.directions().len()];
    if scaled.rank == 0 {
        return Ok(Repaired { center, coefficients: all, worst: None });
    }
    let units: Vec<i64> = scaled.directions.iter().map(|d| scaled.exponent - d.exponent).collect();
    let in_units = |c: &f64, unit: &i64| scale_by_power_of_two(c.max(0.0), *unit);
    let coefficients: Vec<f64> = coefficients.iter().zip(&units).map(|(c, u)| in_units(c, u)).collect();
    if coefficients.iter().any(|c| !c.is_finite()) {
        return Err(FixedDirectionsError::OutOfRange);
    }
    // Beside the others these are noise, and would be noise in every search for a facet.
    let lengths = || {
        scaled
            .directions
            .iter()
            .map(|d| dot(&d.vector, &d.vector).sqrt() * scale_by_power_of_two(1.0, d.exponent - scaled.exponent))
    };
    let longest = lengths().zip(&coefficients).fold(0.0, |max: f64, (l, c)| max.max(l * c));
    let coefficients =
        lengths().zip(coefficients).map(|(l, c)| if l * c < NOISE * longest { 0.0 } else { c }).collect();
    let repair = Repair::new(problem, scaled, center, coefficients);
    let (enlarge, worst) = repair.enlargements(map);
    let mut coefficients = repair.coefficients;
    for (&b, more) in repair.basis.iter().zip(enlarge) {
        if !more.is_zero() {
            let exact = Dyadic::from_f64(coefficients[b]).to_rational() + more;
            coefficients[b] = above(&exact);
        }
    }
    for (direction, c) in scaled.directions.iter().zip(&coefficients) {
        if !c.is_finite() {
            return Err(FixedDirectionsError::OutOfRange);
        }
        all[direction.index] = *c;
    }
    Ok(Repaired { center, coefficients: all, worst })
}

/// A double not below a rational that is not negative.
pub(crate) fn above(exact: &Rational) -> f64 {
    if exact.is_zero() {
        return 0.0;
    }
    let mut value = exact.to_f64_fast().max(f64::from_bits(1));
    while value.is_finite() && rational(value) < *exact {
        value = value.next_up();
    }
    value
}

/// A double not above a rational that is not negative.
pub(crate) fn below(exact: &Rational) -> f64 {
    let mut value = exact.to_f64_fast().clamp(0.0, f64::MAX);
    while value > 0.0 && rational(value) > *exact {
        value = value.next_down();
    }
    value
}

/// The generators in the scaled coordinates, from coefficients there.
pub(super) fn generators<const D: usize>(scaled: &Scaled<D>, coefficients: &[f64]) -> Vec<[f64; D]> {
    scaled.directions.iter().zip(coefficients).map(|(d, &c)| d.vector.map(|v| v * c)).collect()
}

impl<'a, const D: usize> Repair<'a, D> {
    fn new(
        problem: &'a FixedDirections<'a, D>,
        scaled: &'a Scaled<D>,
        center: [f64; D],
        coefficients: Vec<f64>,
    ) -> Self {
        let units = scaled.directions.iter().map(|d| d.exponent - scaled.exponent);
        let in_scale: Vec<f64> = coefficients.iter().zip(units).map(|(&c, u)| scale_by_power_of_two(c, u)).collect();
        let generators = generators(scaled, &in_scale);
        let basis = long_basis(problem, scaled, &generators);
        let exact_inverse = exact_inverse(problem, scaled, &basis);
        let mut columns = [[0.0; D]; D];
        for (i, &b) in basis.iter().enumerate() {
            for (row, &v) in columns.iter_mut().zip(&scaled.directions[b].vector) {
                row[i] = v;
            }
        }
        // Used only where the exact inverse is near it.
        let basis_inverse = inverse(scaled.rank, &columns).unwrap_or([[f64::INFINITY; D]; D]);
        Self { problem, scaled, center, coefficients, generators, basis, basis_inverse, exact_inverse }
    }

    /// For each direction of the basis how much longer its coefficient must be, and the point that needs most.
    fn enlargements(&self, map: &mut FacetMap<D>) -> (Vec<Rational>, Option<usize>) {
        let rank = self.scaled.rank;
        let mut enlarge = vec![Rational::ZERO; rank];
        let mut worst = None;
        let basis = self.basis.iter().map(|&b| (b, self.scaled.directions[b].vector));
        let mut lengthened = Lengthened::new(rank, &self.generators, basis);
        let extents: [f64; D] = std::array::from_fn(|c| self.generators.iter().map(|g| g[c].abs()).sum());
        let inside: Vec<f64> = (0..self.generators.len()).map(|i| self.coefficient(i)).collect();
        map.set_coefficients(&inside);
        let is_good = self.inverse_is_good();
        for (j, point) in self.problem.points().iter().enumerate() {
            let q: [f64; D] = std::array::from_fn(|i| {
                self.scaled.coordinates.get(i).map_or(0.0, |&c| self.scaled.difference(point[c], self.center[c]))
            });
            let is_clear = |exit: Exit<D>| exit.gauge > 1.0 + NEAR && self.is_clear(&q, &exit, &extents);
            if is_good && map.exit(&q).is_some_and(is_clear) {
                continue;
            }
            let missing = self.least_missing(point, &q, &mut lengthened);
            for (more, need) in enlarge.iter_mut().zip(missing) {
                if need > *more {
                    *more = need;
                    worst = Some(j);
                }
            }
        }
        (enlarge, worst)
    }

    /// What the best coefficients found for a point miss of it, in the basis, exactly.
    fn least_missing(&self, point: &[f64; D], q: &[f64; D], lengthened: &mut Lengthened<'_, D>) -> Vec<Rational> {
        let mut least: Option<(f64, Vec<Rational>)> = None;
        let mut keep = |mut deltas: Vec<f64>| {
            let missing = self.missing(point, &mut deltas);
            let size = self.size(&missing);
            if least.as_ref().is_none_or(|(least, _)| size < *least) {
                least = Some((size, missing));
            }
            least.as_ref().map_or(size, |(least, _)| *least)
        };
        let mut size = f64::INFINITY;
        for step in 0..lengthened.steps() {
            let Some(facet) = lengthened.facet(step, q) else { continue };
            let reach = facet.gauge.max(1.0);
            size = keep(facet.coefficients.iter().map(|delta| delta / reach).collect());
            if facet.gauge > 1.0 - REACHED {
                break;
            }
        }
        let extent = q.iter().fold(0.0, |max: f64, c| max.max(c.abs()));
        if size > NEAR * extent {
            let few = self.generators.len() <= FEW;
            keep(if few { self.exact_deltas(point) } else { vec![0.0; self.generators.len()] });
        }
        least.map_or_else(|| vec![Rational::ZERO; self.scaled.rank], |(_, missing)| missing)
    }

    /// The longest of what is missing along each direction of the basis, roughly.
    fn size(&self, missing: &[Rational]) -> f64 {
        let exponents = self.basis.iter().map(|&b| self.scaled.directions[b].exponent);
        let sizes = missing.iter().zip(exponents).map(|(m, exponent)| {
            let unit = Dyadic::new(1.into(), exponent - self.scaled.exponent).to_rational();
            (m * unit).to_f64_fast()
        });
        sizes.fold(0.0, f64::max)
    }

    /// In units of the scaled problem.
    fn coefficient(&self, direction: usize) -> f64 {
        let exponent = self.scaled.directions[direction].exponent - self.scaled.exponent;
        scale_by_power_of_two(self.coefficients[direction], exponent)
    }

    /// Whether what Σ δ_i c_i v_i misses of the point, with all rounding errors, fits between δ and 1 in the basis.
    fn is_clear(&self, q: &[f64; D], exit: &Exit<D>, extents: &[f64; D]) -> bool {
        let rank = self.scaled.rank;
        let count = self.generators.len() as f64;
        let bound: [f64; D] = std::array::from_fn(|c| {
            (exit.sum[c] - q[c]).abs()
                + (count + 8.0) * UNIT * extents[c]
                + 8.0 * UNIT * q[c].abs()
                + (count + 8.0) * UNDERFLOW
        });
        self.basis.iter().enumerate().all(|(i, &b)| {
            let reach: f64 = (0..rank).map(|c| self.basis_inverse[i][c].abs() * bound[c]).sum();
            1.0625 * reach <= self.coefficient(b) * (1.0 - exit.most) * (1.0 - 1e-6)
        })
    }

    /// Whether inverse · basis differs from the identity by little.
    fn inverse_is_good(&self) -> bool {
        let rank = self.scaled.rank;
        (0..rank).all(|i| {
            let row = &self.basis_inverse[i];
            let off = |k: usize| {
                let column = &self.scaled.directions[self.basis[k]].vector;
                (dot(row, column) - f64::from(u8::from(i == k))).abs()
            };
            (0..rank).all(|k| off(k) <= 1e-3)
        })
    }

    /// What Σ δ_i c_i v_i misses of a point, in the basis, exactly; the coefficients are improved first.
    fn missing(&self, point: &[f64; D], deltas: &mut [f64]) -> Vec<Rational> {
        let rank = self.scaled.rank;
        let mut best = self.residual(point, deltas);
        for _ in 0..2 {
            let rounded: [f64; D] = std::array::from_fn(|i| {
                if i < rank { best[i].clone().scaled(-self.scaled.exponent).to_f64() } else { 0.0 }
            });
            if rounded == [0.0; D] {
                break;
            }
            let mut improved = deltas.to_vec();
            if !self.improve(&rounded, &mut improved) {
                break;
            }
            let residual = self.residual(point, &improved);
            let size = |r: &[Dyadic]| r.iter().fold(Dyadic::zero(), |max, c| max.max(c.clone().abs()));
            if size(&residual) >= size(&best) {
                break;
            }
            deltas.copy_from_slice(&improved);
            best = residual;
        }
        self.in_basis(&best)
    }

    /// How much of each direction of the basis a vector is, either way.
    fn in_basis(&self, vector: &[Dyadic]) -> Vec<Rational> {
        let vector: Vec<Rational> = vector.iter().map(Dyadic::to_rational).collect();
        let entry = |row: &Vec<Rational>| row.iter().zip(&vector).fold(Rational::ZERO, |sum, (m, v)| sum + m * v);
        let entries = self.exact_inverse.iter().map(entry);
        entries.map(|x| if x < Rational::ZERO { -x } else { x }).collect()
    }

    /// Adds to the coefficients of independent generators with room what makes up for a residual, as far as the room goes.
    fn improve(&self, residual: &[f64; D], deltas: &mut [f64]) -> bool {
        let rank = self.scaled.rank;
        let roomy: Vec<[f64; D]> = self
            .generators
            .iter()
            .zip(&*deltas)
            .map(|(g, delta)| {
                let room = 1.0 - delta.abs();
                g.map(|c| c * room)
            })
            .collect();
        let basis = independent(rank, &roomy);
        let mut columns = [[0.0; D]; D];
        for (i, &b) in basis.iter().enumerate() {
            for (row, &g) in columns.iter_mut().zip(&self.generators[b]) {
                row[i] = g;
            }
        }
        let Some(rows) = (basis.len() == rank).then(|| inverse(rank, &columns)).flatten() else { return false };
        for (row, &b) in rows.iter().zip(&basis) {
            deltas[b] = (deltas[b] + dot(row, residual)).clamp(-1.0, 1.0);
        }
        true
    }

    /// point − p − Σ δ_i c_i v_i in the coordinates of the span, exactly.
    fn residual(&self, point: &[f64; D], deltas: &[f64]) -> Vec<Dyadic> {
        let coordinates = &self.scaled.coordinates;
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

    /// Coefficients from the rational program: what Σ δ_i c_i v_i misses of point − p, in the basis, costs least.
    fn exact_deltas(&self, point: &[f64; D]) -> Vec<f64> {
        let coordinates = &self.scaled.coordinates;
        let count = self.generators.len();
        let mut columns = Vec::with_capacity(2 * (count + self.basis.len()) + 1);
        let mut add = |limited: usize, along: &dyn Fn(usize) -> Rational, gain: &Rational| {
            let inequalities = (0..=count).map(|i| Rational::from(u8::from(i == limited))).collect();
            let equalities = coordinates.iter().map(|&a| along(a)).collect();
            columns.push(Column { inequalities, equalities, gain: gain.clone() });
        };
        let index = |i: usize| self.scaled.directions[i].index;
        let along = |i: usize, a: usize| rational(self.problem.directions()[index(i)][a]);
        let weight = |i: usize| rational(self.problem.weights()[index(i)]);
        for (i, &c) in self.coefficients.iter().enumerate() {
            add(i, &|a| rational(c) * along(i, a), &Rational::ZERO);
            add(i, &|a| -rational(c) * along(i, a), &Rational::ZERO);
        }
        for &b in &self.basis {
            add(usize::MAX, &|a| along(b, a), &-weight(b));
            add(usize::MAX, &|a| -along(b, a), &-weight(b));
        }
        // Whole at once the basis reaches the point for less than this, so to reach it always pays.
        let whole = self.in_basis(&self.residual(point, &[]));
        let cost = self.basis.iter().zip(whole).fold(Rational::ONE, |sum, (&b, x)| sum + weight(b) * x);
        add(count, &|a| rational(self.center[a]) - rational(point[a]), &cost);
        let Some(optimum) = maximize(&columns, &vec![Rational::ONE; count + 1], coordinates.len()) else {
            return vec![0.0; count];
        };
        let pairs = optimum.solution.chunks_exact(2).take(count);
        pairs.map(|pair| (&pair[0] - &pair[1]).to_f64_fast().clamp(-1.0, 1.0)).collect()
    }
}

/// Σ w_i c_i, rounded up; infinite above the largest double.
pub(crate) fn value_above(weights: &[f64], coefficients: &[f64]) -> f64 {
    let sum = weights.iter().zip(coefficients).fold(Dyadic::zero(), |sum, (&w, &c)| {
        if w == 0.0 || c == 0.0 { sum } else { sum + &Dyadic::from_f64(w) * &Dyadic::from_f64(c) }
    });
    rounded_towards(&sum, f64::INFINITY)
}
