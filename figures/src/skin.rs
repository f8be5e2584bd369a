//! A mesh inside of a zonohedron: the faces that are turned to the eye, shaded, between the hidden edges of the
//! body and its faces in front.

use crate::scene::Panel;
use crate::solid::{Camera, Face};
use crate::style::{Dash, ENCLOSING, GREY, INPUT, PAPER, Paint, Stroke, weight};

/// The mesh, as a legend shows it.
pub const MESH: Paint = Paint::fill(INPUT, 0.85);
/// The zonohedron around it.
pub const ZONOHEDRON: Paint = Paint::fill(ENCLOSING, 0.1).with_outline(Stroke::new(ENCLOSING, weight::MEDIUM));
const HIDDEN: Paint = Paint::outline(Stroke::new(GREY, weight::FINE).dashed(Dash::Dotted).faded(0.7));

/// The faces of a mesh that are turned to the eye, the farthest first.
#[derive(Clone, Debug, PartialEq)]
pub struct Skin {
    faces: Vec<SeenFace>,
}

#[derive(Clone, Debug, PartialEq)]
struct SeenFace {
    /// The corners on the page.
    corners: Vec<[f64; 2]>,
    /// The turn of the face to the eye.
    squareness: f64,
    /// The mean of the heights of the corners along the rays.
    nearness: f64,
}

impl Skin {
    /// The view of a camera on the faces, which are lists of vertices; they run counter-clockwise as seen from outside.
    pub fn seen(camera: &Camera, vertices: &[[f64; 3]], faces: &[impl AsRef<[usize]>]) -> Self {
        let seen = |corners: &[usize]| {
            let face = Face::of_polygon(corners.iter().map(|&corner| vertices[corner]).collect());
            let heights: f64 = face.corners.iter().map(|&corner| camera.nearness(corner)).sum();
            camera.sees(&face).then(|| SeenFace {
                corners: face.corners.iter().map(|&corner| camera.project(corner)).collect(),
                squareness: camera.squareness(&face),
                nearness: heights / corners.len() as f64,
            })
        };
        let mut faces: Vec<SeenFace> = faces.iter().filter_map(|corners| seen(corners.as_ref())).collect();
        faces.sort_by(|a, b| a.nearness.total_cmp(&b.nearness));
        Self { faces }
    }
}

/// Draws the mesh in the body with these faces.
pub fn draw_inside(panel: &mut Panel<'_>, camera: &Camera, faces: &[Face], skin: &Skin) {
    let place = |face: &Face| face.corners.iter().map(|&corner| camera.project(corner)).collect::<Vec<_>>();
    for face in faces.iter().filter(|face| !camera.sees(face)) {
        panel.polygon(&place(face), &HIDDEN);
    }
    for face in &skin.faces {
        let shade = INPUT.mixed(PAPER, (40.0 + 150.0 * face.squareness) as u16);
        panel.polygon(&face.corners, &Paint::fill(shade, 1.0).with_outline(Stroke::new(shade, 0.4)));
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
        let depths: Vec<f64> = seen.faces.iter().map(|face| face.nearness).collect();
        assert_eq!(depths, [0.0, 2.0]);
    }

    #[test]
    fn a_face_with_a_notch_is_one_polygon() {
        let camera = Camera::from_direction([0.0, -1.0, 0.0]);
        let corners = [[0.0, 0.0], [2.0, 0.0], [2.0, 1.0], [1.0, 1.0], [1.0, 2.0], [0.0, 2.0]];
        for turn in 0..6 {
            let vertices: Vec<[f64; 3]> = (0..6).map(|k| corners[(k + turn) % 6]).map(|[x, z]| [x, 0.0, z]).collect();
            let seen = Skin::seen(&camera, &vertices, &[[0, 1, 2, 3, 4, 5]]);
            assert_eq!(seen.faces.len(), 1);
            let places: Vec<[f64; 2]> = (0..6).map(|k| corners[(k + turn) % 6]).collect();
            assert_eq!(seen.faces[0].corners, places);
            assert!((seen.faces[0].squareness - 1.0).abs() < 1e-12);
            assert_eq!(Skin::seen(&camera, &vertices, &[[5, 4, 3, 2, 1, 0]]).faces.len(), 0);
        }
    }
}
