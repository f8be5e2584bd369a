//! The test of two triangles that the trees of other libraries are given: the sides of each other's planes in plain
//! doubles, as Devillers and Guigue have it, and the test of parry3d-f64 where both lie in one plane.
//!
//! The test of parry3d-f64 for all pairs was tried as well: questions took two to eight times as long.

use parry3d_f64::math::{Pose, Vector};
use parry3d_f64::query::intersection_test;
use parry3d_f64::shape;

/// Three corners.
pub type Triangle = [[f64; 3]; 3];

/// Whether two triangles meet, but for rounding.
pub fn meet(a: &Triangle, b: &Triangle) -> bool {
    let (over_a, over_b) = (sides_of_plane(a, b), sides_of_plane(b, a));
    if are_apart(over_a) || are_apart(over_b) {
        return false;
    }
    if over_a == [0.0; 3] || over_b == [0.0; 3] {
        return meet_by_parry(a, b);
    }
    an_edge_meets(b, over_a, a) || an_edge_meets(a, over_b, b)
}

/// The answer of parry3d-f64.
pub fn meet_by_parry(a: &Triangle, b: &Triangle) -> bool {
    let [a, b] = [a, b].map(|t| {
        let [p, q, r] = t.map(Vector::from_array);
        shape::Triangle::new(p, q, r)
    });
    intersection_test(&Pose::IDENTITY, &a, &Pose::IDENTITY, &b).is_ok_and(|test| test.intersecting)
}

#[inline]
fn sides_of_plane(plane: &Triangle, corners: &Triangle) -> [f64; 3] {
    let [p, q, r] = plane;
    let normal = cross(difference(p, q), difference(p, r));
    corners.map(|corner| dot(normal, difference(p, &corner)))
}

#[inline]
fn are_apart([a, b, c]: [f64; 3]) -> bool {
    (a > 0.0 && b > 0.0 && c > 0.0) || (a < 0.0 && b < 0.0 && c < 0.0)
}

/// Whether an edge with ends on both sides of a triangle's plane, or one end in it, meets the triangle.
#[inline]
fn an_edge_meets(edges: &Triangle, sides: [f64; 3], triangle: &Triangle) -> bool {
    [(0, 1), (1, 2), (2, 0)].into_iter().any(|(i, j)| {
        if sides[i] * sides[j] > 0.0 || (sides[i] == 0.0 && sides[j] == 0.0) {
            return false;
        }
        let along = difference(&edges[i], &edges[j]);
        let [u, v, w] = triangle.map(|corner| difference(&edges[i], &corner));
        let volumes = [dot(along, cross(u, v)), dot(along, cross(v, w)), dot(along, cross(w, u))];
        volumes.iter().all(|volume| *volume >= 0.0) || volumes.iter().all(|volume| *volume <= 0.0)
    })
}

/// `to` − `from`.
#[inline]
fn difference(from: &[f64; 3], to: &[f64; 3]) -> [f64; 3] {
    [to[0] - from[0], to[1] - from[1], to[2] - from[2]]
}

#[inline]
fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

#[inline]
fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}
