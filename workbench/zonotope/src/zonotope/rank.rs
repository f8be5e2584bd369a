//! The rank of vectors, exactly, and coordinates that keep it.

use crate::numeric::dyadic::Dyadic;

/// The first coordinates, in lexicographic order, in which vectors of finite coordinates have the same linear dependences: as many as their rank. O(n D²)
/// exact operations.
pub(super) fn independent_coordinates<const D: usize>(vectors: &[[f64; D]]) -> Vec<usize> {
    let mut basis: Vec<(usize, Vec<Dyadic>)> = Vec::new();
    for vector in vectors {
        let mut rest: Vec<Dyadic> = vector.iter().map(|&c| Dyadic::from_f64(c)).collect();
        for (pivot, row) in &basis {
            if !rest[*pivot].is_zero() {
                let [head, factor] = [row[*pivot].clone(), rest[*pivot].clone()];
                rest = rest.iter().zip(row).map(|(a, b)| a * &head - b * &factor).collect();
            }
        }
        if let Some(pivot) = rest.iter().position(|c| !c.is_zero()) {
            basis.push((pivot, rest));
        }
        if basis.len() == D {
            break;
        }
    }
    let mut coordinates: Vec<usize> = basis.iter().map(|&(pivot, _)| pivot).collect();
    coordinates.sort_unstable();
    coordinates
}
