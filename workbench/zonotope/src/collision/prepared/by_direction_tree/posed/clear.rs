//! Points and pairs of bodies that are clear, from a hundred nodes of each tree.

use super::PosedTrees;
use crate::collision::PosedQuery;
use crate::collision::by_lad::early::{self, Clear, posed::PosedRows};
use crate::collision::prepared::by_direction_tree::clear::Told;
use crate::lad::of_generators::seam::generators::KernelQuery;
use crate::numeric::bounded;
use crate::numeric::linear::dot;
use crate::numeric::tolerance::{FIVE_ROUNDINGS, NODE_BODY_DOUBT, NODE_BODY_STRETCH, UNIT};
use crate::tally::{Operation, Rung, Tally};
use crate::zonotope::pose::Pose;

impl PosedTrees<'_> {
    /// Where the displacement ends, if that is clear: from nodes, or where sums of nodes are of no use, from the
    /// generators.
    pub(super) fn told(&self, tally: &mut dyn Tally) -> Option<Told> {
        if self.is_told_by_nodes() {
            return self.told_by_nodes(tally);
        }
        early::locate(&PosedRows::new(&self.query)?, tally).map(|clear| Told::Written(clear.location()))
    }

    /// Whether what rounding takes off the sums of nodes and off the displacement is little.
    ///
    /// A third of [`NODE_BODY_DOUBT`] is the gauge of the roundings of the sums of one body, and M x is in s M Z if x
    /// is in s Z; the last third is left for the displacement.
    fn is_told_by_nodes(&self) -> bool {
        let off = self.p.iter().map(|c| c.error + 2.0 * UNIT * c.value.abs()).sum::<f64>() * FIVE_ROUNDINGS;
        self.tree_parts().all(|part| part.tree.is_told_by_nodes)
            && self.known_gauge_bound().is_some_and(|bound| 3.0 * bound * off < NODE_BODY_DOUBT)
    }

    fn told_by_nodes(&self, tally: &mut dyn Tally) -> Option<Told> {
        let longer = self.p.map(|c| c.value * NODE_BODY_STRETCH);
        let fronts = |i: usize| self.trees[i].map_or(&[][..], |tree| &tree.first_front.sums);
        let [from, to] = self.query.poses().map(|pose| pose.matrix());
        let poses = [Pose::new(from, [0.0; 3]).ok()?, Pose::new(to, longer).ok()?];
        let query = PosedQuery::of_runs([[0.0; 3]; 2], poses, [fronts(0), fronts(1)]);
        tally.add(Operation::GeneratorRead, query.len() as u64);
        // the rung is noted when the answer is one for the bodies, too
        match early::locate(&PosedRows::new(&query)?, &mut ())? {
            Clear::Inside(witness) => {
                tally.answered_by(Rung::LeastSquares);
                Some(Told::Inside(witness.coefficients))
            }
            Clear::Flat(_) => None,
            Clear::Outside(u) => {
                let along = dot(&self.p, &bounded::exact(u));
                [false, true].into_iter().find(|&is_middle| {
                    self.tree_parts()
                        .fold(along, |along, part| {
                            let front = if is_middle { &part.tree.middle_front } else { &part.tree.first_front };
                            tally.add(Operation::GeneratorRead, front.sums.len() as u64);
                            along - part.in_frame(&u, |u| part.tree.support_from_outside(front, u))
                        })
                        .is_positive()
                })?;
                tally.answered_by(Rung::SampledDirection);
                Some(Told::Outside(u))
            }
        }
    }
}
