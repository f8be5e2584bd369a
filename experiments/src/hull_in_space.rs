//! Convex hull of points in space, by adding one point after the other.
//!
//! # Statement
//! Input: points of R^3. Output: triangles, counter-clockwise as seen from outside, that together are the boundary of
//! the hull; `None` when all points lie in a plane.
//!
//! # Method
//! 1. Four points that span a tetrahedron.
//! 2. For each further point the triangles that see it; none: it is inside. Otherwise those give way to triangles from
//!    the point to their rim.
//!
//! # Complexity
//! n points, h triangles: O(n h) turns; meant for inputs of experiments and figures.
//!
//! # Numerics
//! Each turn is exact (`robust`), so that the triangles are those of the exact hull; a facet of several collinear or
//! coplanar points comes in several of them.
//!
//! # Checked by
//! Euler's relation and that no point is outside of a triangle, in the tests.

use std::collections::BTreeSet;

use robust::{Coord3D, orient3d};

/// The boundary of a hull.
#[derive(Clone, Debug, PartialEq)]
pub struct SolidHull {
    /// The corners of its triangles, as indices of the points.
    pub triangles: Vec<[usize; 3]>,
}

impl SolidHull {
    /// The hull of points; `None` when they lie in a plane.
    pub fn of(points: &[[f64; 3]]) -> Option<Self> {
        let mut triangles = first_tetrahedron(points)?;
        for new in 0..points.len() {
            let (seeing, others): (Vec<[usize; 3]>, Vec<[usize; 3]>) =
                triangles.iter().partition(|t| sees(points, t, new));
            if seeing.is_empty() {
                continue;
            }
            let sides = |t: &[usize; 3]| [[t[0], t[1]], [t[1], t[2]], [t[2], t[0]]];
            let all: BTreeSet<[usize; 2]> = seeing.iter().flat_map(sides).collect();
            let rim = all.iter().filter(|side| !all.contains(&[side[1], side[0]]));
            triangles = others;
            triangles.extend(rim.map(|side| [side[0], side[1], new]));
        }
        Some(Self { triangles })
    }

    /// The points that are corners of triangles, in increasing order.
    pub fn vertices(&self) -> Vec<usize> {
        let corners: BTreeSet<usize> = self.triangles.iter().flatten().copied().collect();
        corners.into_iter().collect()
    }

    /// The volume within, rounded.
    pub fn volume(&self, points: &[[f64; 3]]) -> f64 {
        let Some(origin) = self.triangles.first().map(|t| points[t[0]]) else { return 0.0 };
        let arm = |corner: usize| -> [f64; 3] { std::array::from_fn(|c| points[corner][c] - origin[c]) };
        let six = self.triangles.iter().map(|t| {
            let [a, b, c] = t.map(arm);
            a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0])
        });
        six.sum::<f64>() / 6.0
    }
}

/// Whether a point lies strictly on the outer side of a triangle.
fn sees(points: &[[f64; 3]], triangle: &[usize; 3], point: usize) -> bool {
    orientation(points, [triangle[0], triangle[1], triangle[2], point]) < 0.0
}

/// Positive when the last point lies below the plane of the others, from where they are seen clockwise.
fn orientation(points: &[[f64; 3]], corners: [usize; 4]) -> f64 {
    let [a, b, c, d] = corners.map(|i| Coord3D { x: points[i][0], y: points[i][1], z: points[i][2] });
    orient3d(a, b, c, d)
}

fn first_tetrahedron(points: &[[f64; 3]]) -> Option<Vec<[usize; 3]>> {
    let a = 0;
    let b = (1..points.len()).find(|&b| points[b] != points[a])?;
    // Collinear points that pass by rounding span nothing with a fourth one either.
    let spans = |c: usize| {
        let arm = |i: usize| -> [f64; 3] { std::array::from_fn(|k| points[i][k] - points[a][k]) };
        let (u, v) = (arm(b), arm(c));
        let cross = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
        cross.iter().any(|x| *x != 0.0)
    };
    (1..points.len()).filter(|&c| spans(c)).find_map(|c| {
        let d = (1..points.len()).find(|&d| orientation(points, [a, b, c, d]) != 0.0)?;
        let (b, c) = if orientation(points, [a, b, c, d]) > 0.0 { (b, c) } else { (c, b) };
        Some(vec![[a, b, c], [a, d, b], [b, d, c], [c, d, a]])
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::families::clouds;
    use crate::{data, seed};

    fn check(points: &[[f64; 3]]) -> SolidHull {
        let hull = SolidHull::of(points).expect("the points span space");
        let vertices = hull.vertices().len();
        assert_eq!(hull.triangles.len(), 2 * vertices - 4);
        for triangle in &hull.triangles {
            assert!((0..points.len()).all(|p| !sees(points, triangle, p)));
        }
        hull
    }

    #[test]
    fn solids_have_their_volumes() {
        let golden = (1.0 + 5f64.sqrt()) / 2.0;
        let edge = 2.0 / golden;
        let expected = [
            ("tetrahedron", 8.0 / 3.0),
            ("octahedron", 4.0 / 3.0),
            ("cube", 8.0),
            ("icosahedron", 5.0 / 12.0 * (3.0 + 5f64.sqrt()) * 8.0),
            ("dodecahedron", (15.0 + 7.0 * 5f64.sqrt()) / 4.0 * edge * edge * edge),
        ];
        for (name, volume) in expected {
            let points = clouds::solid(name).expect("listed");
            let hull = check(&points);
            assert_eq!(hull.vertices().len(), points.len());
            assert!((hull.volume(&points) / volume - 1.0).abs() < 1e-14, "{name}");
        }
    }

    #[test]
    fn clouds_and_meshes_are_enclosed() {
        check(&clouds::on_sphere::<3>(200, seed::seed_of(1, "hull")));
        check(&data::mesh("teapot").expect("listed").vertices);
        let grid: Vec<[f64; 3]> = (0..27).map(|i| [f64::from(i % 3), f64::from(i / 3 % 3), f64::from(i / 9)]).collect();
        assert!((check(&grid).volume(&grid) - 8.0).abs() < 1e-14);
    }

    #[test]
    fn flat_points_have_no_hull() {
        assert_eq!(SolidHull::of(&[]), None);
        assert_eq!(SolidHull::of(&[[1.0; 3]; 5]), None);
        let flat: Vec<[f64; 3]> = (0..9).map(|i| [f64::from(i % 3), f64::from(i / 3), 1.0]).collect();
        assert_eq!(SolidHull::of(&flat), None);
    }
}
