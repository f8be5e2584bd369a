//! Is there a direction that no vector of a set turns away from?

use dashu_int::IBig;

use crate::exact::linear::{Echelon, Vector, dot, is_zero, reduced};

/// A direction u ≠ 0 with u · w ≥ 0 for every w, if there is one: the polar cone of the vectors has more than its apex.
///
/// The vectors are taken one after the other. If u turns away from the next one, w, any direction for all vectors so
/// far lies on the other side of the hyperplane w^⊥, and the way to it crosses that hyperplane in a direction that is
/// as good; only −u has no such way.
pub(crate) fn common_direction(dimension: usize, vectors: &[Vector]) -> Option<Vector> {
    if dimension == 0 {
        return None;
    }
    let mut u = vec![IBig::ZERO; dimension];
    u[0] = IBig::ONE;
    for (index, w) in vectors.iter().enumerate() {
        if dot(&u, w) >= IBig::ZERO {
            continue;
        }
        let earlier = &vectors[..index];
        u = match within_hyperplane(dimension, w, earlier) {
            Some(found) => found,
            None => {
                let opposite: Vector = u.iter().map(|component| -component).collect();
                if earlier.iter().any(|w| dot(&opposite, w) < IBig::ZERO) {
                    return None;
                }
                opposite
            }
        };
    }
    Some(u)
}

/// A common direction of the vectors that is orthogonal to w.
fn within_hyperplane(dimension: usize, w: &Vector, vectors: &[Vector]) -> Option<Vector> {
    let axes = Echelon::spanned(dimension, [w]).complement(dimension);
    let seen: Vec<Vector> = vectors
        .iter()
        .map(|v| reduced(axes.iter().map(|axis| dot(axis, v)).collect()))
        .filter(|v: &Vector| !is_zero(v))
        .collect();
    let coordinates = common_direction(dimension - 1, &seen)?;
    Some(combined(&axes, &coordinates))
}

/// Σ coordinates_j axes_j.
pub(crate) fn combined(axes: &[Vector], coordinates: &[IBig]) -> Vector {
    let length = axes.first().map_or(0, Vec::len);
    let sum = |component: usize| axes.iter().zip(coordinates).map(|(axis, x)| &axis[component] * x).sum();
    reduced((0..length).map(sum).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn found(dimension: usize, vectors: &[&[i64]]) -> bool {
        let vectors: Vec<Vector> = vectors.iter().map(|v| v.iter().copied().map(IBig::from).collect()).collect();
        let direction = common_direction(dimension, &vectors);
        if let Some(u) = &direction {
            assert!(!is_zero(u) && vectors.iter().all(|v| dot(u, v) >= IBig::ZERO), "{u:?}");
        }
        direction.is_some()
    }

    #[test]
    fn half_spaces_by_hand() {
        assert!(found(1, &[&[-2], &[0], &[-1]]));
        assert!(!found(1, &[&[-2], &[1]]));
        assert!(found(1, &[&[0], &[-2]]) && found(2, &[&[0, 1], &[0, -1], &[-1, 0]]), "orthogonal is not against");
        assert!(found(2, &[&[1, 0], &[-1, 0], &[0, -1]]));
        assert!(!found(2, &[&[1, 0], &[-1, 1], &[-1, -2]]));
        assert!(found(3, &[&[1, 0, 0], &[-1, 0, 0], &[0, 1, 0], &[0, -1, 0]]));
        assert!(!found(3, &[&[1, 0, 0], &[0, 1, 0], &[0, 0, 1], &[-1, -1, -1]]));
        assert!(found(3, &[&[1, 0, 0], &[0, 1, 0], &[0, 0, 1], &[-1, -1, 0]]));
        assert!(found(4, &[&[1, 0, 0, 0], &[-1, 0, 0, 0], &[0, 1, 1, 0], &[0, -1, 0, 2]]));
    }
}
