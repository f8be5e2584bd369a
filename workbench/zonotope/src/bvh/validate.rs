//! The check that a hierarchy is one: every triangle below each of its nodes, and inside their volumes, exactly.

use thiserror::Error;

use super::hierarchy::Bvh;
use super::volume::BoundingVolume;

/// A fault of a hierarchy: none that [`Bvh::build`] makes has one.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum Fault {
    /// A triangle is in no leaf, or in two.
    #[error("triangle {triangle} is in {leaves} leaves")]
    Leaves {
        /// The triangle, from 0.
        triangle: usize,
        /// The leaves that hold it.
        leaves: usize,
    },
    /// The triangles of a node are not those of its children.
    #[error("node {node} has other triangles than its children")]
    Children {
        /// The node, from 0.
        node: usize,
    },
    /// A corner of a triangle is outside the volume of a node above it.
    #[error("node {node} does not contain a corner of triangle {triangle}")]
    Outside {
        /// The node, from 0.
        node: usize,
        /// The triangle, from 0.
        triangle: usize,
    },
}

impl<V: BoundingVolume> Bvh<V> {
    /// Checks the tree, and that every volume contains its triangles, exactly. O(n log n) exact tests.
    ///
    /// # Errors
    /// The first [`Fault`].
    pub fn validate(&self) -> Result<(), Fault> {
        let mut leaves = vec![0; self.mesh.triangles().len()];
        for (at, node) in self.topology.nodes.iter().enumerate() {
            let below = &self.topology.order[node.range()];
            match node.children(at) {
                Some([left, right]) => {
                    let [left, right] = [left, right].map(|child| self.topology.nodes[child].range());
                    let whole = node.range();
                    let fits = left.start == whole.start && left.end == right.start && right.end == whole.end;
                    if !fits || left.is_empty() || right.is_empty() {
                        return Err(Fault::Children { node: at });
                    }
                }
                None => below.iter().for_each(|&triangle| leaves[triangle as usize] += 1),
            }
            for &triangle in below {
                let corners = self.mesh.triangles()[triangle as usize].map(|vertex| self.points[vertex as usize]);
                if !corners.iter().all(|corner| self.volumes[at].contains(corner)) {
                    return Err(Fault::Outside { node: at, triangle: triangle as usize });
                }
            }
        }
        match leaves.iter().position(|&count| count != 1) {
            Some(triangle) => Err(Fault::Leaves { triangle, leaves: leaves[triangle] }),
            None => Ok(()),
        }
    }
}
