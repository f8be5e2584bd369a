//! The vertices of a small zonotope, as the signs of its generators.
//!
//! A vertex has the signs of a direction in general position. Next to the normal u of a facet these are the signs of
//! u · g_i, and those of a vertex of the facet for its own generators: the facet is a zonotope of one dimension less.

use std::collections::BTreeSet;

use crate::exact::linear::{Echelon, Vector};
use crate::exact::subsets::count_subsets;
use crate::faces::normals::{MOST_COORDINATES, images, normals, side};

/// Limit of the pairs of a facet and a generator that are gone through for the vertices of a zonotope.
const MOST_PAIRS: u64 = 12_000_000;

/// Of so few generators every choice of signs is taken in dimensions in which facets are not gone through.
const MOST_FREE_SIGNS: usize = 14;

/// The signs of all vertices of a zonotope of generators of which no two are parallel, and perhaps of more of its
/// points, at most `most` of them; `None` if they are too many.
pub(super) fn vertices(dimension: usize, generators: &[Vector], most: usize) -> Option<BTreeSet<Vec<i8>>> {
    let is_beyond_images = dimension > MOST_COORDINATES;
    let span = Echelon::spanned(dimension, generators);
    let (rank, pivots, count) = (span.rank(), span.pivots(), generators.len());
    // Independent generators have a vertex for each choice.
    if count == rank || is_beyond_images && count <= MOST_FREE_SIGNS {
        return (count < usize::BITS as usize - 1 && 1 << count <= most).then(|| all_signs(count));
    }
    if is_beyond_images || count_subsets(count, rank - 1).saturating_mul(count as u64) > MOST_PAIRS {
        return None;
    }
    let seen: Vec<Vector> = generators.iter().map(|v| pivots.iter().map(|&axis| v[axis].clone()).collect()).collect();
    let seen_images = images(&seen);
    let mut vertices = BTreeSet::new();
    for normal in normals(rank, &seen) {
        let sides: Vec<i8> = seen.iter().zip(&seen_images).map(|(exact, image)| side(&normal, exact, image)).collect();
        let open: Vec<usize> = (0..count).filter(|&index| sides[index] == 0).collect();
        // The other subsets of the generators of a facet lead to the same facet.
        if !is_first(&normal.subset, &open, &seen) {
            continue;
        }
        let facet: Vec<Vector> = open.iter().map(|&index| seen[index].clone()).collect();
        for choice in self::vertices(rank, &facet, most)? {
            for opposite in [1, -1] {
                let mut signs: Vec<i8> = sides.iter().map(|side| side * opposite).collect();
                open.iter().zip(&choice).for_each(|(&index, &sign)| signs[index] = sign);
                vertices.insert(signs);
            }
        }
        if vertices.len() > most {
            return None;
        }
    }
    Some(vertices)
}

fn all_signs(count: usize) -> BTreeSet<Vec<i8>> {
    (0..1_usize << count)
        .map(|choice| (0..count).map(|place| if choice >> place & 1 == 1 { 1 } else { -1 }).collect())
        .collect()
}

/// Whether a basis of the vectors at the places is the one that takes each vector that it can.
fn is_first(basis: &[usize], places: &[usize], vectors: &[Vector]) -> bool {
    if places.len() == basis.len() {
        return true;
    }
    let mut span = Echelon::default();
    let taken = places.iter().copied().filter(|&place| span.rank() < basis.len() && span.insert(&vectors[place]));
    taken.eq(basis.iter().copied())
}

/// The point of a zonotope with these signs, relative to the centre and moved by an offset.
pub(super) fn point(offset: &Vector, generators: &[Vector], signs: &[i8]) -> Vector {
    let mut point = offset.clone();
    for (generator, &sign) in generators.iter().zip(signs) {
        for (sum, c) in point.iter_mut().zip(generator) {
            if sign > 0 { *sum += c } else { *sum -= c }
        }
    }
    point
}

/// One of each pair of opposite choices of signs.
pub(super) fn is_of_half(signs: &[i8]) -> bool {
    signs.first().is_none_or(|&sign| sign > 0)
}

#[cfg(test)]
mod tests {
    use dashu_int::IBig;

    use super::*;

    fn vectors(rows: &[&[i64]]) -> Vec<Vector> {
        rows.iter().map(|row| row.iter().copied().map(IBig::from).collect()).collect()
    }

    fn count(dimension: usize, rows: &[&[i64]]) -> Option<usize> {
        vertices(dimension, &vectors(rows), 1_000).map(|signs| signs.len())
    }

    #[test]
    fn vertices_are_counted() {
        let octagons: [&[i64]; 8] = [&[1, 0], &[0, 1], &[1, 1], &[1, -1], &[2, 1], &[1, 2], &[2, -1], &[1, -2]];
        assert_eq!(count(2, &octagons), Some(16));
        // a prism over a polygon of sixteen sides, whose two facets of eight generators are no case of their own
        let prism: Vec<Vec<i64>> = octagons.iter().map(|v| vec![v[0], v[1], 0]).chain([vec![0, 0, 1]]).collect();
        let prism: Vec<&[i64]> = prism.iter().map(Vec::as_slice).collect();
        assert_eq!(count(3, &prism), Some(32));
        // the truncated octahedron and a ninth direction in general position
        let permutohedron: [&[i64]; 7] =
            [&[1, 1, 0], &[1, -1, 0], &[1, 0, 1], &[1, 0, -1], &[0, 1, 1], &[0, 1, -1], &[3, 7, 19]];
        assert_eq!(count(3, &permutohedron), Some(36));
        assert_eq!(count(2, &[]), Some(1));
        let flat: Vec<Vec<i64>> = (1..9).map(|x| vec![x, x * x, 0]).collect();
        assert_eq!(count(3, &flat.iter().map(Vec::as_slice).collect::<Vec<_>>()), Some(16), "a flat body");
        let many: Vec<Vec<i64>> = (0..3000).map(|x| vec![x, x * x, 1]).collect();
        assert_eq!(count(3, &many.iter().map(Vec::as_slice).collect::<Vec<_>>()), None);
    }
}
