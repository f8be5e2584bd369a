//! The trees of the crates obvhs and bvh, which have no questions about two trees: a traversal for both.
//!
//! Nodes are laid out alike, so that what differs is how the trees were built. Boxes of obvhs are in single precision:
//! they are rounded outwards.

use std::time::Duration;

use bvh::aabb::{Aabb, Bounded};
use bvh::bounding_hierarchy::BHShape;
use bvh::bvh::{Bvh, BvhNode};
use nalgebra::Point3;
use obvhs::bvh2::builder::build_bvh2;
use obvhs::{Boundable, BvhBuildParams};
use parry3d::glamx::Vec3A;
use zonotope::Pose;
use zonotope::bvh::Mesh;

use super::contender::Contender;
use super::obb::{Cuboid, Turn};
use super::triangles::{Triangle, meet};

/// A node: its children at two positions, or if it has a count so many triangles from the first position on.
#[derive(Clone, Copy)]
struct Node {
    cuboid: Cuboid,
    size: f64,
    below: [u32; 2],
    count: u32,
}

/// A tree, the root first, and the corners of the triangles in the order of its leaves.
pub struct Tree {
    nodes: Vec<Node>,
    corners: Vec<Triangle>,
}

/// A triangle as both crates build on it.
struct Leaf {
    corners: Triangle,
    node: usize,
}

impl Leaf {
    fn all(mesh: &Mesh) -> Vec<Self> {
        (0..mesh.triangles().len()).map(|t| Self { corners: mesh.corners(t), node: 0 }).collect()
    }

    fn bounds(&self) -> [[f64; 3]; 2] {
        let bound = |choose: fn(f64, f64) -> f64| {
            let [p, q, r] = &self.corners;
            [0, 1, 2].map(|k| choose(choose(p[k], q[k]), r[k]))
        };
        [bound(f64::min), bound(f64::max)]
    }
}

impl Boundable for Leaf {
    fn aabb(&self) -> obvhs::aabb::Aabb {
        let [low, high] = self.bounds();
        let [low, high] = [low.map(|c| (c as f32).next_down()), high.map(|c| (c as f32).next_up())];
        obvhs::aabb::Aabb::new(Vec3A::from_array(low), Vec3A::from_array(high))
    }
}

impl Bounded<f64, 3> for Leaf {
    fn aabb(&self) -> Aabb<f64, 3> {
        let [low, high] = self.bounds();
        Aabb::with_bounds(Point3::from(low), Point3::from(high))
    }
}

impl BHShape<f64, 3> for Leaf {
    fn set_bh_node_index(&mut self, index: usize) {
        self.node = index;
    }

    fn bh_node_index(&self) -> usize {
        self.node
    }
}

impl Tree {
    /// The binary tree of obvhs.
    pub fn of_obvhs(mesh: &Mesh, params: BvhBuildParams) -> Self {
        let leaves = Leaf::all(mesh);
        let built = build_bvh2(&leaves, params, &mut Duration::default());
        let corners = built.primitive_indices.iter().map(|&t| leaves[t as usize].corners).collect();
        let node = |node: &obvhs::bvh2::node::Bvh2Node| {
            let [low, high] = [node.aabb().min, node.aabb().max].map(|v| v.to_array().map(f64::from));
            let cuboid = Cuboid::between(low, high);
            let first = node.first_index;
            Node { cuboid, size: cuboid.size(), below: [first, first + 1], count: node.prim_count }
        };
        Self { nodes: built.nodes.iter().map(node).collect(), corners }
    }

    /// The tree of the crate bvh: a triangle a leaf.
    pub fn of_bvh(mesh: &Mesh) -> Self {
        let mut leaves = Leaf::all(mesh);
        let built = Bvh::build(&mut leaves);
        let between = |low: [f64; 3], high: [f64; 3], below, count| {
            let cuboid = Cuboid::between(low, high);
            Node { cuboid, size: cuboid.size(), below, count }
        };
        let node = |node: &BvhNode<f64, 3>| match node {
            BvhNode::Leaf { shape_index, .. } => {
                let [low, high] = leaves[*shape_index].bounds();
                between(low, high, [*shape_index as u32; 2], 1)
            }
            BvhNode::Node { child_l_index, child_l_aabb, child_r_index, child_r_aabb, .. } => {
                let low = [0, 1, 2].map(|k| child_l_aabb.min[k].min(child_r_aabb.min[k]));
                let high = [0, 1, 2].map(|k| child_l_aabb.max[k].max(child_r_aabb.max[k]));
                between(low, high, [*child_l_index as u32, *child_r_index as u32], 0)
            }
        };
        let nodes = built.nodes.iter().map(node).collect();
        Self { nodes, corners: leaves.iter().map(|leaf| leaf.corners).collect() }
    }

    /// Calls `visit` for each pair of triangles of the tree and of its copy that meet, until it says that it is done.
    fn descend<const AXES: usize>(&self, turn: &Turn, mut visit: impl FnMut() -> bool) {
        let (Some(root), mut stack) = (self.nodes.first(), Vec::with_capacity(64)) else { return };
        if turn.meet::<AXES>(&root.cuboid, &root.cuboid) {
            stack.push([0, 0]);
        }
        while let Some([i, j]) = stack.pop() {
            let (a, b) = (&self.nodes[i as usize], &self.nodes[j as usize]);
            if a.count > 0 && b.count > 0 {
                if self.leaves_meet(turn, [a, b], &mut visit) {
                    return;
                }
            } else if b.count > 0 || (a.count == 0 && a.size >= b.size) {
                let open = a.below.into_iter().rev();
                stack.extend(
                    open.filter(|&c| turn.meet::<AXES>(&self.nodes[c as usize].cuboid, &b.cuboid)).map(|c| [c, j]),
                );
            } else {
                let open = b.below.into_iter().rev();
                stack.extend(
                    open.filter(|&c| turn.meet::<AXES>(&a.cuboid, &self.nodes[c as usize].cuboid)).map(|c| [i, c]),
                );
            }
        }
    }

    /// Whether the visitor is done after the pairs of two leaves.
    #[inline]
    fn leaves_meet(&self, turn: &Turn, [a, b]: [&Node; 2], visit: &mut impl FnMut() -> bool) -> bool {
        let [rows, columns] = [a, b].map(|leaf| &self.corners[leaf.below[0] as usize..][..leaf.count as usize]);
        columns.iter().any(|column| {
            let moved = column.map(|corner| turn.image(corner));
            rows.iter().any(|row| meet(row, &moved) && visit())
        })
    }
}

/// A tree with the poses of its copy, and the axes of a test of two boxes: those of the faces, 3 or 6, or all 15.
pub struct Paired<const AXES: usize> {
    pub tree: Tree,
    pub turns: Vec<Turn>,
}

impl<const AXES: usize> Paired<AXES> {
    pub fn new(tree: Tree, poses: &[Pose]) -> Self {
        Self { tree, turns: poses.iter().map(Turn::of).collect() }
    }
}

impl<const AXES: usize> Contender for Paired<AXES> {
    fn meets(&self, at: usize) -> anyhow::Result<bool> {
        let mut is_met = false;
        self.tree.descend::<AXES>(&self.turns[at], || {
            is_met = true;
            true
        });
        Ok(is_met)
    }

    fn pairs(&self, at: usize) -> anyhow::Result<Option<usize>> {
        let mut count = 0;
        self.tree.descend::<AXES>(&self.turns[at], || {
            count += 1;
            false
        });
        Ok(Some(count))
    }
}
