//! What the zonotope misses of a point near its boundary, exactly and as little as can be found.
//!
//! Coefficients for the point come from the facet that its ray meets, if need be of a thickened zonotope, then from one
//! or two corrections by their own exact residual. The residual that is left is taken in the basis of directions.

use super::basis::independent;
use super::body::Body;
use super::thickened::Thickened;
use crate::numeric::Rational;
use crate::numeric::dyadic::Dyadic;
use crate::zonotope::ray_exit::{dot, inverse};

/// A ray that leaves short of its point by less than this, relatively, counts as having reached it.
const REACH_TOLERANCE: f64 = 1e-12;

/// A residual longer than this beside the point's distance from the centre is worth a search in rationals.
const LARGE_RESIDUAL: f64 = 1e-9;

/// The rational program for one point is solved for at most this many directions.
const RATIONAL_DIRECTION_LIMIT: usize = 12;

impl<const D: usize> Body<'_, D> {
    /// What the best coefficients found for a point miss of it, in the basis, exactly.
    pub(super) fn least_missing(
        &self,
        point: &[f64; D],
        q: &[f64; D],
        thickened: &mut Thickened<'_, D>,
    ) -> Vec<Rational> {
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
        for step in 0..thickened.steps() {
            let Some(facet) = thickened.facet(step, q) else { continue };
            let reach = facet.reach.max(1.0);
            size = keep(facet.coefficients.iter().map(|delta| delta / reach).collect());
            if facet.reach > 1.0 - REACH_TOLERANCE {
                break;
            }
        }
        let extent = q.iter().fold(0.0, |max: f64, c| max.max(c.abs()));
        if size > LARGE_RESIDUAL * extent {
            let is_small = self.generators.len() <= RATIONAL_DIRECTION_LIMIT;
            keep(if is_small { self.rational_coefficients(point) } else { vec![0.0; self.generators.len()] });
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

    /// Adds to the coefficients of independent generators with room what makes up for a residual, as far as the room
    /// goes.
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
}
