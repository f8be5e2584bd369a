//! Points far inside and far outside, from a hundred nodes: no generator is read.
//!
//! The sums of the nodes are the generators of a body within the body. With the boxes of their directions they bound
//! the body from outside as well: the generators of a node are w x with x in its box and Σ w x its sum, and |x · u| is
//! below its chord over the box. Both are known but for rounding, for which a point must be a little farther in, and a
//! direction must separate by a little more.

use fearless_simd::{Simd, dispatch, f64x8, prelude::*};

use super::DirectionTree;
use super::nodes::{CHILDREN, Front, NodeBlock};
use super::query::TreeQuery;
use crate::collision::Location;
use crate::collision::by_lad::early::{self, Clear};
use crate::lad::of_generators::seam::generators::KernelQuery;
use crate::numeric::bounded::{self, Bounded, BoundedVector};
use crate::numeric::lanes::level::level;
use crate::numeric::lanes::number::product;
use crate::numeric::lanes::octet::{splat, total};
use crate::numeric::linear::{dot, sum_norm};
use crate::numeric::tolerance::{
    CHORD_ROUNDING, LONG_SUM, NODE_BODY_DOUBT, NODE_BODY_ROUNDING, NODE_BODY_STRETCH, PRODUCT_UNDERFLOW, UNIT,
};
use crate::tally::{Operation, Rung, Tally};
use crate::zonotope::query::Query;

/// A point of which it is clear where it lies.
#[derive(Debug, Clone)]
pub(super) enum Told {
    /// The coefficients of the nodes of the first front, whose sum is nearly the point times [`NODE_BODY_STRETCH`].
    Inside(Vec<f64>),
    /// A direction that separates.
    Outside([f64; 3]),
    /// The location by passes over all generators, in the order of the tree.
    Written(Location<3>),
}

impl DirectionTree {
    /// Whether points that are told inside by the rounded sums of nodes are inside.
    pub(super) fn rounding_is_little(gauge_bound: f64, weight: f64) -> bool {
        gauge_bound * (NODE_BODY_ROUNDING * weight) < NODE_BODY_DOUBT
    }

    /// Where a displacement ends, if that is clear: from nodes, or where sums of nodes are of no use, from the
    /// generators.
    pub(super) fn told(&self, query: &TreeQuery<'_>, tally: &mut dyn Tally) -> Option<Told> {
        if self.is_told_by_nodes {
            return self.told_by_nodes(&query.rounded_displacement(), tally);
        }
        early::locate(&query.query, tally).map(|clear| Told::Written(clear.location()))
    }

    /// Where a displacement ends, if the nodes of a front tell.
    fn told_by_nodes(&self, p: &BoundedVector, tally: &mut dyn Tally) -> Option<Told> {
        let longer = p.map(|c| c.value * NODE_BODY_STRETCH);
        let query = Query::of_point_in(longer, self.first_body.as_ref()?).ok()?;
        tally.add(Operation::GeneratorRead, query.len() as u64);
        // the rung is noted when the answer is one for the body, too
        match early::locate(&query, &mut ())? {
            Clear::Inside(witness) => {
                tally.answered_by(Rung::LeastSquares);
                Some(Told::Inside(witness.coefficients))
            }
            Clear::Flat(_) => None,
            Clear::Outside(u) => {
                let along = dot(p, &bounded::exact(u));
                let fronts = [&self.first_front, &self.middle_front];
                fronts.iter().find(|front| {
                    tally.add(Operation::GeneratorRead, front.sums.len() as u64);
                    (along - self.support_from_outside(front, &u)).is_positive()
                })?;
                tally.answered_by(Rung::SampledDirection);
                Some(Told::Outside(u))
            }
        }
    }

    /// At least Σ |v · u|, less its error.
    pub(super) fn support_from_outside(&self, front: &Front, u: &[f64; 3]) -> Bounded {
        let value = dispatch!(level(), simd => chords(simd, &front.blocks, u));
        let additions = (front.blocks.len() + CHILDREN) as f64;
        let error = UNIT * additions * value + CHORD_ROUNDING * self.weight * sum_norm(u);
        Bounded { value, error: error * LONG_SUM + additions * PRODUCT_UNDERFLOW }
    }
}

/// Σ max(|S · u|, (W (r² − c²) + (S · u) c) / r) over the nodes, where x · u is in [c − r, c + r] over the box, Σ w = W
/// and Σ w x = S: the second is the mean of a chord of |·| over that range, and below |S · u| where the range is on one
/// side of 0.
#[inline(always)]
fn chords<S: Simd>(simd: S, blocks: &[NodeBlock], u: &[f64; 3]) -> f64 {
    let (wide, sizes) = (splat(simd, u), splat(simd, &u.map(f64::abs)));
    let least = f64x8::splat(simd, f64::MIN_POSITIVE);
    let mut sum = f64x8::splat(simd, 0.0);
    for block in blocks {
        let center = product(&block.middle.load(simd), &wide);
        let reach = product(&block.half.load(simd), &sizes) + product(&block.side.load(simd), &wide).abs();
        let reach = reach.max(least);
        let along = product(&block.sum.load(simd), &wide);
        let weight = f64x8::from_slice(simd, &block.weight);
        // (r² − c²) / r, without the square of a small number
        let part = center / reach;
        let chord = weight * (reach - center * part) + along * part;
        let is_cut = part.abs().simd_lt(1.0);
        sum += is_cut.select(chord.max(along.abs()), along.abs());
    }
    total(sum)
}
