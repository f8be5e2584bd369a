//! The generators whose sign at a vertex is not certain: those of its facet, or nearly, beside the two of the vertex.

use crate::lad::of_generators::cells::reduced::Reduced;
use crate::lad::of_generators::guess::facet_coefficients::FacetPlane;
use crate::lad::of_generators::seam::sign_pass::FixedSum;
use crate::numeric::bounded::{Bounded, BoundedVector, approximate};
use crate::numeric::linear::dot;
use crate::numeric::reused::Reused;
use crate::numeric::tolerance::UNIT;

/// The generators whose sign at a vertex is not certain, with their part of the sum g.
pub(super) struct Near {
    pub(super) sum: BoundedVector,
    pub(super) shares: Reused<(usize, f64)>,
    pub(super) shared: f64,
    pub(super) missing: f64,
}

impl Near {
    /// The sum g at a vertex, from the positions of the generators in a level. The products of `duals`, b × p and p ×
    /// a, with a vector x give the coordinates of x in terms of a and b. An error is the position of a generator
    /// along whose line the objective falls.
    pub(super) fn new(
        level: &Reduced,
        [first, second]: [usize; 2],
        near: &[u32],
        direction: &BoundedVector,
        duals: &[BoundedVector; 2],
        fixed: &FixedSum,
    ) -> Result<Self, usize> {
        if near.is_empty() {
            return Ok(Self { sum: fixed.bounded(), shares: Reused::new(), shared: 0.0, missing: 0.0 });
        }
        let pair = [&level.vectors[first], &level.vectors[second]];
        let plane = FacetPlane::of_duals(pair, duals.map(|dual| dual.map(|c| c.value)));
        let near = near.iter().map(|&place| place as usize);
        let members: Reused<usize> = near.clone().chain([first, second]).collect();
        let generators = members.iter().map(|&i| level.vectors[i]);
        let parts = plane.shares(generators, &fixed.sum.map(|c| -c)).map_err(|place| members[place])?;
        let (mut total, mut shared, mut missing) = ([0.0; 3], 0.0, 0.0);
        for (i, part) in near.clone().zip(&parts) {
            let v = level.vectors[i];
            for (total, c) in total.iter_mut().zip(v) {
                *total += part * c;
            }
            shared += v.iter().map(|c| c.abs()).sum::<f64>();
            missing += 2.0 * dot(&approximate(v, level.relative_error), direction).magnitude();
        }
        let slack = 1.0 + (near.len() + 8) as f64 * 4.0 * UNIT;
        // a rounding for each product, which may underflow, and one for each addition
        let error = (near.len() + 1) as f64 * (UNIT * shared * slack + f64::MIN_POSITIVE)
            + level.relative_error * shared * slack;
        let sum = [0, 1, 2].map(|k| fixed.bounded()[k] + Bounded { value: total[k], error });
        let shares = near.zip(&parts).map(|(i, &part)| (level.indices[i] as usize, part)).collect();
        Ok(Self { sum, shares, shared: shared * slack, missing: missing * slack })
    }
}
