//! The faces of zonotopes of any dimension as sign vectors, by recursion on facets and in exact rationals, and the
//! cells of the arrangement of the hyperplanes orthogonal to the generators.

use std::collections::BTreeSet;

use dashu_ratio::RBig;

use crate::definitions::enclosing::{Row, dot, facet_normals, rank};
use crate::definitions::pyramids::without;

/// The coefficients of a face: 1 or −1 for each generator, 0 along the face and for a zero generator.
pub(crate) type Signs = Vec<i8>;

fn sign(value: &RBig) -> i8 {
    value.cmp(&RBig::ZERO) as i8
}

/// All faces of the zonotope of generators that span their space, by dimension; the last is the body.
///
/// A normal that is unique has the generators orthogonal to it along two opposite facets. A facet is the zonotope of
/// these generators, and leaving out a coordinate where the normal is not zero maps it one to one.
pub(crate) fn faces(generators: &[Row], dimension: usize) -> Vec<BTreeSet<Signs>> {
    let mut faces = vec![BTreeSet::new(); dimension + 1];
    faces[dimension].insert(vec![0; generators.len()]);
    if dimension == 0 {
        return faces;
    }
    for normal in facet_normals(generators, dimension) {
        let signs: Signs = generators.iter().map(|generator| sign(&dot(&normal, generator))).collect();
        let along: Vec<usize> = (0..signs.len()).filter(|&index| signs[index] == 0).collect();
        let axis = normal.iter().position(|c| *c != RBig::ZERO).expect("because a normal is not zero");
        let projected: Vec<Row> = along.iter().map(|&index| without(&generators[index], axis)).collect();
        for (found, of_facet) in faces.iter_mut().zip(self::faces(&projected, dimension - 1)) {
            for face in &of_facet {
                for side in [1, -1] {
                    let mut whole: Signs = signs.iter().map(|sign| sign * side).collect();
                    along.iter().zip(face).for_each(|(&index, &sign)| whole[index] = sign);
                    found.insert(whole);
                }
            }
        }
    }
    faces
}

/// Whether a face lies in another one: it has the coefficients of the other wherever that has any.
pub(crate) fn lies_in(face: &Signs, other: &Signs) -> bool {
    face.iter().zip(other).all(|(own, other)| *other == 0 || own == other)
}

/// The number of cells into which the hyperplanes orthogonal to the vectors cut their space, by taking one away: those
/// without it, and those of the others within it, each of which it cuts in two.
pub(crate) fn cells(vectors: &[Row]) -> usize {
    let mut vectors: Vec<&Row> = vectors.iter().filter(|vector| vector.iter().any(|c| *c != RBig::ZERO)).collect();
    let Some(last) = vectors.pop() else { return 1 };
    let others: Vec<Row> = vectors.into_iter().cloned().collect();
    let axis = last.iter().position(|c| *c != RBig::ZERO).expect("because the vector is not zero");
    let within = |vector: &Row| -> Row {
        let factor = &vector[axis] / &last[axis];
        without(&vector.iter().zip(last).map(|(c, l)| c - &factor * l).collect::<Row>(), axis)
    };
    let restricted: Vec<Row> = others.iter().map(within).collect();
    let is_repeated = restricted.iter().any(|vector| vector.iter().all(|c| *c == RBig::ZERO));
    cells(&others) + if is_repeated { 0 } else { cells(&restricted) }
}

/// Whether any `dimension` of the vectors are linearly independent.
pub(crate) fn are_independent(vectors: &[Row], dimension: usize) -> bool {
    let mut all = true;
    crate::definitions::enclosing::subsets(vectors.len(), dimension, &mut |subset| {
        let chosen: Vec<Row> = subset.iter().map(|&index| vectors[index].clone()).collect();
        all &= rank(&chosen) == dimension;
    });
    all
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::definitions::enclosing::rows;

    #[test]
    fn a_tesseract_and_a_prism_have_their_faces() {
        let axes = rows(&[[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]);
        assert_eq!(faces(&axes, 4).iter().map(BTreeSet::len).collect::<Vec<_>>(), [16, 32, 24, 8, 1]);
        assert_eq!(cells(&axes), 16);
        let prism = rows(&[[1, 0, 0], [0, 1, 0], [1, 1, 0], [2, 2, 0], [0, 0, 1], [0, 0, 0]]);
        assert_eq!(faces(&prism, 3).iter().map(BTreeSet::len).collect::<Vec<_>>(), [12, 18, 8, 1]);
        assert_eq!(cells(&prism), 12);
        assert!(are_independent(&axes, 4) && !are_independent(&prism, 3));
    }

    #[test]
    fn a_face_lies_in_those_whose_coefficients_it_has() {
        assert!(lies_in(&vec![1, -1, 0], &vec![1, 0, 0]) && !lies_in(&vec![1, -1, 0], &vec![-1, 0, 0]));
    }
}
