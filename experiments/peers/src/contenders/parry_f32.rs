//! The crate `parry3d`, the build in single precision that most of its users have: GJK on a support map.
//!
//! The support map is the best that we know to give it: generators in blocks of sixteen floats, one pass with the
//! widest vectors, partial sums of a few hundred blocks joined in doubles. Both bodies and the offset between them are
//! scaled by one power of two to magnitude about 1 and then rounded to floats, so no coordinate leaves their range.
//!
//! The question is the one that all contenders get, about bodies in doubles. A float keeps 24 bits, so where the bodies
//! are nearer to contact than about 1e-7 of their size, the rounded bodies may truly meet where the bodies do not. Such
//! an answer counts as wrong: the user of the method asked about the bodies.

use super::{Answer, Contender, Work};
use experiments::question::Question;
use fearless_simd::{Level, Simd, dispatch, f32x16, prelude::*, u32x16};
use parry3d::math::{Pose, Vector};
use parry3d::query::details::intersection_test_support_map_support_map;
use parry3d::shape::SupportMap;
use zonotope::numeric::scaling::{binary_exponent, scale_by_power_of_two};

/// GJK in single precision on two zonotopes through their support maps, for which their generators are laid out
/// beforehand.
pub const GJK: Contender = Contender { id: "parry_f32_gjk", largest: usize::MAX, prepare: gjk };

/// Generators side by side.
const LANES: usize = 16;

/// Blocks whose sums are joined in floats.
const BLOCKS_OF_A_SUM: usize = 256;

/// Sixteen generators, one coordinate after the other.
#[derive(Clone, Copy)]
#[repr(align(64))]
struct Block([[f32; LANES]; 3]);

/// A zonotope around the origin.
struct Body {
    blocks: Vec<Block>,
    /// The vectors of the machine.
    level: Level,
}

impl Body {
    /// The generators times a power of two, rounded; what the last block lacks is zero.
    fn new(generators: &[[f64; 3]], exponent: i64) -> Self {
        let block = |generators: &[[f64; 3]]| {
            let mut block = Block([[0.0; LANES]; 3]);
            for (lane, generator) in generators.iter().enumerate() {
                for (column, &c) in block.0.iter_mut().zip(generator) {
                    column[lane] = scale_by_power_of_two(c, exponent) as f32;
                }
            }
            block
        };
        Self { blocks: generators.chunks(LANES).map(block).collect(), level: Level::new() }
    }
}

impl SupportMap for Body {
    fn local_support_point(&self, direction: Vector) -> Vector {
        let direction = direction.to_array();
        let mut sum = [0.0; 3];
        for blocks in self.blocks.chunks(BLOCKS_OF_A_SUM) {
            let part = dispatch!(self.level, simd => extreme_sum(simd, blocks, direction));
            sum = [0, 1, 2].map(|axis| sum[axis] + part[axis]);
        }
        Vector::from_array(sum.map(|c| c as f32))
    }
}

/// Σ ± g with the signs of g · direction.
#[inline(always)]
fn extreme_sum<S: Simd>(simd: S, blocks: &[Block], direction: [f32; 3]) -> [f64; 3] {
    let zero = f32x16::splat(simd, 0.0);
    let sign_bit = u32x16::splat(simd, 1 << 31);
    let u = [f32x16::splat(simd, direction[0]), f32x16::splat(simd, direction[1]), f32x16::splat(simd, direction[2])];
    let mut sums = [zero; 3];
    for Block([x, y, z]) in blocks {
        let v = [f32x16::from_slice(simd, x), f32x16::from_slice(simd, y), f32x16::from_slice(simd, z)];
        let value = zero + (v[0] * u[0] + v[1] * u[1] + v[2] * u[2]);
        let sign = value.bitcast::<u32x16<S>>() & sign_bit;
        for axis in 0..3 {
            sums[axis] += (v[axis].bitcast::<u32x16<S>>() ^ sign).bitcast::<f32x16<S>>();
        }
    }
    let mut totals = [0.0; 3];
    for (total, lanes) in totals.iter_mut().zip(sums) {
        let mut floats = [0.0; LANES];
        lanes.store_slice(&mut floats);
        *total = floats.into_iter().map(f64::from).sum();
    }
    totals
}

fn gjk(question: &Question) -> Option<Work<'_>> {
    let bodies = question.bodies();
    let offset: [f64; 3] = std::array::from_fn(|i| question.to[i] - question.from[i]);
    let coordinates = bodies.iter().flat_map(|body| body.generators().as_flattened()).chain(&offset);
    let largest = coordinates.fold(0.0f64, |largest, c| largest.max(c.abs()));
    let exponent = -binary_exponent(largest).map_or(0, i64::from);
    let [a, b] = bodies.map(|body| Body::new(body.generators(), exponent));
    let pose = Pose::from_translation(Vector::from_array(offset.map(|c| scale_by_power_of_two(c, exponent) as f32)));
    Some(Box::new(move || Answer::Member(intersection_test_support_map_support_map(&pose, &a, &b))))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_support_point_is_extreme() {
        // more generators than a block has, with sums that floats hold
        let generators: Vec<[f64; 3]> = (0..600).map(|i| [f64::from(i % 7) - 3.0, f64::from(i % 5), -1.0]).collect();
        let support = |u: [f32; 3]| Body::new(&generators, 0).local_support_point(Vector::from_array(u)).to_array();
        let truth = |u: [f64; 3]| {
            generators.iter().fold([0.0; 3], |sum, g| {
                let sign = if g[0] * u[0] + g[1] * u[1] + g[2] * u[2] < 0.0 { -1.0 } else { 1.0 };
                [0, 1, 2].map(|axis| sum[axis] + sign * g[axis])
            })
        };
        for u in [[1.0, 0.5, 0.25], [-1.0, 3.0, 8.0], [0.125, 0.0, 0.0]] {
            assert_eq!(support(u.map(|c: f64| c as f32)).map(f64::from), truth(u));
        }
    }
}
