//! A mesh inside of a zonohedron: the triangles that are turned to the eye, shaded, between the hidden edges of the
//! body and its faces in front.

use crate::scene::Panel;
use crate::solid::{Camera, Face};
use crate::style::{Dash, ENCLOSING, GREY, INPUT, PAPER, Paint, Stroke, weight};

/// The mesh, as a legend shows it.
pub const MESH: Paint = Paint::fill(INPUT, 0.85);
/// The zonohedron around it.
pub const ZONOHEDRON: Paint = Paint::fill(ENCLOSING, 0.1).with_outline(Stroke::new(ENCLOSING, weight::MEDIUM));
const HIDDEN: Paint = Paint::outline(Stroke::new(GREY, weight::FINE).dashed(Dash::Dotted).faded(0.7));

/// The triangles of a mesh that are turned to the eye, the farthest first.
#[derive(Clone, Debug, PartialEq)]
pub struct Skin {
    triangles: Vec<SeenTriangle>,
}

#[derive(Clone, Debug, PartialEq)]
struct SeenTriangle {
    /// The corners on the page.
    corners: [[f64; 2]; 3],
    /// How squarely the triangle is turned to the eye.
    squareness: f64,
    /// The sum of the heights of the corners along the rays.
    nearness: f64,
}

impl Skin {
    /// What a camera sees of the triangles; their corners run counter-clockwise as seen from outside.
    pub fn seen(camera: &Camera, vertices: &[[f64; 3]], triangles: &[[usize; 3]]) -> Self {
        let seen = |triangle: &[usize; 3]| {
            let corners = triangle.map(|corner| vertices[corner]);
            let face = Face::of_triangle(corners);
            camera.sees(&face).then(|| SeenTriangle {
                corners: corners.map(|corner| camera.project(corner)),
                squareness: camera.squareness(&face),
                nearness: corners.iter().map(|&corner| camera.nearness(corner)).sum(),
            })
        };
        let mut triangles: Vec<SeenTriangle> = triangles.iter().filter_map(seen).collect();
        triangles.sort_by(|a, b| a.nearness.total_cmp(&b.nearness));
        Self { triangles }
    }
}

/// Draws the mesh in the body with these faces.
pub fn draw_inside(panel: &mut Panel<'_>, camera: &Camera, faces: &[Face], skin: &Skin) {
    let place = |face: &Face| face.corners.iter().map(|&corner| camera.project(corner)).collect::<Vec<_>>();
    for face in faces.iter().filter(|face| !camera.sees(face)) {
        panel.polygon(&place(face), &HIDDEN);
    }
    for triangle in &skin.triangles {
        let shade = INPUT.mixed(PAPER, (40.0 + 150.0 * triangle.squareness) as u16);
        panel.polygon(&triangle.corners, &Paint::fill(shade, 1.0).with_outline(Stroke::new(shade, 0.4)));
    }
    for face in faces.iter().filter(|face| camera.sees(face)) {
        panel.polygon(&place(face), &ZONOHEDRON);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_turned_away_is_left_out_and_the_nearest_comes_last() {
        let camera = Camera::from_direction([0.0, -1.0, 0.0]);
        let vertices =
            [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.0, -2.0, 0.0], [1.0, -2.0, 0.0], [0.0, -2.0, 1.0]];
        let seen = Skin::seen(&camera, &vertices, &[[3, 4, 5], [0, 2, 1], [0, 1, 2]]);
        let depths: Vec<f64> = seen.triangles.iter().map(|triangle| triangle.nearness).collect();
        assert_eq!(depths, [0.0, 6.0]);
    }
}
