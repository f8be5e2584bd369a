//! A closed surface of triangles that grows, and the distances of its faces from a point.
//!
//! The corners are points of the body. A ball around p that no face's plane meets lies within the body: the faces form
//! a closed surface and turn the same side to p, so that the surface winds around p, and around every point of the ball
//! as often, and a surface winds around no point outside of the convex hull of its corners. Nothing else is used of the
//! surface; that it is convex but for rounding makes the search short.

use super::number::Number;
use crate::numeric::linear::{cross, dot, max_norm};

/// A face: corners counter-clockwise seen from outside.
#[derive(Debug, Clone)]
struct Face<N> {
    corners: [usize; 3],
    normal: [N; 3],
    /// The normal in doubles.
    direction: [f64; 3],
    /// At most the distance of p from the plane, negative where p is beyond it.
    distance: f64,
}

/// A surface around the origin whose corners come in opposite pairs.
#[derive(Debug)]
pub(super) struct Polytope<N> {
    /// The point p.
    end: [N; 3],
    corners: Vec<[N; 3]>,
    /// The corners in doubles.
    rounded: Vec<[f64; 3]>,
    faces: Vec<Face<N>>,
}

/// The part of their size by which products of rounded vectors decide on which side of a plane a corner lies; closer
/// ones are decided by numbers with bounds.
const CLEAR_SIDE: f64 = 1e-9;

impl<N: Number> Polytope<N> {
    /// The octahedron of three points with a positive determinant and the opposite ones.
    pub(super) fn octahedron(points: [[N; 3]; 3], end: [N; 3]) -> Self {
        let mut polytope = Self { end, corners: Vec::new(), rounded: Vec::new(), faces: Vec::new() };
        let [x, y, z] = points.map(|point| {
            let opposite = mirror_image(&point);
            [polytope.corner(point), polytope.corner(opposite)]
        });
        for signs in 0..8 {
            let [i, j, k] = [signs & 1, signs >> 1 & 1, signs >> 2];
            let corners = [x[i], y[j], z[k]];
            let turns = (i + j + k) % 2 == 1;
            polytope.add_face(if turns { [corners[0], corners[2], corners[1]] } else { corners });
        }
        polytope
    }

    /// How many corners the surface has had.
    pub(super) fn vertex_count(&self) -> usize {
        self.corners.len()
    }

    /// The normal of the face that is nearest to p or has p farthest behind it, and a lower bound of its distance.
    pub(super) fn nearest(&self) -> ([N; 3], f64) {
        let nearest = self.faces.iter().min_by(|a, b| a.distance.total_cmp(&b.distance));
        let Face { normal, distance, .. } = nearest.expect("a closed surface has faces");
        (normal.clone(), *distance)
    }

    /// Adds a point of the body and the opposite one; `false` if neither is certainly outside of the surface.
    pub(super) fn add_with_mirror_image(&mut self, point: [N; 3]) -> bool {
        let opposite = mirror_image(&point);
        let is_added = self.add(point);
        self.add(opposite) || is_added
    }

    /// The faces that see the point from outside give way to triangles from their common boundary to it; `false`, and
    /// the surface stays as it is, if none does, and if rounding would tear it.
    ///
    /// A surface like a sphere with c corners has at most 2c − 4 faces. Where rounding shows the point to scattered
    /// faces there would be more, and their number could double with each corner.
    fn add(&mut self, point: [N; 3]) -> bool {
        let rounded = point.each_ref().map(N::rounded);
        let mut open = Vec::<[usize; 2]>::new();
        let faces = std::mem::take(&mut self.faces);
        let (seen, kept): (Vec<_>, Vec<_>) = faces.into_iter().partition(|face| self.is_beyond(face, &point, &rounded));
        for face in &seen {
            let [a, b, c] = face.corners;
            for [from, to] in [[a, b], [b, c], [c, a]] {
                match open.iter().position(|edge| *edge == [to, from]) {
                    Some(place) => drop(open.swap_remove(place)),
                    None => open.push([from, to]),
                }
            }
        }
        let is_torn = kept.len() + open.len() > 2 * (self.corners.len() + 1) - 4;
        self.faces = kept;
        if open.is_empty() || is_torn {
            self.faces.extend(seen);
            return false;
        }
        let apex = self.corner(point);
        for [from, to] in open {
            self.add_face([from, to, apex]);
        }
        true
    }

    /// Whether a point is certainly on the outer side of the plane of a face.
    fn is_beyond(&self, face: &Face<N>, point: &[N; 3], rounded: &[f64; 3]) -> bool {
        let corner = face.corners[0];
        let difference: [f64; 3] = std::array::from_fn(|k| rounded[k] - self.rounded[corner][k]);
        let value = dot(&face.direction, &difference);
        let size = max_norm(&face.direction) * max_norm(rounded).max(max_norm(&self.rounded[corner]));
        if value.abs() > CLEAR_SIDE * size {
            return value > 0.0;
        }
        let difference = std::array::from_fn(|k| point[k].minus(&self.corners[corner][k]));
        dot(&face.normal, &difference).is_certainly_positive()
    }

    fn corner(&mut self, point: [N; 3]) -> usize {
        self.rounded.push(point.each_ref().map(N::rounded));
        self.corners.push(point);
        self.corners.len() - 1
    }

    fn add_face(&mut self, corners: [usize; 3]) {
        let [a, b, c] = corners.map(|corner| &self.corners[corner]);
        let from_first = |v: &[N; 3]| std::array::from_fn(|k| v[k].minus(&a[k]));
        let normal = cross(&from_first(b), &from_first(c));
        let to_plane = std::array::from_fn(|k| a[k].minus(&self.end[k]));
        let [distance, _] = N::over_length(&dot(&normal, &to_plane), &normal);
        let direction = N::direction(&normal);
        self.faces.push(Face { corners, normal, direction, distance });
    }
}

/// The opposite point.
fn mirror_image<N: Number>(point: &[N; 3]) -> [N; 3] {
    point.each_ref().map(|c| N::ZERO.minus(c))
}
