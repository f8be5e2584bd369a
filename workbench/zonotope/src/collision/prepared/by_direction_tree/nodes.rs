//! The nodes of the tree: the sum of the generators of each, and the box of their directions.
//!
//! A node holds a run of generators of one face of the cube. With the weights w = v_k > 0 and the places x = v / v_k,
//! each of its generators is w x, and x is in a box around `middle`: so the sign of v · u is the same for all of them
//! where it is the same in the corners of the box. Eight nodes are side by side, as a pass takes generators.

use std::ops::Range;

use super::order::{LEAF, Ordered};
use super::slab::Slab;
use crate::numeric::double_double::DoubleDouble;
use crate::numeric::lanes::blocks::Block;
use crate::numeric::tolerance::UNIT;
use crate::zonotope::directions::cube_faces::place_on;

/// Nodes of a block, the children of one node.
pub(super) const CHILDREN: usize = 8;

/// Eight nodes side by side; what the last block lacks is zero.
#[derive(Debug, Clone)]
pub(super) struct NodeBlock {
    /// Σ v, each coordinate off by at most 2 u times the weight.
    pub(super) sum: Block,
    /// The middle m of the box: it holds all m + t a + s, |t| ≤ 1, each coordinate of s at most that of `half`. It is 1
    /// along the axis of the face.
    pub(super) middle: Block,
    /// The side a, 0 along the axis of the face.
    pub(super) side: Block,
    /// Half the other sides, 0 along the axis of the face.
    pub(super) half: Block,
    /// At least Σ w.
    pub(super) weight: [f64; CHILDREN],
}

/// A node before it is written down.
#[derive(Debug, Clone, Copy)]
pub(super) struct Node {
    face: usize,
    sum: [DoubleDouble; 3],
    places: Slab,
}

impl Node {
    /// A leaf.
    fn of_rows(face: usize, rows: &[[f64; 3]]) -> Self {
        let zero = DoubleDouble::from(0.0);
        let sum = rows.iter().fold([zero; 3], |sum, v| [0, 1, 2].map(|k| sum[k] + DoubleDouble::from(v[k])));
        let mut places = [Slab::default(); LEAF];
        for (place, v) in places.iter_mut().zip(rows) {
            *place = Slab::of_point(place_on(face, v));
        }
        Self { face, sum, places: Slab::around(&places[..rows.len()]) }
    }

    /// The node of some nodes of the same face.
    fn of_nodes(nodes: &[Self]) -> Self {
        let (first, others) = nodes.split_first().expect("a node has a child because it has a generator");
        let sum = others.iter().fold(first.sum, |sum, node| [0, 1, 2].map(|k| sum[k] + node.sum[k]));
        let places: Vec<Slab> = nodes.iter().map(|node| node.places).collect();
        Self { face: first.face, sum, places: Slab::around(&places) }
    }

    /// Σ v, rounded.
    pub(super) fn rounded_sum(&self) -> [f64; 3] {
        self.sum.map(|c| c.high)
    }
}

impl NodeBlock {
    /// Writes down up to eight nodes.
    pub(super) fn of(nodes: &[Node]) -> Self {
        let [mut sums, mut middles, mut sides, mut halves] = [[[0.0; CHILDREN]; 3]; 4];
        let mut weight = [0.0; CHILDREN];
        for (lane, Node { face, sum, places }) in nodes.iter().enumerate() {
            for (column, c) in sums.iter_mut().zip(sum) {
                column[lane] = c.high;
            }
            middles[*face][lane] = 1.0;
            for k in 0..2 {
                let axis = (face + 1 + k) % 3;
                middles[axis][lane] = places.middle[k];
                sides[axis][lane] = places.side[k];
                halves[axis][lane] = places.half[k];
            }
            weight[lane] = sum[*face].high * (1.0 + 4.0 * UNIT);
        }
        let [sum, middle, side, half] = [sums, middles, sides, halves].map(Block::of_columns);
        Self { sum, middle, side, half, weight }
    }

    /// The width of a node: its weight times the side and times half the other sides.
    pub(super) fn width(&self, lane: usize) -> [[f64; 3]; 2] {
        [&self.side, &self.half].map(|block| block.vector(lane).map(|c| c * self.weight[lane]))
    }
}

/// The nodes over the generators of one face, level by level: a node of level l holds LEAF · 8^l generators.
#[derive(Debug)]
pub(super) struct Face {
    pub(super) rows: Range<usize>,
    /// The leaves first; the last level has one block. No level where the face has no generator.
    pub(super) levels: Vec<Vec<NodeBlock>>,
}

impl Face {
    pub(super) fn new(rows: Range<usize>, leaves: &[Node]) -> Self {
        let (mut levels, mut nodes) = (Vec::new(), leaves.to_vec());
        while !nodes.is_empty() {
            let blocks: Vec<NodeBlock> = nodes.chunks(CHILDREN).map(NodeBlock::of).collect();
            let is_last = blocks.len() == 1;
            levels.push(blocks);
            nodes = if is_last { Vec::new() } else { nodes.chunks(CHILDREN).map(Node::of_nodes).collect() };
        }
        Self { rows, levels }
    }

    /// Bytes held.
    pub(super) fn bytes(&self) -> usize {
        self.levels.iter().map(|blocks| size_of_val(&blocks[..])).sum()
    }

    /// A bit for each node of a block.
    pub(super) fn nodes_in(&self, level: usize, block: usize) -> u64 {
        let count = self.rows.len().div_ceil(LEAF << (3 * level)) - CHILDREN * block;
        u64::MAX >> (u64::BITS as usize - count.min(CHILDREN))
    }

    /// The number of leaves.
    pub(super) fn leaves(&self) -> usize {
        self.rows.len().div_ceil(LEAF)
    }

    /// Adds the rows of some leaves of a block to a list of ranges, each joined to the one before where it follows it.
    pub(super) fn push_leaves(&self, block: usize, mut lanes: u64, ranges: &mut Vec<Range<usize>>) {
        while lanes != 0 {
            let own = self.leaf(CHILDREN * block + lanes.trailing_zeros() as usize);
            match ranges.last_mut() {
                Some(last) if last.end == own.start => last.end = own.end,
                _ => ranges.push(own),
            }
            lanes &= lanes - 1;
        }
    }

    /// The rows of a leaf.
    pub(super) fn leaf(&self, leaf: usize) -> Range<usize> {
        let start = self.rows.start + LEAF * leaf;
        start..self.rows.end.min(start + LEAF)
    }
}

/// The leaves of each face.
pub(super) fn leaves(ordered: &Ordered) -> [Vec<Node>; 3] {
    [0, 1, 2].map(|face| {
        let rows = &ordered.rows[ordered.faces[face].clone()];
        rows.chunks(LEAF).map(|rows| Node::of_rows(face, rows)).collect()
    })
}

/// Nodes of one size that stand for all generators: a body within the body, and a bound of the body from outside.
#[derive(Debug)]
pub(super) struct Front {
    /// The nodes; blocks of one face each.
    pub(super) blocks: Vec<NodeBlock>,
    /// The sums of the nodes, in the order of their generators.
    pub(super) sums: Vec<[f64; 3]>,
    /// The rows of each.
    pub(super) rows: Vec<Range<usize>>,
    /// The level whose nodes are as large, or the next one above.
    pub(super) level: usize,
    /// The width of each.
    pub(super) widths: Vec<[[f64; 3]; 2]>,
}

impl Front {
    /// Bytes held.
    pub(super) fn bytes(&self) -> usize {
        size_of_val(&self.blocks[..])
            + size_of_val(&self.sums[..])
            + size_of_val(&self.rows[..])
            + size_of_val(&self.widths[..])
    }

    /// The nodes of the least size of which there are at most `limit`, or one for each face.
    pub(super) fn new(ordered: &Ordered, leaves: &[Vec<Node>; 3], limit: usize) -> Self {
        let count = |size: usize| leaves.iter().map(|own| own.len().div_ceil(size)).sum::<usize>();
        let mut size = 1;
        while count(size) > limit.max(3) {
            size *= 2;
        }
        let level = size.ilog2().div_ceil(CHILDREN.ilog2()) as usize;
        let mut front = Self { blocks: Vec::new(), sums: Vec::new(), rows: Vec::new(), level, widths: Vec::new() };
        for (face, own) in leaves.iter().enumerate() {
            let nodes: Vec<Node> = own.chunks(size).map(Node::of_nodes).collect();
            front.sums.extend(nodes.iter().map(Node::rounded_sum));
            let all = &ordered.faces[face];
            let run = LEAF * size;
            front.rows.extend((0..nodes.len()).map(|i| {
                let start = all.start + run * i;
                start..all.end.min(start + run)
            }));
            let blocks = nodes.chunks(CHILDREN).map(|nodes| (NodeBlock::of(nodes), nodes.len()));
            for (block, count) in blocks {
                front.widths.extend((0..count).map(|lane| block.width(lane)));
                front.blocks.push(block);
            }
        }
        front
    }
}
