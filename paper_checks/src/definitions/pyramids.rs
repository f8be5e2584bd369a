//! The volume of a zonotope of any dimension from its faces, in exact rationals: pyramids over the facets, recursively.

use dashu_ratio::RBig;

use crate::definitions::enclosing::{Row, absolute, dot, facet_normals, subsets};
use crate::definitions::ratio::integer;

/// The volume of { Σ δ_i g_i : |δ_i| <= 1 } in the dimension of its generators, 0 if the body is flat.
///
/// The body is the union of the pyramids from its centre over its facets, so dimension × volume is the sum over the
/// facets of height × facet volume. A facet is the zonotope of the generators orthogonal to its normal n, and its
/// height is Σ |n · g_i| / |n|. Facet volume over |n| is the volume of the facet's projection along an axis k, over
/// |n_k|, which is rational; and the projection is a zonotope with one dimension less.
pub(crate) fn volume_by_pyramids(generators: &[Row], dimension: usize) -> RBig {
    if dimension == 0 {
        return RBig::ONE;
    }
    let pyramids = facet_normals(generators, dimension).into_iter().map(|normal| {
        let height = generators.iter().fold(RBig::ZERO, |sum, generator| sum + absolute(dot(&normal, generator)));
        let axis = normal.iter().position(|c| *c != RBig::ZERO).expect("because a normal is not zero");
        let projected: Vec<Row> = generators
            .iter()
            .filter(|generator| dot(&normal, generator) == RBig::ZERO)
            .map(|generator| without(generator, axis))
            .collect();
        height * volume_by_pyramids(&projected, dimension - 1) / absolute(normal[axis].clone())
    });
    // A normal and its negative have pyramids of the same volume.
    integer(2) * pyramids.fold(RBig::ZERO, |sum, pyramid| sum + pyramid) / integer(dimension as i64)
}

/// 2^dimension Σ |det| over the sets of `dimension` generators: the volumes of their parallelepipeds, added up.
pub(crate) fn volume_of_parallelepipeds(generators: &[Row], dimension: usize) -> RBig {
    let mut sum = RBig::ZERO;
    subsets(generators.len(), dimension, &mut |subset| {
        let rows: Vec<Row> = subset.iter().map(|&index| generators[index].clone()).collect();
        sum += absolute(determinant(&rows));
    });
    integer(1 << dimension) * sum
}

/// The determinant of a square matrix, expanded along its first row.
fn determinant(rows: &[Row]) -> RBig {
    let Some((first, rest)) = rows.split_first() else {
        return RBig::ONE;
    };
    (0..first.len()).filter(|&column| first[column] != RBig::ZERO).fold(RBig::ZERO, |sum, column| {
        let minor: Vec<Row> = rest.iter().map(|row| without(row, column)).collect();
        let term = &first[column] * determinant(&minor);
        if column.is_multiple_of(2) { sum + term } else { sum - term }
    })
}

/// The vector without its coordinate along `axis`.
pub(crate) fn without(vector: &[RBig], axis: usize) -> Row {
    [&vector[..axis], &vector[axis + 1..]].concat()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::definitions::enclosing::rows;

    #[test]
    fn volumes_worked_out_by_hand() {
        let hexagon = rows(&[[1, 0], [0, 1], [1, 1]]);
        assert_eq!(volume_by_pyramids(&hexagon, 2), integer(12));
        // A rhombic dodecahedron with edges of length a has the volume 16 √3 a³ / 9, and here a = 2 √3.
        let dodecahedron = rows(&[[1, 1, 1], [1, 1, -1], [1, -1, 1], [-1, 1, 1]]);
        assert_eq!(volume_by_pyramids(&dodecahedron, 3), integer(128));
        // Each of the five sets of four generators has the determinant 1 or −1.
        let stretched_cube = rows(&[[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1], [1, 1, 1, 1]]);
        assert_eq!(volume_by_pyramids(&stretched_cube, 4), integer(16 * 5));
        assert_eq!(volume_of_parallelepipeds(&stretched_cube, 4), integer(16 * 5));
    }

    #[test]
    fn a_flat_body_has_no_volume() {
        let square = rows(&[[1, 0, 0], [0, 1, 0], [2, 0, 0]]);
        assert_eq!(volume_by_pyramids(&square, 3), RBig::ZERO);
        assert_eq!(volume_by_pyramids(&[], 3), RBig::ZERO);
        assert_eq!(volume_of_parallelepipeds(&square, 3), RBig::ZERO);
    }
}
