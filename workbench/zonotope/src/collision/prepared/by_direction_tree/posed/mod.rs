//! Trees under poses: a body that turns keeps its tree.
//!
//! A cell of directions and a direction are pulled back into the frame in which the tree was built, and the sums that
//! the nodes tell are pushed forward; the tree itself is never touched. So one or two moving bodies are asked about
//! in each frame without being built anew.

mod answer;
mod clear;

#[cfg(test)]
mod tests;

pub use answer::{PosedLocated, PosedMeasured};

use super::DirectionTree;
use super::answer::Found;
use super::guess::cell_near_optimum;
use super::part::TreePart;
use super::query::LIKELY_CROSSING;
use crate::collision::PosedQuery;
use crate::lad::of_generators::goal::Goal;
use crate::lad::of_generators::seam::direction_cone::DirectionCone;
use crate::lad::of_generators::seam::frame::Frame;
use crate::lad::of_generators::seam::generators::{Generators, KernelQuery, Part};
use crate::lad::of_generators::seam::sign_pass::{FixedSum, Places};
use crate::lad::of_generators::solve;
use crate::numeric::bounded::{Bounded, BoundedVector};
use crate::numeric::exact_linear::{self, ExactVector};
use crate::numeric::lanes::rows::Rows;
use crate::numeric::non_finite::NonFinite;
use crate::tally::Tally;
use crate::zonotope::pose::Pose;
use crate::zonotope::query::Query;

/// A body with its tree, where a pose puts it.
#[derive(Debug, Clone, Copy)]
pub struct PosedTree<'t> {
    tree: &'t DirectionTree,
    pose: Pose,
}

impl DirectionTree {
    /// The body where a pose puts it; the tree stays as it is. O(1).
    pub fn at(&self, pose: &Pose) -> PosedTree<'_> {
        PosedTree { tree: self, pose: *pose }
    }
}

impl<'t> PosedTree<'t> {
    /// Where a point lies relative to the posed body, exactly, with a proof that is written out on request.
    ///
    /// # Errors
    /// [`NonFinite`] if a coordinate of the point is NaN or infinite.
    pub fn locate(&self, point: [f64; 3]) -> Result<PosedLocated<'t>, NonFinite> {
        self.locate_counted(point, &mut ())
    }

    /// [`locate`](Self::locate), counting its operations.
    ///
    /// # Errors
    /// [`NonFinite`] if a coordinate of the point is NaN or infinite.
    pub fn locate_counted(&self, point: [f64; 3], tally: &mut dyn Tally) -> Result<PosedLocated<'t>, NonFinite> {
        Ok(PosedTrees::about(self, point)?.located(tally))
    }

    /// How many times the posed body must be taken, from its centre, to hold a point.
    ///
    /// # Errors
    /// [`NonFinite`] if a coordinate of the point is NaN or infinite.
    pub fn gauge(&self, point: [f64; 3]) -> Result<PosedMeasured<'t>, NonFinite> {
        Ok(PosedTrees::about(self, point)?.measured(&mut ()))
    }

    /// How two bodies meet where their poses put them (Lemma 5.1), exactly: inside if their interiors have a point in
    /// common, boundary if they only touch or their sum is flat, outside if they are disjoint.
    pub fn intersection(&self, other: &Self) -> PosedLocated<'t> {
        self.intersection_counted(other, &mut ())
    }

    /// [`intersection`](Self::intersection), counting its operations.
    pub fn intersection_counted(&self, other: &Self, tally: &mut dyn Tally) -> PosedLocated<'t> {
        PosedTrees::between(self, other).located(tally)
    }

    /// How many times both bodies must be taken, each about its centre, until they touch.
    pub fn gauge_between(&self, other: &Self) -> PosedMeasured<'t> {
        PosedTrees::between(self, other).measured(&mut ())
    }
}

/// A displacement relative to the generators of one or two posed trees, in the order of the trees.
#[derive(Debug)]
pub(super) struct PosedTrees<'t> {
    pub(super) query: PosedQuery<'t>,
    /// The tree of each run; the second run may be empty.
    trees: [Option<&'t DirectionTree>; 2],
    /// The matrix of each run; none for the identity.
    frames: [Option<Frame>; 2],
    /// The displacement, rounded.
    p: BoundedVector,
}

impl<'t> PosedTrees<'t> {
    fn about(body: &PosedTree<'t>, point: [f64; 3]) -> Result<Self, NonFinite> {
        NonFinite::check_vector("the end", &point)?;
        let PosedTree { tree, pose } = *body;
        let runs = [&tree.rows[..], &[]];
        let query = PosedQuery::of_runs([tree.center, point], [pose, Pose::IDENTITY], runs);
        Ok(Self::new(query, [Some(tree), None]))
    }

    fn between(from: &PosedTree<'t>, to: &PosedTree<'t>) -> Self {
        let [a, b] = [from.tree, to.tree];
        let query = PosedQuery::of_runs([a.center, b.center], [from.pose, to.pose], [&a.rows, &b.rows]);
        Self::new(query, [Some(a), Some(b)])
    }

    fn new(query: PosedQuery<'t>, trees: [Option<&'t DirectionTree>; 2]) -> Self {
        let frames = query.poses().map(|pose| Some(Frame::new(&pose)).filter(|frame| !frame.is_identity()));
        let p = query.rounded_displacement();
        Self { query, trees, frames, p }
    }

    /// The trees with their matrices.
    pub(super) fn tree_parts(&self) -> impl Iterator<Item = TreePart<'_>> {
        let frames = self.frames.iter().map(Option::as_ref);
        self.trees.iter().zip(frames).filter_map(|(tree, frame)| Some(TreePart { tree: (*tree)?, frame }))
    }

    /// Whether the generators certainly span space: those of one body do, and its matrix does not flatten it.
    pub(super) fn is_solid(&self) -> bool {
        self.tree_parts()
            .any(|part| part.tree.is_solid && part.frame.is_none_or(|frame| frame.relative_error().is_finite()))
    }

    fn located(self, tally: &mut dyn Tally) -> PosedLocated<'t> {
        let found = match self.told(tally) {
            Some(told) => Found::Told(told),
            None => Found::Facet(solve(&self, Goal::Location, tally)),
        };
        PosedLocated { query: self, found }
    }

    fn measured(self, tally: &mut dyn Tally) -> PosedMeasured<'t> {
        let optimum = solve(&self, Goal::Gauge, tally);
        let (value, error) = optimum.gauge();
        PosedMeasured { value, error, location: PosedLocated { query: self, found: Found::Facet(optimum) } }
    }
}

impl Generators for PosedTrees<'_> {
    fn parts(&self) -> [Part<'_>; 2] {
        [0, 1].map(|i| {
            let rows = self.trees[i].map_or(Rows::NONE, |tree| Rows::new(&tree.rows));
            Part { rows, frame: self.frames[i].as_ref() }
        })
    }

    fn expected_crossing(&self) -> usize {
        LIKELY_CROSSING
    }

    fn support(&self, u: &[f64; 3]) -> Bounded {
        self.tree_parts().map(|part| part.support(u)).reduce(|a, b| a + b).unwrap_or(Bounded::exact(0.0))
    }

    fn split(&self, cell: &DirectionCone, crossing: &mut Vec<[f64; 3]>, indices: &mut Places) -> FixedSum {
        let mut fixed = FixedSum::default();
        let mut offset = 0;
        for part in self.tree_parts() {
            fixed = fixed.plus(&part.split(cell, offset, crossing, indices));
            offset += part.tree.rows.len();
        }
        fixed
    }
}

impl KernelQuery for PosedTrees<'_> {
    fn exact(&self) -> ExactVector {
        self.query.displacement().clone()
    }

    fn rounded_displacement(&self) -> BoundedVector {
        self.p
    }

    fn as_query(&self) -> Option<Query<'_, 3>> {
        None
    }

    fn likely_cell(&self, tally: &mut dyn Tally) -> Option<DirectionCone> {
        let parts: Vec<_> = self.tree_parts().collect();
        cell_near_optimum(&parts, self.p.map(|c| c.value), tally)
    }

    fn exact_sum_along(&self, direction: &ExactVector) -> Option<ExactVector> {
        let mut sums = self.tree_parts().map(|part| part.exact_sum_along(direction));
        let first = sums.next()??;
        sums.try_fold(first, |sum, next| Some(exact_linear::sum(&sum, &next?)))
    }

    /// A body holds each of the two that it is the sum of, and M x is in s M Z if x is in s Z.
    fn known_gauge_bound(&self) -> Option<f64> {
        let bound = |part: TreePart<'_>| part.tree.gauge_bound * part.frame.map_or(1.0, Frame::shortening);
        self.tree_parts().map(bound).filter(|bound| !bound.is_nan()).reduce(f64::min)
    }
}
