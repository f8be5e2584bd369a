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

/// Normals whose heights one pass over the points measures.
const SIDE_BY_SIDE: usize = 8;

/// The least and the largest height of points along each normal.
pub(super) fn heights(points: &[[f64; 3]], normals: &[Normal]) -> Vec<[f64; 2]> {
    let mut found = Vec::with_capacity(normals.len() + SIDE_BY_SIDE);
    for some in normals.chunks(SIDE_BY_SIDE) {
        // what is left of a pass repeats the last normal
        let units: [[f64; 3]; SIDE_BY_SIDE] = std::array::from_fn(|k| some[k.min(some.len() - 1)].unit);
        found.extend(reaches(points, &units));
    }
    found.truncate(normals.len());
    found
}

/// The least and the largest height of points along each of some directions, by one pass over the points.
pub(super) fn reaches<const N: usize>(points: &[[f64; 3]], directions: &[[f64; 3]; N]) -> [[f64; 2]; N] {
    let by_axis: [[f64; N]; 3] = std::array::from_fn(|axis| directions.map(|direction| direction[axis]));
    dispatch!(level_for_few(), simd => reaches_in_lanes(simd, points, &by_axis))
}

#[inline(always)]
fn reaches_in_lanes<S: Simd, const N: usize>(
    _simd: S,
    points: &[[f64; 3]],
    [x, y, z]: &[[f64; N]; 3],
) -> [[f64; 2]; N] {
    let (mut lows, mut highs) = ([f64::INFINITY; N], [f64::NEG_INFINITY; N]);
    for point in points {
        for k in 0..N {
            let height = dot(point, &[x[k], y[k], z[k]]);
            lows[k] = if height < lows[k] { height } else { lows[k] };
            highs[k] = if height > highs[k] { height } else { highs[k] };
        }
    }
    std::array::from_fn(|k| [lows[k], highs[k]])
}
