//! The questions about two hierarchies: whether they meet, where, and how far apart they are; and the volumes of a
//! level of one in the coordinates of its mesh.

use std::ops::ControlFlow;

use thiserror::Error;

use super::hierarchy::{Bvh, PlacedBvh};
use super::mesh::PlacedMesh;
use super::nearest::{MeshDistance, distance};
use super::question::Question;
use super::traverse::descend;
use super::volume::BoundingVolume;
use super::volumes::aabb::Aabb;
use super::volumes::shape::Shaped;
use crate::numeric::scaling::scale_by_power_of_two;
use crate::tally::Tally;
use crate::zonotope::Zonotope;

/// The roundings to multiples of the smallest double that a margin takes up: of the centre and of each generator. All
/// other coordinates of a mesh are its units times a power of two, without rounding.
const SMALLEST_ROUNDINGS: u64 = 16;

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

/// The bounding volume of a node in the coordinates of the mesh, and the triangles in it.
#[derive(Debug, Clone, PartialEq)]
pub struct Enclosed {
    /// The body without its margin.
    pub shape: Zonotope<3>,
    /// The number m such that the shape and the cube [−m, m]³ sum up to a body that contains the triangles exactly.
    pub margin: f64,
    /// The triangles, from 0, in increasing order.
    pub triangles: Vec<usize>,
}

/// A volume reaches beyond the range of doubles.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Error)]
#[error("the volume of node {node} of the level reaches beyond the range of doubles")]
pub struct BeyondDoubles {
    /// The node's place in the level, from 0.
    pub node: usize,
}

impl<V: Shaped> Bvh<V> {
    /// The volumes of a level in the coordinates of the mesh: of the nodes that many steps below the root, and of the
    /// leaves above them. Each triangle is in one of them.
    ///
    /// # Errors
    /// [`BeyondDoubles`] for a mesh so large that a volume around it is no body of doubles.
    ///
    /// # Example
    /// ```
    /// use zonotope::bvh::{Bvh, Mesh, OrientedBox};
    /// let corners = vec![[1.0, 1.0, 1.0], [1.0, -1.0, -1.0], [-1.0, 1.0, -1.0], [-1.0, -1.0, 1.0]];
    /// let mesh = Mesh::new(corners, vec![[0, 1, 2], [0, 2, 3], [0, 3, 1], [1, 3, 2]])?;
    /// let level = Bvh::<OrientedBox>::build(&mesh).level(1)?;
    /// assert_eq!(level.iter().map(|node| node.triangles.len()).sum::<usize>(), 4);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn level(&self, depth: usize) -> Result<Vec<Enclosed>, BeyondDoubles> {
        let nodes = self.topology.level(depth).into_iter().enumerate();
        nodes.map(|(place, node)| self.enclosed(node).ok_or(BeyondDoubles { node: place })).collect()
    }

    fn enclosed(&self, node: usize) -> Option<Enclosed> {
        let volume = &self.volumes[node];
        let scaled = |v: &[f64; 3]| v.map(|c| scale_by_power_of_two(c, self.exponent));
        let shape = volume.shape();
        let generators = shape.generators().iter().map(scaled).collect();
        let margin = scale_by_power_of_two(volume.margin() + self.rounding, self.exponent).next_up();
        let margin = margin + f64::from_bits(SMALLEST_ROUNDINGS);
        let shape = Zonotope::new(scaled(&shape.center()), generators).ok()?;
        let below = &self.topology.order[self.topology.nodes[node].range()];
        let mut triangles: Vec<usize> = below.iter().map(|&triangle| triangle as usize).collect();
        triangles.sort_unstable();
        margin.is_finite().then_some(Enclosed { shape, margin, triangles })
    }
}
