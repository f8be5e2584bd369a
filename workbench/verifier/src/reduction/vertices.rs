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

    fn counted(dimension: usize, generators: &[Vector], most: usize) -> Option<usize> {
        vertices(dimension, generators, most).map(|signs| signs.len())
    }

    /// Vectors (1, x, x², …), of which as many as there are coordinates are independent.
    fn on_the_moment_curve(dimension: u32, count: i64) -> Vec<Vector> {
        (1..=count).map(|x| (0..dimension).map(|power| IBig::from(x.pow(power))).collect()).collect()
    }

    #[test]
    fn four_coordinates_are_gone_through_by_facets_and_five_are_not() {
        // n generators in general position in d dimensions have twice the sum of the C(n − 1, k), k < d, vertices
        assert_eq!(counted(4, &on_the_moment_curve(4, 5), 1_000), Some(2 * (1 + 4 + 6 + 4)));
        assert_eq!(counted(5, &on_the_moment_curve(5, 6), 1_000), Some(64), "every choice of signs");
        assert_eq!(counted(5, &on_the_moment_curve(5, 14), 16_384), Some(16_384));
        assert_eq!(counted(5, &on_the_moment_curve(5, 15), usize::MAX), None);
    }

    #[test]
    fn vertices_beyond_the_number_asked_for_are_not_listed() {
        let independent = |count: usize| -> Vec<Vector> {
            (0..count).map(|row| (0..count).map(|column| IBig::from(i32::from(row == column))).collect()).collect()
        };
        assert_eq!([1_024, 1_023].map(|most| counted(10, &independent(10), most)), [Some(1_024), None]);
        assert_eq!(counted(64, &independent(64), 1_000), None, "their number takes 65 bits");
        let hexagon = vectors(&[&[1, 0], &[0, 1], &[1, 1]]);
        assert_eq!([6, 5].map(|most| counted(2, &hexagon, most)), [Some(6), None]);
    }

    /// Each facet is a prism over a hexagon, of four generators: none is told by three of them alone.
    #[test]
    fn the_product_of_two_hexagons_has_36_vertices() {
        let hexagons: [&[i64]; 6] =
            [&[1, 0, 0, 0], &[0, 1, 0, 0], &[1, 1, 0, 0], &[0, 0, 1, 0], &[0, 0, 0, 1], &[0, 0, 1, 1]];
        assert_eq!(count(4, &hexagons), Some(36));
    }

    #[test]
    fn a_point_is_the_offset_and_the_generators_with_their_signs() {
        let [offset, x, y] = [[10, 20], [1, 2], [3, -4]].map(|v| v.map(IBig::from).to_vec());
        let at = |signs: [i8; 2]| point(&offset, &[x.clone(), y.clone()], &signs);
        let expected = [[14, 18], [8, 26], [12, 14], [6, 22]].map(|v| v.map(IBig::from).to_vec());
        assert_eq!([[1, 1], [1, -1], [-1, 1], [-1, -1]].map(at), expected);
    }

    #[test]
    fn of_two_opposite_choices_the_one_that_begins_with_a_positive_sign_is_taken() {
        let taken: Vec<_> = all_signs(2).into_iter().filter(|signs| is_of_half(signs)).collect();
        assert_eq!(taken, [[1, -1], [1, 1]]);
        assert!(is_of_half(&[]), "the only vertex of a point");
    }

    #[test]
    fn of_the_subsets_of_a_facet_only_the_first_basis_is_the_first() {
        // four vectors of one plane, two of them parallel, and one across it
        let vectors = vectors(&[&[1, 0, 0], &[2, 0, 0], &[0, 0, 1], &[0, 1, 0], &[1, 1, 0]]);
        let is_first = |basis: &[usize]| is_first(basis, &[0, 1, 3, 4], &vectors);
        assert!(is_first(&[0, 3]));
        assert!([[0, 4], [1, 3], [1, 4], [3, 4]].iter().all(|basis| !is_first(basis)));
    }
}
