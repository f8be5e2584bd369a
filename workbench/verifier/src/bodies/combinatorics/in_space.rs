//! Faces and volumes in space, line by line.
//!
//! Seen along one of its lines, a zonotope of space is a zonogon: its directions are the planes through the line that
//! others of the lines span, and each is a pair of facets. A facet with m lines is so met m times. The determinants of
//! three vectors, one of which is fixed, are the turns between the other two as seen along it, and turns add up in the
//! order of their angles.

use std::collections::BTreeMap;

use dashu_int::IBig;
use dashu_int::ops::Abs;

use super::{Counts, modulo};
use crate::exact::linear::Vector;
use crate::exact::turns::{by_angle, turn, turns};

/// Σ |det| over all triples of vectors of space that are not zero.
pub(crate) fn volumes(vectors: &[Vector]) -> IBig {
    (0..vectors.len())
        .map(|i| {
            let g = &vectors[i];
            let divisor = g.iter().find(|component| **component != IBig::ZERO).expect("the vectors are not zero");
            turns(modulo(&vectors[i + 1..], g)) / divisor.clone().abs()
        })
        .sum()
}

/// The numbers of faces of the zonotope of segments along distinct lines that span space.
pub(crate) fn counts(lines: &[Vector]) -> Counts {
    let mut edges = 0;
    let mut met: BTreeMap<usize, u64> = BTreeMap::new();
    for (i, line) in lines.iter().enumerate() {
        let others: Vec<Vector> = lines.iter().enumerate().filter(|(j, _)| *j != i).map(|(_, v)| v.clone()).collect();
        let seen = by_angle(modulo(&others, line));
        for plane in seen.chunk_by(|a, b| turn(a, b) == IBig::ZERO) {
            edges += 2;
            *met.entry(plane.len() + 1).or_default() += 1;
        }
    }
    let facet_sizes: BTreeMap<usize, u64> =
        met.into_iter().map(|(size, count)| (2 * size, 2 * count / size as u64)).collect();
    Counts { vertices: edges + 2 - facet_sizes.values().sum::<u64>(), edges, facet_sizes }
}

#[cfg(test)]
mod tests {
    use super::super::{by_subsets, directions};
    use super::*;
    use crate::exact::linear::{Echelon, absolute_determinant, is_zero};
    use crate::exact::subsets::subsets;

    /// Small whole numbers, so that many are parallel and coplanar.
    fn vectors(count: u64, seed: u64) -> Vec<Vector> {
        let mut state = seed;
        let mut next = || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            IBig::from((state >> 60) as i64 % 5 - 2)
        };
        (0..count).map(|_| vec![next(), next(), next()]).filter(|v| !is_zero(v)).collect()
    }

    #[test]
    fn counts_are_those_of_the_subsets() {
        let mut spatial = 0;
        for seed in 0..200 {
            let lines = directions(&vectors(3 + seed % 12, seed));
            if Echelon::spanned(3, &lines).rank() < 3 {
                continue;
            }
            spatial += 1;
            let (quick, sure) = (counts(&lines), by_subsets::counts(3, &lines).expect("few"));
            assert_eq!((quick.vertices, quick.edges, quick.facet_sizes), (sure.vertices, sure.edges, sure.facet_sizes));
        }
        assert!(spatial > 100);
    }

    #[test]
    fn sums_are_those_of_the_subsets() {
        for seed in 0..60 {
            let vectors = vectors(2 + seed % 9, seed);
            let listed = |size: usize, of: &[Vector]| -> IBig {
                let chosen = subsets(of.len(), size);
                chosen.map(|s| absolute_determinant(s.into_iter().map(|i| of[i].clone()).collect())).sum()
            };
            assert_eq!(volumes(&vectors), listed(3, &vectors));
            let flat: Vec<Vector> = vectors.iter().map(|v| v[..2].to_vec()).collect();
            assert_eq!(turns(flat.clone()), listed(2, &flat));
        }
    }
}
