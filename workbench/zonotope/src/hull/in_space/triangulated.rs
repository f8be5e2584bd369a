//! The answer: triangles that together are the boundary of a hull.

/// The boundary of the convex hull of points that span space.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SolidHull {
    /// At least four, no two alike; each side is that of one other triangle as well, the other way around.
    triangles: Vec<[usize; 3]>,
}

impl SolidHull {
    /// The caller has established the invariants of the field. The triangles are put in an order of their own.
    pub(super) fn from_triangles(mut triangles: Vec<[usize; 3]>) -> Self {
        for triangle in &mut triangles {
            let least = (0..3).min_by_key(|&corner| triangle[corner]).unwrap_or(0);
            triangle.rotate_left(least);
        }
        triangles.sort_unstable();
        Self { triangles }
    }

    /// The triangles with their corners as positions of points, counter-clockwise as seen from outside, the smallest
    /// position first.
    pub fn triangles(&self) -> &[[usize; 3]] {
        &self.triangles
    }

    /// The positions of the points that are corners of triangles, in increasing order: all vertices of the hull, and
    /// perhaps points on edges and facets.
    pub fn vertices(&self) -> Vec<usize> {
        let mut corners = self.triangles.concat();
        corners.sort_unstable();
        corners.dedup();
        corners
    }

    /// The volume within, rounded. The points are those that the hull is of.
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
