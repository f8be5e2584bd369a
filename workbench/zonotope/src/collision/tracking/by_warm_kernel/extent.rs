//! How large a body is in its own frame: the sum of the lengths of its generators, and a ball around its centre that it
//! holds.
//!
//! For |u| = 1 every |v · u| is at least (v · u)² / |v|, so h(u) ≥ uᵀ W u with W = Σ v vᵀ / |v|, and the least
//! eigenvalue of W is the radius of a ball in the body: two thirds of the largest one for even directions. With the
//! eigenvalues λ ≤ μ ≤ ν, λ = det W / (μ ν) ≥ 4 det W / (tr W − λ)², as μ ν ≤ ((μ + ν) / 2)². So any lower bound of λ
//! in the place of λ on the right gives another one, and steps from 0 come near to λ where μ and ν are alike.
//! Generators may be left out of W, which makes the bound smaller.

use crate::numeric::linear::{determinant, euclidean_norm, sum_norm};
use crate::numeric::tolerance::{LONG_SUM, MODERATE_SIZES, SQUARABLE_SIZES, UNIT};
use crate::zonotope::pose::Pose;

/// How often the bound of the least eigenvalue is improved.
const EIGENVALUE_STEPS: usize = 64;

/// A matrix that is farther from a rotation than this in an entry of Mᵀ M is not asked for a ball.
const ROTATION_LIMIT: f64 = 1.0 / 64.0;

/// The sizes of a body in its own frame.
#[derive(Debug, Clone, Copy)]
pub(super) struct Extent {
    /// At least Σ |v|.
    pub(super) length: f64,
    /// The radius of a ball in the body, around its centre; 0 where doubles do not tell.
    radius: f64,
}

impl Extent {
    /// The sizes of a body. O(n).
    pub(super) fn of(generators: &[[f64; 3]]) -> Self {
        let mut length = 0.0;
        let mut rows = [[0.0; 3]; 3];
        for v in generators {
            let own = euclidean_norm(v);
            if SQUARABLE_SIZES.contains(&own) {
                length += own;
                let part = v.map(|c| c / own);
                for (row, c) in rows.iter_mut().zip(v) {
                    *row = [0, 1, 2].map(|k| row[k] + c * part[k]);
                }
            } else {
                length += sum_norm(v);
            }
        }
        Self { length: length * LONG_SUM, radius: least_eigenvalue(&rows, generators.len()) }
    }

    /// The radius of a ball in the body under a pose. If no entry of Mᵀ M − I exceeds d in magnitude, the eigenvalues
    /// of that matrix, which are those of M Mᵀ − I, are at most 3 d, and |Mᵀ u| ≥ √(1 − 3 d) |u| ≥ (1 − 3 d) |u|.
    pub(super) fn radius_under(&self, pose: &Pose) -> f64 {
        let off = pose.distance_from_rotation();
        if off < ROTATION_LIMIT { self.radius * (1.0 - 4.0 * off - 64.0 * UNIT) } else { 0.0 }
    }
}

/// At most the least eigenvalue of Σ v vᵀ / |v|, summed up over so many generators; 0 where doubles do not tell.
///
/// An entry goes through a rounding for each generator and seven more for each term, in terms of a magnitude below the
/// trace t: it is off by less than (n + 8) 2 u t. So is each of the three factors of the six products of the
/// determinant, that is 18 (n + 8) 2 u t³, and its own roundings take 48 u t³.
fn least_eigenvalue(rows: &[[f64; 3]; 3], count: usize) -> f64 {
    let trace = rows[0][0] + rows[1][1] + rows[2][2];
    if !MODERATE_SIZES.contains(&trace) {
        return 0.0;
    }
    let off = 64.0 * (count as f64 + 16.0) * UNIT;
    let least = determinant(rows) - off * (trace * trace * trace);
    if least <= 0.0 {
        return 0.0;
    }
    let largest = trace * (1.0 + off);
    (0..EIGENVALUE_STEPS).fold(0.0, |bound, _| {
        let rest = (largest - bound) * (1.0 + 4.0 * UNIT);
        4.0 * least / (rest * rest) * (1.0 - 8.0 * UNIT)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn balls_worked_out_by_hand() {
        // [−1, 1]³ holds the ball of radius 1, [−2, 2] × [−1, 1] × [−4, 4] too
        for (sides, radius) in [([1.0, 1.0, 1.0], 0.96), ([2.0, 1.0, 4.0], 0.8)] {
            let axes = [0, 1, 2].map(|k| [0, 1, 2].map(|i| if i == k { sides[k] } else { 0.0 }));
            let extent = Extent::of(&axes);
            assert!((radius..=1.0).contains(&extent.radius), "{extent:?}");
            let length: f64 = sides.iter().sum();
            assert!((length..length * 1.001).contains(&extent.length));
            let quarter = Pose::new([[0.0, 1.0, 0.0], [-1.0, 0.0, 0.0], [0.0, 0.0, 1.0]], [9.0; 3]).expect("finite");
            assert!((0.999 * extent.radius..extent.radius).contains(&extent.radius_under(&quarter)));
            let half = Pose::new([[0.5, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]], [0.0; 3]).expect("finite");
            assert_eq!(extent.radius_under(&half), 0.0);
        }
    }

    #[test]
    fn nothing_is_said_of_flat_bodies_and_extreme_ones() {
        let flat = [[1.0, 0.0, 0.1], [0.0, 1.0, 0.1], [1.0, 1.0, 0.2]];
        let radius = |generators: &[[f64; 3]]| Extent::of(generators).radius;
        assert_eq!((radius(&[]), radius(&flat)), (0.0, 0.0));
        for size in [1e300, 1e-300] {
            let extent = Extent::of(&[[size, 0.0, 0.0], [0.0, size, 0.0], [0.0, 0.0, size]]);
            assert!(extent.radius == 0.0 && extent.length >= 3.0 * size);
        }
        assert_eq!(Extent::of(&[[f64::MAX; 3]; 2]).length, f64::INFINITY);
    }
}
