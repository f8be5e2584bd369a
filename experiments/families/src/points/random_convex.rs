//! Uniformly random convex polygons, by Valtr's algorithm, on a grid of step 2^-51 so that every vertex is exact.
//!
//! 1. n sorted random integers are split into two chains from the smallest to the largest: their steps, one chain
//!    forwards and the other backwards, are n signed integers of sum 0. Likewise for the other coordinate.
//! 2. The two lists are paired at random into n edge vectors and sorted by direction, exactly.
//! 3. The partial sums of the edge vectors are the vertices of a convex polygon.
//!
//! Source: P. Valtr, Probability that n random points are in convex position, Discrete & Computational Geometry 13
//! (1995).

use super::family::{Family, HullSize};
use crate::source::RandomSource;
use std::cmp::Ordering;

/// Coordinates are integers below 2^51, so that partial sums of either sign are exact in a double.
const COORDINATE_BITS: u32 = 51;

/// Vertices of a random convex polygon.
pub const RANDOM_CONVEX: Family = Family {
    id: "random_convex",
    title: "Random convex polygon",
    description: "vertices of a random convex polygon (Valtr's algorithm) on a grid of step 2^-51, in random order",
    hull_size: HullSize::NearlyAll,
    is_random: true,
    generate: points,
};

fn points(n: usize, seed: u64) -> Vec<[f64; 2]> {
    let mut source = RandomSource::new(seed);
    let steps_x = closed_steps(n, &mut source);
    let mut steps_y = closed_steps(n, &mut source);
    source.shuffle(&mut steps_y);
    let mut edges: Vec<[i64; 2]> = steps_x.into_iter().zip(steps_y).map(|(x, y)| [x, y]).collect();
    edges.sort_by(by_direction);

    let unit = 1.0 / (1_u64 << COORDINATE_BITS) as f64;
    let mut corner = [0_i64, 0];
    let mut vertices: Vec<[f64; 2]> = edges
        .iter()
        .map(|&[x, y]| {
            corner = [corner[0] + x, corner[1] + y];
            [corner[0] as f64 * unit, corner[1] as f64 * unit]
        })
        .collect();
    source.shuffle(&mut vertices);
    vertices
}

/// `n` random integers of sum 0, whose positive part sums to less than 2^51.
fn closed_steps(n: usize, source: &mut RandomSource) -> Vec<i64> {
    let mut values: Vec<i64> = (0..n).map(|_| (source.bits() >> (64 - COORDINATE_BITS)) as i64).collect();
    values.sort_unstable();
    let (Some(&smallest), Some(&largest)) = (values.first(), values.last()) else {
        return Vec::new();
    };
    let mut ends = [smallest, smallest];
    let mut steps = Vec::with_capacity(n);
    for &value in &values[1..] {
        let chain = (source.bits() >> 63) as usize;
        let step = value - ends[chain];
        steps.push(if chain == 0 { step } else { -step });
        ends[chain] = value;
    }
    // Both chains end at the largest value; the chain that already does has a last step of 0.
    steps.push(if ends[0] == largest { ends[1] - largest } else { largest - ends[0] });
    steps
}

/// Counter-clockwise order of directions from the positive x axis; the zero vector comes first, parallel vectors tie.
fn by_direction(a: &[i64; 2], b: &[i64; 2]) -> Ordering {
    sector(a).cmp(&sector(b)).then_with(|| {
        let cross = i128::from(a[0]) * i128::from(b[1]) - i128::from(a[1]) * i128::from(b[0]);
        0.cmp(&cross)
    })
}

/// 0 for the zero vector, 1 for angles in [0, pi), 2 for angles in [pi, 2 pi).
fn sector(v: &[i64; 2]) -> u8 {
    match (v[0].signum(), v[1].signum()) {
        (0, 0) => 0,
        (_, 1) | (1, 0) => 1,
        _ => 2,
    }
}
