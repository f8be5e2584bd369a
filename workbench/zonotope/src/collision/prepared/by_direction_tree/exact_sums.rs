//! The sums of the nodes without any rounding, as integers times one power of two: what makes exact support values, and
//! exact decisions at contact, cost O(√n) on random bodies.
//!
//! They exist where the last bit of the smallest coordinate and the sum of the largest fit into 127 bits: bodies whose
//! coordinates are less than some fifty powers of two apart.

use super::nodes::{CHILDREN, Face};
use super::walk::{Nodes, Visitor, walk};
use crate::lad::of_generators::seam::direction_cone::DirectionCone;
use crate::lad::of_generators::seam::sign_pass::Places;
use crate::numeric::dyadic::Dyadic;
use crate::numeric::exact_linear::ExactVector;
use crate::numeric::lanes::rows::Rows;
use crate::numeric::scaling::decompose;

/// Bits of a sum, without its sign.
const LONGEST_SUM: i64 = 126;

/// A vector of integers.
type Whole = [i128; 3];

/// The sums of the nodes of each face, level by level.
#[derive(Debug)]
pub(super) struct ExactSums {
    exponent: i32,
    levels: [Vec<Vec<Whole>>; 3],
}

impl ExactSums {
    /// The sums; none where they are too long. O(n).
    pub(super) fn new(rows: &[[f64; 3]], faces: &[Face; 3]) -> Option<Self> {
        let (mut low, mut high) = (i32::MAX, i32::MIN);
        for &c in rows.as_flattened().iter().filter(|c| **c != 0.0) {
            let (mantissa, exponent) = decompose(c);
            low = low.min(exponent + mantissa.trailing_zeros() as i32);
            high = high.max(exponent + i64::BITS as i32 - mantissa.unsigned_abs().leading_zeros() as i32);
        }
        let digits = i64::from(high) - i64::from(low) + i64::from(usize::BITS - rows.len().leading_zeros());
        if low > high || digits > LONGEST_SUM {
            return None;
        }
        let levels = faces.each_ref().map(|face| {
            let leaf = |leaf: usize| total(rows[face.leaf(leaf)].iter().map(|v| whole(v, low)));
            let mut levels: Vec<Vec<Whole>> = Vec::new();
            for blocks in &face.levels {
                let sums = match levels.last() {
                    None => (0..face.leaves()).map(leaf).collect(),
                    Some(below) => below.chunks(CHILDREN).map(|own| total(own.iter().copied())).collect(),
                };
                assert!(blocks.len() == Vec::len(&sums).div_ceil(CHILDREN), "a sum for each node");
                levels.push(sums);
            }
            levels
        });
        Some(Self { exponent: low, levels })
    }

    /// Bytes held.
    pub(super) fn bytes(&self) -> usize {
        self.levels.iter().flatten().map(|sums| size_of_val(&sums[..])).sum()
    }

    /// Σ sign · v with the signs of the products with all directions of a cell, but for the generators of which the
    /// cell does not tell: their places are added to a list.
    pub(super) fn signed_sum(
        &self,
        rows: &[[f64; 3]],
        faces: &[Face; 3],
        cell: &DirectionCone,
        doubtful: &mut Places,
    ) -> ExactVector {
        let mut visit = Visit { sums: self, faces, total: [0; 3], leaves: Vec::new() };
        walk(faces, cell, 0, &mut visit);
        let Visit { mut total, leaves, .. } = visit;
        cell.split_ranges(Rows::new(rows), &leaves, doubtful);
        let mut others = doubtful.iter().map(|&place| place as usize).peekable();
        for place in leaves.into_iter().flatten() {
            if others.next_if_eq(&place).is_some() {
                continue;
            }
            let (v, is_minus) = (whole(&rows[place], self.exponent), cell.value(&rows[place]) < 0.0);
            add(&mut total, &v, is_minus);
        }
        total.map(|c| Dyadic::new(c.into(), i64::from(self.exponent)))
    }
}

/// A walk that sums up exactly.
struct Visit<'a> {
    sums: &'a ExactSums,
    faces: &'a [Face; 3],
    total: Whole,
    leaves: Vec<std::ops::Range<usize>>,
}

impl Visitor for Visit<'_> {
    fn missed(&mut self, Nodes { face, level, block, mut lanes }: Nodes, negative: u64) {
        let own = &self.sums.levels[face][level][CHILDREN * block..];
        while lanes != 0 {
            let lane = lanes.trailing_zeros() as usize;
            add(&mut self.total, &own[lane], negative >> lane & 1 == 1);
            lanes &= lanes - 1;
        }
    }

    fn crossed(&mut self, nodes: Nodes) {
        self.faces[nodes.face].push_leaves(nodes.block, nodes.lanes, &mut self.leaves);
    }
}

fn add(total: &mut Whole, v: &Whole, is_minus: bool) {
    for (sum, c) in total.iter_mut().zip(v) {
        *sum += if is_minus { -c } else { *c };
    }
}

fn total(vectors: impl Iterator<Item = Whole>) -> Whole {
    vectors.fold([0; 3], |mut sum, v| {
        add(&mut sum, &v, false);
        sum
    })
}

/// A vector in units of 2^`exponent`, of which all coordinates are multiples.
fn whole(v: &[f64; 3], exponent: i32) -> Whole {
    v.map(|c| {
        let (mantissa, own) = decompose(c);
        let mantissa = i128::from(mantissa);
        if mantissa == 0 {
            0
        } else if own >= exponent {
            mantissa << (own - exponent)
        } else {
            mantissa >> (exponent - own)
        }
    })
}
