//! Volumes that are zonotopes of few generators, and those of a level of a hierarchy in the coordinates of its mesh.
//!
//! A volume is its shape and a margin: a cube, which takes up the rounding of the fit. The shape is for pictures, the
//! sum of both contains the triangles exactly. Coordinates of a mesh are its units times a power of two, so that
//! nothing is rounded on the way back but below the least normal double, for which the margin is made larger.

use thiserror::Error;

use crate::bvh::hierarchy::Bvh;
use crate::bvh::volume::BoundingVolume;
use crate::numeric::scaling::scale_by_power_of_two;
use crate::zonotope::Zonotope;

/// The roundings to multiples of the smallest double that a margin takes up: of the centre and of each generator.
const SMALLEST_ROUNDINGS: u64 = 16;

/// A bounding volume that is a zonotope of few generators beside a margin.
pub trait Shaped: BoundingVolume {
    /// The body without its margin, for pictures: it may miss its points by rounding.
    fn shape(&self) -> Zonotope<3>;

    /// The number m such that the shape and the cube [−m, m]³ sum up to a body that contains the points exactly.
    fn margin(&self) -> f64;
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
