//! What the zonotope misses of a point near its boundary: the exact residual of the best coefficients found.
//!
//! Coefficients for the point come from the facet through which its ray leaves the zonotope; if it leaves before the
//! point, from a facet of a thickened zonotope. One or two corrections make up for their exact residual. The residual
//! that is left is expressed in the basis of directions, whose enlarged coefficients make up for it.

use super::basis::independent;
use super::body::Body;
use super::thickened::Thickened;
use crate::numeric::Rational;
use crate::numeric::dyadic::Dyadic;
use crate::numeric::linear::{dot, inverse};

/// A ray counts as reaching its point if it leaves at a multiple of the point that is below 1 by less than this.
const REACH_TOLERANCE: f64 = 1e-12;

/// A residual longer than this, relative to the point's distance from the centre, is worth a search in rationals.
const LARGE_RESIDUAL: f64 = 1e-9;

/// The rational program for one point is solved for at most this many directions.
const RATIONAL_DIRECTION_LIMIT: usize = 12;

impl<const D: usize> Body<'_, D> {
    /// The magnitudes, with respect to the basis, of the exact residual that the best coefficients found for a point
    /// leave.
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
            let deltas: Vec<f64> = facet.coefficients.iter().map(|delta| delta / reach).collect();
            if !deltas.iter().all(|delta| delta.is_finite()) {
                continue;
            }
            size = keep(deltas);
            if facet.reach > 1.0 - REACH_TOLERANCE {
                break;
            }
        }
        let extent = q.iter().fold(0.0, |max: f64, c| max.max(c.abs()));
        // Numbers of too many sizes for floating point leave no size that is a number.
        let is_small_enough = size <= LARGE_RESIDUAL * extent && extent.is_finite();
        if !is_small_enough {
            let is_small = self.generators.len() <= RATIONAL_DIRECTION_LIMIT;
            keep(if is_small { self.rational_coefficients(point) } else { vec![0.0; self.generators.len()] });
        }
        // Coefficients of zero leave the whole of the point.
        least.map_or_else(|| self.missing(point, &mut vec![0.0; self.generators.len()]), |(_, missing)| missing)
    }

    /// The largest of the magnitudes of a residual with respect to the basis, in scaled units and rounded.
    fn size(&self, missing: &[Rational]) -> f64 {
        let exponents = self.basis.iter().map(|&b| self.scaled.directions[b].exponent);
        let sizes = missing.iter().zip(exponents).map(|(m, exponent)| {
            let unit = Dyadic::new(1.into(), exponent - self.scaled.exponent).to_rational();
            (m * unit).to_f64_fast()
        });
        sizes.fold(0.0, f64::max)
    }

    /// The magnitudes, with respect to the basis, of the exact residual of coefficients for a point, which are improved
    /// first.
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
        self.magnitudes_in_basis(&best)
    }

    /// Changes the coefficients of independent generators so that they make up for a residual, as far as ±1 allows;
    /// generators with much room below ±1 are preferred. False if there are too few independent ones.
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
            let changed = deltas[b] + dot(row, residual);
            deltas[b] = if changed.is_nan() { deltas[b] } else { changed.clamp(-1.0, 1.0) };
        }
        true
    }
}
