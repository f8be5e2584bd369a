//! Points far inside and far outside, from a hundred nodes: no generator is read.
//!
//! The sums of the nodes are the generators of a body within the body. With the boxes of their directions they bound
//! the body from outside as well: the generators of a node are w x with x in its box and Σ w x its sum, and |x · u| is
//! below its chord over the box. Both are known but for rounding, for which a point must be a little farther in, and a
//! direction must separate by a little more.

use fearless_simd::{Simd, dispatch, f64x8, prelude::*};

use super::DirectionTree;
use super::answer::Certified;
use super::nodes::{CHILDREN, Front, NodeBlock};
use super::part::TreePart;
use super::query::TreeQuery;
use crate::collision::Location;
use crate::collision::by_lad::early;
use crate::lad::of_generators::seam::kernel_query::KernelQuery;
use crate::numeric::bounded::{self, Bounded};
use crate::numeric::lanes::level::level;
use crate::numeric::lanes::number::product;
use crate::numeric::lanes::octet::{splat, total};
use crate::numeric::linear::{dot, sum_norm};
use crate::numeric::tolerance::{
    CHORD_ROUNDING, FIVE_ROUNDINGS, LONG_SUM, NODE_BODY_DOUBT, NODE_BODY_ROUNDING, NODE_BODY_STRETCH,
    PRODUCT_UNDERFLOW, UNIT,
};
use crate::tally::{Operation, Rung, Tally};
use crate::zonotope::pose::Standing;
use crate::zonotope::query::{Placed, Query};

impl<P: Standing> TreeQuery<'_, P> {
    /// The location of the displacement, if it is far inside or outside: from nodes, or where sums of nodes are of no
    /// use, from the generators.
    pub(super) fn early(&self, tally: &mut dyn Tally) -> Option<Certified> {
        if self.is_located_by_nodes() {
            return self.located_by_nodes(tally);
        }
        early::locate(&self.query, tally).map(|proof| Certified::Written(proof.counted(tally).written(&self.query)))
    }

    /// Whether what rounding takes off the sums of nodes and off the displacement is little.
    ///
    /// A third of [`NODE_BODY_DOUBT`] is the gauge of the roundings of the sums of one body, and M x is in s M Z if x
    /// is in s Z; the last third is left for the displacement.
    fn is_located_by_nodes(&self) -> bool {
        let p = self.query.rounded_displacement();
        let off = p.iter().map(|c| c.error + 2.0 * UNIT * c.value.abs()).sum::<f64>() * FIVE_ROUNDINGS;
        let is_near = || self.known_gauge_bound().is_some_and(|bound| 3.0 * bound * off < NODE_BODY_DOUBT);
        self.query.is_moderate()
            && self.tree_parts().iter().all(|part| part.tree.is_located_by_nodes)
            && (P::IS_FIXED || is_near())
    }

    /// The location of the displacement, if the nodes of a front decide it.
    fn located_by_nodes(&self, tally: &mut dyn Tally) -> Option<Certified> {
        let p = self.query.rounded_displacement();
        // the bodies of the first fronts where the trees stand, apart by a longer way
        let longer = p.map(|c| c.value * NODE_BODY_STRETCH);
        let front = |i: usize, place: [f64; 3]| {
            let Some(tree) = self.trees[i] else { return Some(Placed::point(place)) };
            let body = tree.first_body.as_ref()?.placed();
            Some(body.standing_as(*self.query.parts()[i].standing()).centered_at(place))
        };
        let is_finite = longer.iter().all(|c| c.is_finite());
        let query = Query::of_placed(front(0, [0.0; 3])?, front(1, longer).filter(|_| is_finite)?);
        tally.add(Operation::GeneratorRead, query.len() as u64);
        // the rung is noted when the answer is one for the bodies, too
        let proof = early::locate(&query, &mut ())?;
        if let Some(u) = proof.direction() {
            let along = dot(&p, &bounded::exact(u));
            [false, true].into_iter().find(|&is_middle| {
                let beyond = |along, part: &TreePart<'_>| {
                    let tree = part.tree;
                    let front = if is_middle { &tree.middle_front } else { &tree.first_front };
                    tally.add(Operation::GeneratorRead, front.sums.len() as u64);
                    along - part.in_frame(&u, |u| tree.support_from_outside(front, u))
                };
                self.tree_parts().iter().fold(along, beyond).is_positive()
            })?;
            tally.answered_by(Rung::SampledDirection);
            return Some(Certified::Written(proof.location.written(&query)));
        }
        let Location::Inside(witness) = proof.location.written(&query) else { return None };
        tally.answered_by(Rung::LeastSquares);
        Some(Certified::Sums(witness.coefficients))
    }
}

impl DirectionTree {
    /// Whether points that rounded sums of nodes put inside are inside.
    pub(super) fn rounding_is_little(gauge_bound: f64, weight: f64) -> bool {
        gauge_bound * (NODE_BODY_ROUNDING * weight) < NODE_BODY_DOUBT
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
