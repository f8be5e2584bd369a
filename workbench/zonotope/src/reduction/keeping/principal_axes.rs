//! Principal axes of vectors, in floating point: the eigenvectors of Σ w v vᵀ, by Jacobi's rotations.

use crate::numeric::linear::dot;

/// More sweeps than this do not occur: from the third or fourth on, what is off the diagonal is squared by each.
const SWEEP_LIMIT: usize = 30;

/// Orthonormal axes up to rounding, by falling Σ w (axis · v)², of vectors v with weights w. O(n D²).
pub(in crate::reduction) fn principal_axes<const D: usize>(
    vectors: impl Iterator<Item = ([f64; D], f64)>,
) -> [[f64; D]; D] {
    let mut matrix = [[0.0; D]; D];
    for (v, weight) in vectors {
        for (row, c) in matrix.iter_mut().zip(v) {
            row.iter_mut().zip(v).for_each(|(entry, other)| *entry += weight * c * other);
        }
    }
    let mut axes: [[f64; D]; D] = std::array::from_fn(|i| std::array::from_fn(|k| f64::from(u8::from(i == k))));
    for _ in 0..SWEEP_LIMIT {
        let mut is_diagonal = true;
        for p in 0..D {
            for q in p + 1..D {
                is_diagonal &= !rotate(&mut matrix, &mut axes, p, q);
            }
        }
        if is_diagonal {
            break;
        }
    }
    let mut order: [usize; D] = std::array::from_fn(|k| k);
    order.sort_by(|&a, &b| matrix[b][b].total_cmp(&matrix[a][a]).then(a.cmp(&b)));
    order.map(|k| axes[k])
}

/// Turns the axes p and q in their plane so that the entry (p, q) vanishes; whether that changed anything.
fn rotate<const D: usize>(matrix: &mut [[f64; D]; D], axes: &mut [[f64; D]; D], p: usize, q: usize) -> bool {
    let off = matrix[p][q];
    if off == 0.0 || off.abs() <= f64::EPSILON * (matrix[p][p] * matrix[q][q]).sqrt() {
        return false;
    }
    let slope = (matrix[q][q] - matrix[p][p]) / (2.0 * off);
    let tangent = if slope < 0.0 { -1.0 } else { 1.0 } / (slope.abs() + (slope * slope + 1.0).sqrt());
    let cosine = 1.0 / (tangent * tangent + 1.0).sqrt();
    let sine = tangent * cosine;
    let turned = |a: f64, b: f64| (cosine * a - sine * b, sine * a + cosine * b);
    for row in matrix.iter_mut() {
        (row[p], row[q]) = turned(row[p], row[q]);
    }
    for k in 0..D {
        (matrix[p][k], matrix[q][k]) = turned(matrix[p][k], matrix[q][k]);
        (axes[p][k], axes[q][k]) = turned(axes[p][k], axes[q][k]);
    }
    true
}

/// Σ |axis · v|: half the width of the zonotope of the vectors along an axis.
pub(in crate::reduction) fn extent<const D: usize>(vectors: &[[f64; D]], axis: &[f64; D]) -> f64 {
    vectors.iter().map(|v| dot(v, axis).abs()).sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn axes_of_a_turned_box() {
        let edges = [[6.0, 8.0, 0.0], [-4.0, 3.0, 0.0], [0.0, 0.0, 1.0]];
        let axes = principal_axes(edges.iter().map(|v| (*v, 1.0)));
        for (axis, (edge, length)) in axes.iter().zip(edges.iter().zip([10.0, 5.0, 1.0])) {
            assert!((dot(axis, edge).abs() - length).abs() < 1e-14, "{axes:?}");
            assert!((extent(&edges, axis) - length).abs() < 1e-13);
        }
        assert_eq!(principal_axes::<2>(std::iter::empty()), [[1.0, 0.0], [0.0, 1.0]]);
    }
}
