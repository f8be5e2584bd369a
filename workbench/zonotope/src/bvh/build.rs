//! The topology of a hierarchy: a binary tree over triangles by the surface area heuristic, the same for all volumes.
//!
//! A node is split where the expected cost, the surfaces of both boxes times the triangles in them, is least among the
//! planes of `BINS` bins along each axis (MacDonald and Booth 1990; bins after Wald 2007).

use super::volume::BoundingVolume;
use super::volumes::aabb::Aabb;

/// Bins along an axis.
const BINS: usize = 16;

/// Below this depth triangles are halved in the order in which they lie, so that no tree is deeper than that and the
/// logarithm of the number of triangles.
const DEPTH_LIMIT: usize = 48;

/// Bounds and effort of a build.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct BuildOptions {
    /// The most triangles of a leaf, at least 1.
    pub leaf_triangles: usize,
    /// Changes that are tried for each volume after its first fit.
    pub effort: usize,
}

impl Default for BuildOptions {
    /// Leaves of at most two triangles, and the quickest fit.
    fn default() -> Self {
        Self { leaf_triangles: 2, effort: 0 }
    }
}

/// A node of the tree: the triangles below it, which stand together in the order, and its children.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Node {
    first: u32,
    count: u32,
    /// The right child; the left one is the next node. 0 for a leaf, since the root is no child.
    right: u32,
}

impl Node {
    /// The positions in the order of the triangles below.
    pub fn range(&self) -> std::ops::Range<usize> {
        self.first as usize..(self.first + self.count) as usize
    }

    /// The children of a node at a position; none of a leaf.
    #[inline]
    pub fn children(&self, at: usize) -> Option<[usize; 2]> {
        (self.right != 0).then(|| [at + 1, self.right as usize])
    }
}

/// The nodes in depth-first order, the root first, and the order of the triangles.
#[derive(Debug, Clone, PartialEq)]
pub struct Topology {
    pub(super) nodes: Vec<Node>,
    pub(super) order: Vec<u32>,
}

impl Topology {
    /// The nodes in depth-first order, the root first.
    pub fn nodes(&self) -> &[Node] {
        &self.nodes
    }

    /// The triangles in the order in which those below a node stand together.
    pub fn order(&self) -> &[u32] {
        &self.order
    }

    /// The nodes of a level, from left to right: those that many steps below the root, and the leaves above them.
    pub fn level(&self, depth: usize) -> Vec<usize> {
        let mut level = vec![0];
        for _ in 0..depth {
            let count = level.len();
            let below = |at: usize| self.nodes[at].children(at).map_or_else(|| vec![at], Vec::from);
            level = level.into_iter().flat_map(below).collect();
            // leaves alone have nothing below them
            if level.len() == count {
                break;
            }
        }
        level
    }
}

/// A triangle as the builder sees it.
#[derive(Debug, Clone, Copy)]
struct Item {
    triangle: u32,
    corners: [[f64; 3]; 3],
    middle: [f64; 3],
}

/// The topology over triangles.
pub(super) fn topology(points: &[[f64; 3]], triangles: &[[u32; 3]], leaf_triangles: usize) -> Topology {
    let item = |(triangle, corners): (u32, &[u32; 3])| {
        let corners = corners.map(|corner| points[corner as usize]);
        let middle = std::array::from_fn(|k| (corners[0][k] + corners[1][k] + corners[2][k]) / 3.0);
        Item { triangle, corners, middle }
    };
    let mut items: Vec<Item> = (0..).zip(triangles).map(item).collect();
    let mut nodes = Vec::with_capacity(2 * items.len() / leaf_triangles.max(1) + 1);
    split(&mut items, 0, 0, leaf_triangles.max(1), &mut nodes);
    Topology { nodes, order: items.iter().map(|item| item.triangle).collect() }
}

/// Adds the nodes over some of the triangles.
fn split(items: &mut [Item], first: u32, depth: usize, leaf_triangles: usize, nodes: &mut Vec<Node>) {
    let at = nodes.len();
    let count = items.len() as u32;
    nodes.push(Node { first, count, right: 0 });
    if items.len() <= leaf_triangles {
        return;
    }
    let middle = if depth < DEPTH_LIMIT { partition(items) } else { None }.unwrap_or(items.len() / 2);
    let (left, right) = items.split_at_mut(middle);
    split(left, first, depth + 1, leaf_triangles, nodes);
    nodes[at].right = nodes.len() as u32;
    split(right, first + middle as u32, depth + 1, leaf_triangles, nodes);
}

/// A box that grows, with the number of triangles in it.
#[derive(Debug, Clone, Copy)]
struct Bin {
    low: [f64; 3],
    high: [f64; 3],
    count: usize,
}

impl Bin {
    const EMPTY: Self = Self { low: [f64::INFINITY; 3], high: [f64::NEG_INFINITY; 3], count: 0 };

    fn add(&mut self, low: &[f64; 3], high: &[f64; 3], count: usize) {
        for k in 0..3 {
            self.low[k] = self.low[k].min(low[k]);
            self.high[k] = self.high[k].max(high[k]);
        }
        self.count += count;
    }

    fn cost(&self) -> f64 {
        let [a, b, c] = [0, 1, 2].map(|k| self.high[k] - self.low[k]);
        if self.count == 0 { 0.0 } else { (a * b + b * c + c * a) * self.count as f64 }
    }
}

/// Reorders triangles so that those on one side of the best plane come first, and says how many they are; `None` where
/// no plane has triangles on both sides.
fn partition(items: &mut [Item]) -> Option<usize> {
    let middles = items.iter().fold(Bin::EMPTY, |mut all, item| {
        all.add(&item.middle, &item.middle, 1);
        all
    });
    let bin_of = |item: &Item, axis: usize| {
        let share = (item.middle[axis] - middles.low[axis]) / (middles.high[axis] - middles.low[axis]);
        ((share * BINS as f64) as usize).min(BINS - 1)
    };
    let mut bins = [[Bin::EMPTY; BINS]; 3];
    for item in items.iter() {
        let bounds = Aabb::around(&item.corners, 0);
        for (axis, bins) in bins.iter_mut().enumerate() {
            bins[bin_of(item, axis)].add(&bounds.low(), &bounds.high(), 1);
        }
    }
    let mut best: Option<(f64, usize, usize)> = None;
    for (axis, bins) in bins.iter().enumerate() {
        let mut of_right = [0.0; BINS];
        let mut right = Bin::EMPTY;
        for (cost, bin) in of_right.iter_mut().zip(bins).rev() {
            right.add(&bin.low, &bin.high, bin.count);
            *cost = right.cost();
        }
        let mut left = Bin::EMPTY;
        for plane in 1..BINS {
            let bin = &bins[plane - 1];
            left.add(&bin.low, &bin.high, bin.count);
            let cost = left.cost() + of_right[plane];
            if left.count > 0 && left.count < items.len() && best.is_none_or(|(least, ..)| cost < least) {
                best = Some((cost, axis, plane));
            }
        }
    }
    let (_, axis, plane) = best?;
    // stable, so that the order of triangles does not depend on a sort's choices
    items.sort_by_key(|item| bin_of(item, axis) >= plane);
    Some(items.partition_point(|item| bin_of(item, axis) < plane))
}
