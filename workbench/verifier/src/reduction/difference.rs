//! Two zonotopes without their common summands.
//!
//! The support function of a Minkowski sum is the sum of the support functions, so a summand that two bodies have in
//! common leaves h_A − h_B, and every distance that it tells, as it is. Generators of one line count together.

use std::cmp::Ordering;
use std::collections::BTreeMap;

use dashu_int::IBig;
use dashu_int::ops::Abs;

use crate::exact::linear::{Vector, is_zero, reduced};

/// Generators of two zonotopes, no two of them parallel, whose support functions differ by as much as those of the
/// given ones in every direction.
pub(crate) fn without_common_summands([first, second]: [&[Vector]; 2]) -> [Vec<Vector>; 2] {
    // The number of times that the primitive vector of a line goes into the generators of the first body, less those of
    // the second.
    let mut lines: BTreeMap<Vector, IBig> = BTreeMap::new();
    for (generators, sign) in [(first, 1), (second, -1)] {
        for generator in generators.iter().filter(|generator| !is_zero(generator)) {
            let (primitive, times) = primitive(generator);
            *lines.entry(primitive).or_default() += times * sign;
        }
    }
    let mut rest = [Vec::new(), Vec::new()];
    for (primitive, times) in lines {
        let generator = |times: IBig| primitive.iter().map(|c| c * &times).collect();
        match times.cmp(&IBig::ZERO) {
            Ordering::Greater => rest[0].push(generator(times)),
            Ordering::Less => rest[1].push(generator(times.abs())),
            Ordering::Equal => {}
        }
    }
    rest
}

/// The shortest vector of whole numbers along a line, its first component that is not zero positive, and how often it
/// goes into a vector of the line that is not zero.
fn primitive(vector: &Vector) -> (Vector, IBig) {
    let shortest = reduced(vector.clone());
    let axis = shortest.iter().position(|c| *c != IBig::ZERO).expect("the vector is not zero");
    let times = (&vector[axis] / &shortest[axis]).abs();
    let is_turned = shortest[axis] < IBig::ZERO;
    (if is_turned { shortest.into_iter().map(|c| -c).collect() } else { shortest }, times)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn vectors(rows: &[&[i64]]) -> Vec<Vector> {
        rows.iter().map(|row| row.iter().copied().map(IBig::from).collect()).collect()
    }

    #[test]
    fn common_summands_by_hand() {
        let first = vectors(&[&[2, 4], &[-1, -2], &[0, 3], &[0, 0], &[5, 0]]);
        let second = vectors(&[&[0, -3], &[1, 2], &[1, 1]]);
        let [own, others] = without_common_summands([&first, &second]);
        assert_eq!(own, vectors(&[&[5, 0], &[2, 4]]));
        assert_eq!(others, vectors(&[&[1, 1]]));
        assert!(without_common_summands([&first, &first]).iter().all(Vec::is_empty));
    }

    #[test]
    fn a_line_without_a_vector_of_a_component_one_counts_as_often_as_its_shortest_vector_fits() {
        // the vector (2, 3) goes twice into (4, 6) and three times into (6, 9), whichever way it points
        let [first, second] = [vectors(&[&[4, 6], &[-6, -9]]), vectors(&[&[2, 3]])];
        assert_eq!(without_common_summands([&first, &second]), [vectors(&[&[8, 12]]), vec![]]);
        assert_eq!(without_common_summands([&second, &first]), [vec![], vectors(&[&[8, 12]])]);
    }
}
