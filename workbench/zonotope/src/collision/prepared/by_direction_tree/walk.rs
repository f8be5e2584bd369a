//! The walk over the nodes that a cell of directions crosses.
//!
//! A node whose generators are orthogonal to no direction of the cell counts with its sum and one sign; only the others
//! are opened. The walk goes from the root of each face to the level that is asked for, in the order of the generators.

use fearless_simd::{Simd, dispatch, f64x8, prelude::*};
use smallvec::SmallVec;

use super::nodes::{CHILDREN, Face, NodeBlock};
use crate::lad::of_generators::seam::direction_cone::DirectionCone;
use crate::numeric::lanes::level::level;
use crate::numeric::lanes::number::product;
use crate::numeric::lanes::octet::{Octet, splat, totals, turned};
use crate::numeric::linear::euclidean_norm;
use crate::numeric::tolerance::{CONE_ROUNDING, PRODUCT_UNDERFLOW, THIRTY_ROUNDINGS};

/// The length of a place on a face of the cube is at most √3; the rest covers the roundings of the products.
const LARGEST_PLACE: f64 = 2.0;

/// Nodes of one block, a bit for each.
#[derive(Debug, Clone, Copy)]
pub(super) struct Nodes {
    pub(super) face: usize,
    pub(super) level: usize,
    pub(super) block: usize,
    pub(super) lanes: u64,
}

/// The function that is given the nodes on the way.
pub(super) trait Visitor {
    /// Nodes that no plane of the cell cuts, with a bit for each whose products with the cell are negative.
    #[inline(always)]
    fn missed(&mut self, _: Nodes, _negative: u64) {}

    /// Nodes of the last level that the cell crosses, in the order of their generators.
    fn crossed(&mut self, nodes: Nodes);
}

/// The outcome of a walk.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Walked {
    /// Σ sign · sum over the nodes that do not cross the cell.
    pub(super) sum: [f64; 3],
    /// The number of nodes that were looked at.
    pub(super) read: usize,
}

/// A block of nodes that waits for its turn.
#[derive(Debug, Clone, Copy)]
struct Waiting {
    face: usize,
    level: usize,
    block: usize,
}

/// Walks to a level, or to the last level of a face that has fewer.
pub(super) fn walk(faces: &[Face; 3], cell: &DirectionCone, to: usize, visitor: &mut impl Visitor) -> Walked {
    match cell.axes {
        None => {
            let cone = WideCone::<0>::new(cell, []);
            dispatch!(level(), simd => walk_at(simd, faces, &cone, to, visitor))
        }
        Some(axes) => {
            let cone = WideCone::<2>::new(cell, axes);
            dispatch!(level(), simd => walk_at(simd, faces, &cone, to, visitor))
        }
    }
}

/// A cell for boxes of places, widened by what rounding may take off the products with it.
struct WideCone<const AXES: usize> {
    center: [f64; 3],
    axes: [[f64; 3]; AXES],
    ball: f64,
}

impl<const AXES: usize> WideCone<AXES> {
    /// A product of a place, of the side or of the half sides with a vector goes through three roundings of at most √3
    /// u times the vector's length each, and there are three products for each vector of the cell: less than 32 u in
    /// all.
    fn new(cell: &DirectionCone, axes: [[f64; 3]; AXES]) -> Self {
        let size = euclidean_norm(&cell.center) + axes.iter().map(euclidean_norm).sum::<f64>() + cell.ball;
        let ball = LARGEST_PLACE * (cell.ball + 4.0 * CONE_ROUNDING * size) * THIRTY_ROUNDINGS + PRODUCT_UNDERFLOW;
        Self { center: cell.center, axes, ball }
    }
}

/// The cone in all lanes.
struct Splat<S: Simd, const AXES: usize> {
    center: Octet<S>,
    sizes: Octet<S>,
    axes: [Octet<S>; AXES],
    axis_sizes: [Octet<S>; AXES],
    ball: f64,
}

impl<S: Simd, const AXES: usize> Splat<S, AXES> {
    #[inline(always)]
    fn new(simd: S, cone: &WideCone<AXES>) -> Self {
        let center = splat(simd, &cone.center);
        let mut axes = [center; AXES];
        for (own, axis) in axes.iter_mut().zip(&cone.axes) {
            *own = splat(simd, axis);
        }
        let mut axis_sizes = axes;
        for own in &mut axis_sizes {
            *own = [own[0].abs(), own[1].abs(), own[2].abs()];
        }
        let sizes = [center[0].abs(), center[1].abs(), center[2].abs()];
        Self { center, sizes, axes, axis_sizes, ball: cone.ball }
    }
}

/// Sums with what rounding leaves behind.
struct Sums<S: Simd> {
    total: Octet<S>,
    rest: Octet<S>,
}

impl<S: Simd> Sums<S> {
    /// Adds the sums of the nodes that miss the cone, and returns a bit for each of these and for each whose
    /// value is negative.
    ///
    /// With m the middle, d the side and s the other half sides of a box, a product of any of its places with a
    /// direction c + x a + y b of the cone differs from m · c by at most |d · c| + s · |c| + √(A² + B²), A = |m · a| +
    /// |d · a| + s · |a|.
    #[inline(always)]
    fn read<const AXES: usize>(&mut self, simd: S, cone: &Splat<S, AXES>, block: &NodeBlock) -> (u64, u64) {
        let (middle, side, half) = (block.middle.load(simd), block.side.load(simd), block.half.load(simd));
        let value = product(&middle, &cone.center);
        let mut reach = product(&side, &cone.center).abs() + product(&half, &cone.sizes) + cone.ball;
        let mut squares = f64x8::splat(simd, 0.0);
        for (axis, sizes) in cone.axes.iter().zip(&cone.axis_sizes) {
            let along = product(&middle, axis).abs() + product(&side, axis).abs() + product(&half, sizes);
            squares += along * along;
        }
        if AXES > 0 {
            // the root is rounded, and so is what it is taken of
            reach += squares.sqrt() * THIRTY_ROUNDINGS;
        }
        let misses = value.abs().simd_gt(reach);
        let sum = block.sum.load(simd);
        for k in 0..3 {
            let (a, b) = (self.total[k], misses.select(turned(simd, sum[k], value), f64x8::splat(simd, 0.0)));
            let sum = a + b;
            let b_in_sum = sum - a;
            self.rest[k] += (a - (sum - b_in_sum)) + (b - b_in_sum);
            self.total[k] = sum;
        }
        (misses.to_bitmask(), value.simd_lt(0.0).to_bitmask())
    }
}

#[inline(always)]
fn walk_at<S: Simd, const AXES: usize>(
    simd: S,
    faces: &[Face; 3],
    cone: &WideCone<AXES>,
    to: usize,
    visitor: &mut impl Visitor,
) -> Walked {
    let cone = Splat::new(simd, cone);
    let zero = f64x8::splat(simd, 0.0);
    let mut sums = Sums { total: [zero; 3], rest: [zero; 3] };
    let mut waiting: SmallVec<[Waiting; 64]> = SmallVec::new();
    let mut read = 0;
    for (number, face) in faces.iter().enumerate().rev() {
        if let Some(level) = face.levels.len().checked_sub(1) {
            waiting.push(Waiting { face: number, level, block: 0 });
        }
    }
    while let Some(Waiting { face, level, block }) = waiting.pop() {
        let own = &faces[face];
        let (misses, negative) = sums.read(simd, &cone, &own.levels[level][block]);
        read += CHILDREN;
        let all = own.nodes_in(level, block);
        visitor.missed(Nodes { face, level, block, lanes: all & misses }, negative);
        let mut crossing = all & !misses;
        if level <= to {
            visitor.crossed(Nodes { face, level, block, lanes: crossing });
            continue;
        }
        while crossing != 0 {
            let last = (u64::BITS - 1 - crossing.leading_zeros()) as usize;
            waiting.push(Waiting { face, level: level - 1, block: CHILDREN * block + last });
            crossing ^= 1 << last;
        }
    }
    let sum = totals(&[sums.total[0] + sums.rest[0], sums.total[1] + sums.rest[1], sums.total[2] + sums.rest[2]]);
    Walked { sum, read }
}
