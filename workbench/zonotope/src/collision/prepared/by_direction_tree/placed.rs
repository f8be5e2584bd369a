//! Trees where their bodies stand: a body that turns keeps its tree.
//!
//! A cell of directions and a direction are pulled back into the frame in which the tree was built, and the sums that
//! the nodes tell are pushed forward; the tree itself is never touched. So one or two moving bodies are asked about
//! in each frame without being built anew.
//!
//! # Statement
//! Input: one or two bodies with their trees, each at rest or under a pose; a point. Output: location, gauge or how the
//! bodies meet, exactly, with a proof that is written out on request.
//!
//! # Source
//! Section 5.2 asks one body many times; that bodies turn between two questions is ours.
//!
//! # Method
//! 1. The question about two bodies is about the difference of their centres and the generators of both trees.
//! 2. A cell is pulled back into the frame of each tree; its nodes tell sums, which are pushed forward.
//! 3. The kernel searches as for one tree at rest.
//!
//! # Complexity
//! That of the tree at rest, and a product with a matrix for each node that is read.
//!
//! # Shapes
//! `point`: three coordinates; a pose is any matrix with a translation.
//!
//! # Numerics
//! Decisions are exact for the pose as it is given.
//!
//! # Errors
//! [`NonFinite`] if a coordinate of a point is NaN or infinite.
//!
//! # Checked by
//! The kernel without a tree, and `brute_force`.
//!
//! # Example
//! ```
//! use zonotope::{Pose, Zonotope};
//! use zonotope::collision::{Status, prepared::DirectionTree};
//! let axes = vec![[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
//! let tree = DirectionTree::new(&Zonotope::new([0.0; 3], axes).unwrap());
//! let moved = Pose::from_translation([2.0, 0.0, 0.0]).unwrap();
//! assert_eq!(tree.at(&moved).locate([1.0, 0.0, 0.0], &mut ()).unwrap().status(), Status::Boundary);
//! ```

use super::DirectionTree;
use super::answer::{Certified, Located, Measured};
use super::query::TreeQuery;
use crate::lad::of_generators::goal::Goal;
use crate::lad::of_generators::solve;
use crate::numeric::non_finite::NonFinite;
use crate::tally::Tally;
use crate::zonotope::pose::{AtRest, Pose, Standing};
use crate::zonotope::query::{Placed, Query};

/// A body with its tree, where it stands.
#[derive(Debug, Clone, Copy)]
pub struct PlacedTree<'t, P = AtRest> {
    tree: &'t DirectionTree,
    standing: P,
}

impl DirectionTree {
    /// The body where a pose puts it; the tree stays as it is. O(1).
    pub fn at(&self, pose: &Pose) -> PlacedTree<'_, Pose> {
        PlacedTree { tree: self, standing: *pose }
    }

    /// The body as it is stored. O(1).
    pub(super) fn placed(&self) -> PlacedTree<'_> {
        PlacedTree { tree: self, standing: AtRest }
    }
}

impl<'t, P: Standing> PlacedTree<'t, P> {
    /// The location of a point relative to the body, exactly, with a proof that is written out on request.
    ///
    /// # Errors
    /// [`NonFinite`] if a coordinate of the point is NaN or infinite.
    pub fn locate(&self, point: [f64; 3], tally: &mut dyn Tally) -> Result<Located<'t, P>, NonFinite> {
        Ok(self.query_about(point)?.located(tally))
    }

    /// The gauge: the number of times that the body must be taken, from its centre, to hold a point.
    ///
    /// # Errors
    /// [`NonFinite`] if a coordinate of the point is NaN or infinite.
    pub fn gauge(&self, point: [f64; 3], tally: &mut dyn Tally) -> Result<Measured<'t, P>, NonFinite> {
        Ok(self.query_about(point)?.measured(tally))
    }

    /// The status of two bodies where they stand (Lemma 5.1), exactly: inside if their interiors have a point in
    /// common, boundary if they only touch or their sum is flat, outside if they are disjoint.
    pub fn intersection(&self, other: &Self, tally: &mut dyn Tally) -> Located<'t, P> {
        self.query_between(other).located(tally)
    }

    /// The number of times that both bodies must be taken, each about its centre, until they touch.
    pub fn gauge_between(&self, other: &Self) -> Measured<'t, P> {
        self.query_between(other).measured(&mut ())
    }

    pub(super) fn query_about(&self, point: [f64; 3]) -> Result<TreeQuery<'t, P>, NonFinite> {
        let query = Query::of_point_in(point, self.body())?;
        Ok(TreeQuery { query, trees: [Some(self.tree), None] })
    }

    pub(super) fn query_between(&self, other: &Self) -> TreeQuery<'t, P> {
        TreeQuery { query: Query::of_placed(self.body(), other.body()), trees: [Some(self.tree), Some(other.tree)] }
    }

    /// The body, its generators in the order of the tree.
    fn body(&self) -> Placed<'t, 3, P> {
        Placed::of_finite(self.tree.center, &self.tree.rows).standing_as(self.standing)
    }
}

impl<'t, P: Standing> TreeQuery<'t, P> {
    fn located(self, tally: &mut dyn Tally) -> Located<'t, P> {
        let certified = match self.early(tally) {
            Some(certified) => certified,
            None => Certified::Facet(solve(&self, Goal::Location, tally)),
        };
        Located { query: self, certified }
    }

    fn measured(self, tally: &mut dyn Tally) -> Measured<'t, P> {
        let optimum = solve(&self, Goal::Gauge, tally);
        let (value, error) = optimum.gauge();
        Measured { value, error, location: Located { query: self, certified: Certified::Facet(optimum) } }
    }
}
