//! Facet normals of directions, and how far points reach along them.

use fearless_simd::{Simd, dispatch};

use crate::numeric::lanes::level::level_for_few;
use crate::numeric::linear::{cross, dot, euclidean_norm};

/// The unit normal of a pair of directions.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Normal {
    pub(super) unit: [f64; 3],
    /// The positions of both directions.
    pub(super) pair: [usize; 2],
    /// The length of their cross product.
    pub(super) sine: f64,
}

/// The normals of all pairs of directions, none of which are parallel.
pub(super) fn normals_of_pairs(directions: &[[f64; 3]]) -> Vec<Normal> {
    let pairs = (0..directions.len()).flat_map(|j| (0..j).map(move |i| [i, j]));
    let normal = |pair: [usize; 2]| {
        let normal = cross(&directions[pair[0]], &directions[pair[1]]);
        let sine = euclidean_norm(&normal);
        Normal { unit: normal.map(|c| c / sine), pair, sine }
    };
    pairs.map(normal).collect()
}

/// The least and the largest height of points along each normal.
pub(super) fn heights(points: &[[f64; 3]], normals: &[Normal]) -> Vec<[f64; 2]> {
    let mut found = vec![[f64::INFINITY, f64::NEG_INFINITY]; normals.len()];
    dispatch!(level_for_few(), simd => heights_in_lanes(simd, points, normals, &mut found));
    found
}

#[inline(always)]
fn heights_in_lanes<S: Simd>(_simd: S, points: &[[f64; 3]], normals: &[Normal], found: &mut [[f64; 2]]) {
    for (normal, [low, high]) in normals.iter().zip(found) {
        for point in points {
            let height = dot(point, &normal.unit);
            *low = if height < *low { height } else { *low };
            *high = if height > *high { height } else { *high };
        }
    }
}
