//! The distance of two triangles: two bounds in doubles, and the exact square.
//!
//! # Statement
//! Input: two triangles. Output: bounds of their distance, in doubles from corners that are off by a stated error; or,
//! of triangles with exact corners that do not meet, the square of their distance as a fraction.
//!
//! # Source
//! No part of the paper: distances of meshes within a tolerance.
//!
//! # Method
//! 1. In doubles, take the nearest of 15 pairs of features: each edge with each edge, each corner with the other
//!    triangle. Their points bound the distance from above, and the gap along the line through both from below.
//! 2. Exactly, the nearest points of triangles that do not meet lie on two features of dimension at most two together,
//!    and no two features are nearer. The square of the distance of the affine hulls of a feature of dimension k and
//!    one of dimension l is |z|², |z × d|² / |d|² or det(z, d, e)² / |d × e|² for k + l = 0, 1, 2, z between a point
//!    of each; a pair counts where the nearest points of the hulls lie on the features.
//!
//! # Complexity
//! O(1).
//!
//! # Shapes
//! `a`, `b`: three corners, in any order, equal ones allowed.
//!
//! # Numerics
//! Bounds are rounded down and up; the square is exact.
//!
//! # Checked by
//! [`brute_force`](super::brute_force), and each other.
//!
//! # Example
//! ```
//! use zonotope::bvh::{Aabb, Bvh, Mesh};
//! let a = Mesh::new(vec![[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [0.0, 4.0, 0.0]], vec![[0, 1, 2]])?;
//! let b = Mesh::new(vec![[1.0, 1.0, 3.0], [9.0, 9.0, 9.0]], vec![[0, 1, 1]])?;
//! let [a, b] = [Bvh::<Aabb>::build(&a), Bvh::build(&b)];
//! let found = a.distance(&b); // the corner (1, 1, 3) is 3 above a
//! assert!(found.lower <= 3.0 && 3.0 <= found.upper && found.upper - found.lower < 0.003);
//! # Ok::<(), zonotope::bvh::MeshError>(())
//! ```

use crate::numeric::dyadic::Dyadic;
use crate::numeric::exact_linear::{ExactVector, cross, difference, dot};
use crate::numeric::linear::{dot as dot_of_doubles, euclidean_norm};
use crate::numeric::tolerance::TRIANGLE_DISTANCE;

/// The edges of a triangle by their ends.
const EDGES: [[usize; 2]; 3] = [[0, 1], [1, 2], [2, 0]];

/// A lower and an upper bound of the distance of two triangles with coordinates of magnitude at most `size`, each off
/// by at most `error`.
pub(crate) fn bounds(a: &[[f64; 3]; 3], b: &[[f64; 3]; 3], size: f64, error: f64) -> [f64; 2] {
    let along = displacement(a, b);
    let length = euclidean_norm(&along);
    let doubt = 4.0 * error + TRIANGLE_DISTANCE * size;
    let heights = |triangle: &[[f64; 3]; 3]| triangle.map(|corner| dot_of_doubles(&along, &corner));
    let highest = heights(a).into_iter().fold(f64::NEG_INFINITY, f64::max);
    let lowest = heights(b).into_iter().fold(f64::INFINITY, f64::min);
    let gap = (lowest - highest) / length * (1.0 - TRIANGLE_DISTANCE) - doubt;
    // a displacement within the errors proves nothing, and its length may have vanished in the squares
    let is_proved = gap > 0.0 && length > doubt;
    [if is_proved { gap } else { 0.0 }, length * (1.0 + TRIANGLE_DISTANCE) + doubt]
}

/// The displacement between the nearest of the 15 pairs of features, in doubles.
fn displacement(a: &[[f64; 3]; 3], b: &[[f64; 3]; 3]) -> [f64; 3] {
    let mut best = [f64::INFINITY; 3];
    let mut consider = |d: [f64; 3]| {
        // a comparison that NaN fails
        if dot_of_doubles(&d, &d) < dot_of_doubles(&best, &best) {
            best = d;
        }
    };
    for [i, j] in EDGES {
        for [k, l] in EDGES {
            consider(between_edges([&a[i], &a[j]], [&b[k], &b[l]]));
        }
    }
    for corner in b {
        from_triangle(a, corner).into_iter().for_each(&mut consider);
    }
    for corner in a {
        from_triangle(b, corner).map(|d| d.map(|c| -c)).into_iter().for_each(&mut consider);
    }
    best
}

fn minus(p: &[f64; 3], q: &[f64; 3]) -> [f64; 3] {
    [p[0] - q[0], p[1] - q[1], p[2] - q[2]]
}

/// A quotient that is cut off at 0 and 1; 0 where there is none.
fn share(numerator: f64, denominator: f64) -> f64 {
    if denominator > 0.0 { (numerator / denominator).clamp(0.0, 1.0) } else { 0.0 }
}

/// The displacement from the nearest point of one edge to that of another.
fn between_edges([p, q]: [&[f64; 3]; 2], [r, s]: [&[f64; 3]; 2]) -> [f64; 3] {
    let (u, v, w) = (minus(q, p), minus(s, r), minus(p, r));
    let (uu, uv, vv) = (dot_of_doubles(&u, &u), dot_of_doubles(&u, &v), dot_of_doubles(&v, &v));
    let (uw, vw) = (dot_of_doubles(&u, &w), dot_of_doubles(&v, &w));
    let first = share(uv * vw - vv * uw, uu * vv - uv * uv);
    let second = share(first * uv + vw, vv);
    let first = share(second * uv - uw, uu);
    [0, 1, 2].map(|k| (r[k] + second * v[k]) - (p[k] + first * u[k]))
}

/// The displacement from the foot of a perpendicular to a point, if the foot is in the triangle.
fn from_triangle([p, q, r]: &[[f64; 3]; 3], point: &[f64; 3]) -> Option<[f64; 3]> {
    let (u, v, w) = (minus(q, p), minus(r, p), minus(point, p));
    let (uu, uv, vv) = (dot_of_doubles(&u, &u), dot_of_doubles(&u, &v), dot_of_doubles(&v, &v));
    let (uw, vw) = (dot_of_doubles(&u, &w), dot_of_doubles(&v, &w));
    let determinant = uu * vv - uv * uv;
    let (s, t) = ((vv * uw - uv * vw) / determinant, (uu * vw - uv * uw) / determinant);
    let is_inside = determinant > 0.0 && s >= 0.0 && t >= 0.0 && s + t <= 1.0;
    is_inside.then(|| [0, 1, 2].map(|k| w[k] - (s * u[k] + t * v[k])))
}

/// A fraction with a positive denominator.
#[derive(Debug, Clone)]
pub(crate) struct Square {
    pub(crate) numerator: Dyadic,
    pub(crate) denominator: Dyadic,
}

impl Square {
    fn is_below(&self, other: &Self) -> bool {
        &self.numerator * &other.denominator < &other.numerator * &self.denominator
    }
}

/// The square of the distance of two triangles that do not meet.
pub(crate) fn exact_square(a: &[ExactVector; 3], b: &[ExactVector; 3]) -> Square {
    let mut best: Option<Square> = None;
    let mut consider = |square: Option<Square>| {
        if let Some(square) = square.filter(|square| best.as_ref().is_none_or(|best| square.is_below(best))) {
            best = Some(square);
        }
    };
    for p in a {
        for q in b {
            let z = difference(q, p);
            consider(Some(Square { numerator: dot(&z, &z), denominator: Dyadic::one() }));
        }
    }
    for (edges, corners) in [(a, b), (b, a)] {
        for [i, j] in EDGES {
            corners.iter().for_each(|corner| consider(corner_to_line(&edges[i], &edges[j], corner)));
        }
        corners.iter().for_each(|corner| consider(corner_to_plane(edges, corner)));
    }
    for [i, j] in EDGES {
        for [k, l] in EDGES {
            consider(line_to_line([&a[i], &a[j]], [&b[k], &b[l]]));
        }
    }
    best.expect("nine pairs of corners were looked at")
}

/// Whether a number is from 0 to another.
fn is_within(number: &Dyadic, limit: &Dyadic) -> bool {
    *number >= Dyadic::zero() && number <= limit
}

/// The square of the distance of a corner from an edge, if its foot is on it.
fn corner_to_line(p: &ExactVector, q: &ExactVector, corner: &ExactVector) -> Option<Square> {
    let (d, z) = (difference(q, p), difference(corner, p));
    let square = dot(&d, &d);
    let across = cross(&z, &d);
    let is_on = !square.is_zero() && is_within(&dot(&z, &d), &square);
    is_on.then(|| Square { numerator: dot(&across, &across), denominator: square })
}

/// The square of the distance of a corner from a triangle, if its foot is on it.
fn corner_to_plane([p, q, r]: &[ExactVector; 3], corner: &ExactVector) -> Option<Square> {
    let (u, v, z) = (difference(q, p), difference(r, p), difference(corner, p));
    let normal = cross(&u, &v);
    let square = dot(&normal, &normal);
    let first = dot(&normal, &cross(&z, &v));
    let second = dot(&normal, &cross(&u, &z));
    let is_on = !square.is_zero()
        && is_within(&first, &square)
        && is_within(&second, &square)
        && is_within(&(first + second), &square);
    let height = dot(&normal, &z);
    is_on.then(|| Square { numerator: &height * &height, denominator: square })
}

/// The square of the distance of two edges that are not parallel, if the nearest points of their lines are on them.
fn line_to_line([p, q]: [&ExactVector; 2], [r, s]: [&ExactVector; 2]) -> Option<Square> {
    let (u, v, z) = (difference(q, p), difference(s, r), difference(r, p));
    let normal = cross(&u, &v);
    let square = dot(&normal, &normal);
    let is_on = !square.is_zero()
        && is_within(&dot(&normal, &cross(&z, &v)), &square)
        && is_within(&dot(&normal, &cross(&z, &u)), &square);
    let height = dot(&normal, &z);
    is_on.then(|| Square { numerator: &height * &height, denominator: square })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numeric::exact_linear::exact;
    use proptest::prelude::*;

    #[test]
    fn distances_worked_out_by_hand() {
        let square = |a: [[f64; 3]; 3], b: [[f64; 3]; 3]| {
            let found = exact_square(&a.map(exact), &b.map(exact));
            found.numerator.ratio(&found.denominator)
        };
        let floor = [[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [0.0, 4.0, 0.0]];
        assert_eq!(square(floor, [[1.0, 1.0, 2.0], [1.0, 2.0, 5.0], [9.0, 9.0, 9.0]]), 4.0);
        assert_eq!(square(floor, [[1.0, -1.0, 1.0], [2.0, -1.0, 1.0], [3.0, -8.0, 1.0]]), 2.0);
        assert_eq!(square(floor, [[-3.0, -4.0, 0.0]; 3]), 25.0);
        // two crossing edges, one above the other
        assert_eq!(
            square(
                [[-1.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, -9.0]],
                [[0.0, -1.0, 3.0], [0.0, 1.0, 3.0], [0.0, 0.0, 9.0]]
            ),
            9.0
        );
    }

    #[test]
    fn a_displacement_whose_square_vanishes_proves_no_gap() {
        // the far end of the edge takes the near one to the origin
        let (point, near, far) = ([0.0, -5e-175, 0.0], [0.0, 5e-101, 0.0], [0.0, 0.5, 0.0]);
        let [lower, upper] = bounds(&[point; 3], &[near, near, far], 1.0, 0.0);
        assert!(lower == 0.0 && upper >= 5e-101, "{lower} {upper}");
    }

    properties! {
        #![proptest_config(crate::property_cases::config(2000))]

        #[test]
        fn bounds_hold_the_exact_distance(
            a in proptest::array::uniform3(proptest::array::uniform3(-2i32..3)),
            b in proptest::array::uniform3(proptest::array::uniform3(-2i32..3)),
            part in 0.25..1.0f64,
        ) {
            let [a, b] = [a, b].map(|t| t.map(|p| p.map(|c| part * f64::from(c))));
            let [exact_a, exact_b] = [a.map(exact), b.map(exact)];
            let [lower, upper] = bounds(&a, &b, 2.0, 0.0);
            if super::super::meet_exactly(&exact_a, &exact_b) {
                prop_assert_eq!(lower, 0.0);
                return Ok(());
            }
            let square = exact_square(&exact_a, &exact_b);
            let distance = square.numerator.ratio(&square.denominator).sqrt();
            prop_assert!(lower <= distance * (1.0 + 1e-15) && distance * (1.0 - 1e-15) <= upper);
            prop_assert!(upper - lower <= 1e-9 * upper, "{} {}", lower, upper);
            let truth = super::super::brute_force::square_of_distance(&exact_a, &exact_b);
            prop_assert_eq!(square.numerator.to_rational() / square.denominator.to_rational(), truth);
        }
    }
}
