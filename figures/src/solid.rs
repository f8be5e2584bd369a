//! Convex bodies of space, drawn in parallel projection.

use crate::scene::Panel;
use crate::style::{Dash, GREY, Paint, Stroke, weight};
use zonotope::zonotope::Zonotope;
use zonotope::zonotope::faces::{Faces, Facet, faces};

/// A face of a convex body.
#[derive(Clone, Debug, PartialEq)]
pub struct Face {
    /// The corners of the face in order around it.
    pub corners: Vec<[f64; 3]>,
    /// An outer normal of any length.
    pub normal: [f64; 3],
    /// For each side, from its corner to the next, the generator that it is parallel to.
    pub sides: Vec<usize>,
}

impl Face {
    /// A polygon, convex or not, whose corners run counter-clockwise as seen from outside. The length of the normal is
    /// twice the area.
    pub fn of_polygon(corners: Vec<[f64; 3]>) -> Self {
        let first = corners.first().copied().unwrap_or_default();
        let arms: Vec<[f64; 3]> = corners.iter().map(|to| std::array::from_fn(|i| to[i] - first[i])).collect();
        let doubled = arms.windows(2).map(|arm| cross(arm[0], arm[1]));
        let normal = doubled.fold([0.0; 3], |sum, part| std::array::from_fn(|i| sum[i] + part[i]));
        Self { sides: (0..corners.len()).collect(), corners, normal }
    }
}

/// The faces of a body of full dimension; a side is named by its zone.
pub fn faces_of(body: &Zonotope<3>) -> Vec<Face> {
    let Ok(Faces::Solid(lattice)) = faces(body, &mut ()) else {
        return Vec::new();
    };
    (0..lattice.facet_count() as u32)
        .map(|facet| {
            let corners: Vec<[f64; 3]> = lattice.facet_vertices(Facet(facet)).map(|v| lattice.point(v)).collect();
            let step = |k: usize| std::array::from_fn(|i| corners[k + 1][i] - corners[k][i]);
            let normal = cross(step(0), step(1));
            let sides = lattice.facet_edges(Facet(facet)).map(|edge| lattice.edge_zone(edge).0 as usize).collect();
            Face { corners, normal, sides }
        })
        .collect()
}

/// The point of view on a body: parallel rays, z upright on the page.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Camera {
    right: [f64; 3],
    up: [f64; 3],
    towards_eye: [f64; 3],
}

impl Camera {
    /// A camera that looks from a direction other than the vertical.
    pub fn from_direction([x, y, z]: [f64; 3]) -> Self {
        let unit = |v: [f64; 3]| {
            let length = dot(v, v).sqrt();
            v.map(|c| c / length)
        };
        let right = unit([-y, x, 0.0]);
        let towards_eye = unit([x, y, z]);
        Self { right, up: cross(towards_eye, right), towards_eye }
    }

    /// The image of a point of space.
    pub fn project(&self, point: [f64; 3]) -> [f64; 2] {
        [dot(self.right, point), dot(self.up, point)]
    }

    /// The nearness of a point to the eye: a height along the rays.
    pub fn nearness(&self, point: [f64; 3]) -> f64 {
        dot(self.towards_eye, point)
    }

    /// Whether a face is turned to the eye.
    pub fn sees(&self, face: &Face) -> bool {
        dot(face.normal, self.towards_eye) > 0.0
    }

    /// The turn of a face to the eye, from 0 (edge on or turned away) to 1.
    pub fn squareness(&self, face: &Face) -> f64 {
        let length = dot(face.normal, face.normal).sqrt();
        (dot(face.normal, self.towards_eye) / length).max(0.0)
    }
}

/// Draws a body: hidden sides dotted, then the faces that are turned to the eye, then their sides.
pub fn draw(
    panel: &mut Panel<'_>,
    camera: &Camera,
    faces: &[Face],
    paint: impl Fn(&Face) -> Paint,
    side: impl Fn(usize) -> Stroke,
) {
    let hidden = Stroke::new(GREY, weight::FINE).dashed(Dash::Dotted).faded(0.7);
    for face in faces.iter().filter(|face| !camera.sees(face)) {
        for (from, to, _) in sides_of(camera, face) {
            panel.segment(from, to, &hidden);
        }
    }
    let seen: Vec<&Face> = faces.iter().filter(|face| camera.sees(face)).collect();
    for face in &seen {
        let corners: Vec<[f64; 2]> = face.corners.iter().map(|&corner| camera.project(corner)).collect();
        panel.polygon(&corners, &paint(face));
    }
    for face in seen {
        for (from, to, generator) in sides_of(camera, face) {
            panel.segment(from, to, &side(generator));
        }
    }
}

fn sides_of<'a>(camera: &'a Camera, face: &'a Face) -> impl Iterator<Item = ([f64; 2], [f64; 2], usize)> + 'a {
    let count = face.corners.len();
    let place = move |k: usize| camera.project(face.corners[k % count]);
    face.sides.iter().enumerate().map(move |(k, &generator)| (place(k), place(k + 1), generator))
}

pub(crate) fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub(crate) fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn z_points_up_and_the_frame_is_right_handed() {
        let camera = Camera::from_direction([3.0, -4.0, 0.0]);
        assert_eq!(camera.project([0.0, 0.0, 2.0]), [0.0, 2.0]);
        let [x, _] = camera.project([4.0, 3.0, 0.0]);
        assert!((x - 5.0).abs() < 1e-12);
    }

    #[test]
    fn a_face_is_seen_from_its_outer_side() {
        let face = Face { corners: vec![[0.0; 3]; 3], normal: [0.0, -2.0, 0.0], sides: vec![0, 1, 2] };
        assert!(Camera::from_direction([1.0, -1.0, 1.0]).sees(&face));
        assert!(!Camera::from_direction([1.0, 1.0, 1.0]).sees(&face));
    }
}
