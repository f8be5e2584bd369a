//! The questions about two hierarchies: whether they meet, where, and how far apart they are.

use std::ops::ControlFlow;

use super::hierarchy::{Bvh, PlacedBvh};
use super::mesh::PlacedMesh;
use super::nearest::{MeshDistance, distance};
use super::question::Question;
use super::traverse::descend;
use super::volume::BoundingVolume;
use super::volumes::aabb::Aabb;
use crate::tally::Tally;

impl<V: BoundingVolume> Bvh<V> {
    /// Whether the mesh meets another one; closed, so touching counts.
    pub fn intersects<'a>(&'a self, other: impl Into<PlacedBvh<'a, V>>) -> bool {
        PlacedBvh::from(self).intersects(other)
    }

    /// All pairs of triangles that meet, in increasing order.
    pub fn pairs<'a>(&'a self, other: impl Into<PlacedBvh<'a, V>>) -> Vec<[usize; 2]> {
        PlacedBvh::from(self).pairs(other)
    }

    /// The distance from another mesh, between two bounds.
    pub fn distance<'a>(&'a self, other: impl Into<PlacedBvh<'a, V>>) -> MeshDistance {
        PlacedBvh::from(self).distance(other)
    }
}

impl<V: BoundingVolume> PlacedBvh<'_, V> {
    /// Whether the mesh meets another one; closed, so touching counts.
    pub fn intersects(&self, other: impl Into<Self>) -> bool {
        self.witness(other, &mut ()).is_some()
    }

    /// A pair of triangles that meet, if the meshes do; node tests and triangle tests are counted.
    pub fn witness(&self, other: impl Into<Self>, tally: &mut dyn Tally) -> Option<[usize; 2]> {
        let question = Question::new(*self, other.into());
        let mut found = None;
        descend(&question, tally, |pair| {
            found = Some(pair);
            ControlFlow::Break(())
        });
        found
    }

    /// All pairs of triangles that meet, in increasing order.
    pub fn pairs(&self, other: impl Into<Self>) -> Vec<[usize; 2]> {
        self.at_most_pairs(other, usize::MAX, &mut ()).expect("no more pairs are found than a number can count")
    }

    /// All pairs of triangles that meet, in increasing order, if they are at most `limit`; node tests and triangle
    /// tests are counted.
    pub fn at_most_pairs(
        &self,
        other: impl Into<Self>,
        limit: usize,
        tally: &mut dyn Tally,
    ) -> Option<Vec<[usize; 2]>> {
        let question = Question::new(*self, other.into());
        let mut found = Vec::new();
        let mut is_complete = true;
        descend(&question, tally, |pair| {
            is_complete = found.len() < limit;
            if !is_complete {
                return ControlFlow::Break(());
            }
            found.push(pair);
            ControlFlow::Continue(())
        });
        found.sort_unstable();
        is_complete.then_some(found)
    }

    /// The distance from another mesh, between two bounds within a thousandth of each other.
    pub fn distance(&self, other: impl Into<Self>) -> MeshDistance {
        distance(&Question::new(*self, other.into()), &mut ())
    }
}

/// Whether two meshes meet; closed, so touching counts. For a single question: who asks again keeps hierarchies.
pub fn meet<'a>(a: impl Into<PlacedMesh<'a>>, b: impl Into<PlacedMesh<'a>>) -> bool {
    let (a, b) = (a.into(), b.into());
    let [first, second] = [a.mesh(), b.mesh()].map(Bvh::<Aabb>::build);
    first.at(a.pose()).intersects(second.at(b.pose()))
}
