//! The volume of a zonotope of any dimension from its faces, in exact rationals: pyramids over the facets, recursively.

use std::collections::BTreeSet;

use dashu_ratio::RBig;

use crate::ratio::integer;

/// The volume of { Σ δ_i g_i : |δ_i| <= 1 } in the dimension of its generators, 0 if the body is flat.
///
/// The body is the union of the pyramids from its centre over its facets, so dimension × volume is the sum over the
/// facets of height × facet volume. A facet is the zonotope of the generators orthogonal to its normal n, and its
/// height is Σ |n · g_i| / |n|. Facet volume over |n| is the volume of the facet's projection along an axis k, over
/// |n_k|, which is rational; and the projection is a zonotope with one dimension less.
pub(crate) fn volume_by_pyramids(generators: &[Vec<RBig>], dimension: usize) -> RBig {
    if dimension == 1 {
        return generators.iter().fold(RBig::ZERO, |sum, generator| sum + integer(2) * absolute(&generator[0]));
    }
    let pyramids = facet_normals(generators, dimension).into_iter().map(|normal| {
        let height = generators.iter().fold(RBig::ZERO, |sum, generator| sum + absolute(&dot(&normal, generator)));
        let axis = normal.iter().position(|c| *c != RBig::ZERO).expect("because a normal is not zero");
        let projected: Vec<Vec<RBig>> = generators
            .iter()
            .filter(|generator| dot(&normal, generator) == RBig::ZERO)
            .map(|generator| without(generator, axis))
            .collect();
        height * volume_by_pyramids(&projected, dimension - 1) / absolute(&normal[axis])
    });
    // A normal and its negative have pyramids of the same volume.
    integer(2) * pyramids.fold(RBig::ZERO, |sum, pyramid| sum + pyramid) / integer(dimension as i64)
}

/// 2^dimension Σ |det| over the sets of `dimension` generators: the volumes of their parallelepipeds, added up.
pub(crate) fn volume_of_parallelepipeds(generators: &[Vec<RBig>], dimension: usize) -> RBig {
    let determinants = subsets(generators.len(), dimension).into_iter().map(|subset| {
        let rows: Vec<Vec<RBig>> = subset.into_iter().map(|index| generators[index].clone()).collect();
        absolute(&determinant(&rows))
    });
    integer(1 << dimension) * determinants.fold(RBig::ZERO, |sum, term| sum + term)
}

/// One normal for each hyperplane that `dimension` − 1 of the generators span, its first coordinate that is not zero
/// being 1.
fn facet_normals(generators: &[Vec<RBig>], dimension: usize) -> BTreeSet<Vec<RBig>> {
    let spanning = subsets(generators.len(), dimension - 1).into_iter();
    spanning
        .filter_map(|subset| {
            let minor = |axis: usize| {
                let rows: Vec<Vec<RBig>> = subset.iter().map(|&index| without(&generators[index], axis)).collect();
                if axis.is_multiple_of(2) { determinant(&rows) } else { -determinant(&rows) }
            };
            let normal: Vec<RBig> = (0..dimension).map(minor).collect();
            let leading = normal.iter().find(|c| **c != RBig::ZERO)?.clone();
            Some(normal.iter().map(|c| c / &leading).collect())
        })
        .collect()
}

/// The sets of `size` of the numbers below `count`, each in increasing order.
fn subsets(count: usize, size: usize) -> Vec<Vec<usize>> {
    if size == 0 {
        return vec![Vec::new()];
    }
    let largest = size - 1..count;
    largest
        .flat_map(|last| {
            let smaller = subsets(last, size - 1).into_iter();
            smaller.map(move |mut subset| {
                subset.push(last);
                subset
            })
        })
        .collect()
}

/// The determinant of a square matrix, expanded along its first row.
fn determinant(rows: &[Vec<RBig>]) -> RBig {
    let Some((first, rest)) = rows.split_first() else {
        return RBig::ONE;
    };
    (0..first.len()).filter(|&column| first[column] != RBig::ZERO).fold(RBig::ZERO, |sum, column| {
        let minor: Vec<Vec<RBig>> = rest.iter().map(|row| without(row, column)).collect();
        let term = &first[column] * determinant(&minor);
        if column.is_multiple_of(2) { sum + term } else { sum - term }
    })
}

fn without(vector: &[RBig], axis: usize) -> Vec<RBig> {
    [&vector[..axis], &vector[axis + 1..]].concat()
}

fn dot(a: &[RBig], b: &[RBig]) -> RBig {
    a.iter().zip(b).fold(RBig::ZERO, |sum, (a, b)| sum + a * b)
}

fn absolute(value: &RBig) -> RBig {
    if *value < RBig::ZERO { -value.clone() } else { value.clone() }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn exact(generators: &[&[i64]]) -> Vec<Vec<RBig>> {
        generators.iter().map(|generator| generator.iter().map(|&c| integer(c)).collect()).collect()
    }

    #[test]
    fn volumes_worked_out_by_hand() {
        let hexagon = exact(&[&[1, 0], &[0, 1], &[1, 1]]);
        assert_eq!(volume_by_pyramids(&hexagon, 2), integer(12));
        // A rhombic dodecahedron with edges of length a has the volume 16 √3 a³ / 9, and here a = 2 √3.
        let dodecahedron = exact(&[&[1, 1, 1], &[1, 1, -1], &[1, -1, 1], &[-1, 1, 1]]);
        assert_eq!(volume_by_pyramids(&dodecahedron, 3), integer(128));
        // The cubes below and above the hyperplane sum = 0 of R^4 stretch the unit cube by its diagonal.
        let stretched = exact(&[&[1, 0, 0, 0], &[0, 1, 0, 0], &[0, 0, 1, 0], &[0, 0, 0, 1], &[1, 1, 1, 1]]);
        assert_eq!(volume_by_pyramids(&stretched, 4), integer(16 * 5));
        assert_eq!(volume_of_parallelepipeds(&stretched, 4), integer(16 * 5));
    }

    #[test]
    fn a_flat_body_has_no_volume() {
        let square = exact(&[&[1, 0, 0], &[0, 1, 0], &[2, 0, 0]]);
        assert_eq!(volume_by_pyramids(&square, 3), RBig::ZERO);
        assert_eq!(volume_by_pyramids(&[], 3), RBig::ZERO);
    }

    #[test]
    fn subsets_are_all_there() {
        assert_eq!(subsets(4, 2), [[0, 1], [0, 2], [1, 2], [0, 3], [1, 3], [2, 3]]);
        assert_eq!(subsets(2, 3).len(), 0);
        assert_eq!(subsets(3, 0), [[0; 0]]);
    }
}
