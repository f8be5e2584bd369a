//! Bodies at a time, seen from a fixed direction.

use zonotope::motion::Motion;
use zonotope::zonotope::Zonotope;

use crate::own_data::{OwnDataError, check_size};
use crate::scene::Panel;
use crate::solid::{self, Camera, Face, faces_of};
use crate::style::{Color, Paint, Stroke, weight};

/// The direction from which bodies are seen.
const EYE: [f64; 3] = [3.0, -4.0, 2.6];

/// Of bodies with more generators the outline alone is drawn.
const SEEN_THROUGH_LIMIT: usize = 12;

/// The point of view, and the point of space that the coordinates on the page begin from.
#[derive(Debug, Clone, Copy)]
pub(super) struct View {
    pub(super) camera: Camera,
    origin: [f64; 3],
}

impl View {
    /// A view of what is near a point.
    pub(super) fn around(origin: [f64; 3]) -> Self {
        Self { camera: Camera::from_direction(EYE), origin }
    }

    /// The body at a time of its motion.
    pub(super) fn placed(&self, body: &Zonotope<3>, motion: &Motion, time: f64) -> Result<Placed, OwnDataError> {
        let pose = motion.pose_at(time).ok_or(OwnDataError::OutOfRange)?;
        let (matrix, moved) = (pose.matrix(), pose.translation());
        let turned = |v: &[f64; 3]| matrix.map(|row| solid::dot(row, *v));
        let center = turned(&body.center());
        let center = [0, 1, 2].map(|k| center[k] + (moved[k] - self.origin[k]));
        self.body(center, body.generators().iter().map(turned).collect(), matrix)
    }

    /// A body where it is.
    pub(super) fn still(&self, body: &Zonotope<3>) -> Result<Placed, OwnDataError> {
        let center = body.center();
        let identity = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        self.body([0, 1, 2].map(|k| center[k] - self.origin[k]), body.generators().to_vec(), identity)
    }

    fn body(&self, center: [f64; 3], generators: Vec<[f64; 3]>, matrix: [[f64; 3]; 3]) -> Result<Placed, OwnDataError> {
        check_size(&[center.as_slice(), generators.as_flattened()].concat())?;
        let body = Zonotope::new(center, generators).map_err(|_| OwnDataError::OutOfRange)?;
        let shadow = body.generators().iter().map(|&g| self.camera.project(g)).collect();
        let shadow = Zonotope::new(self.camera.project(center), shadow).map_err(|_| OwnDataError::OutOfRange)?;
        Ok(Placed { outline: shadow.vertices(), body, matrix })
    }
}

/// A body at a time.
#[derive(Debug, Clone)]
pub(super) struct Placed {
    pub(super) body: Zonotope<3>,
    /// The corners of its shadow on the page.
    pub(super) outline: Vec<[f64; 2]>,
    /// The rotation of its motion.
    pub(super) matrix: [[f64; 3]; 3],
}

impl Placed {
    /// Draws the outline.
    pub(super) fn draw_outline(&self, panel: &mut Panel<'_>, paint: &Paint) {
        panel.polygon(&self.outline, paint);
    }

    /// Draws the faces, or the outline where there are none or too many.
    pub(super) fn draw(&self, panel: &mut Panel<'_>, camera: &Camera, color: Color) {
        let faces = if self.body.generators().len() > SEEN_THROUGH_LIMIT { Vec::new() } else { faces_of(&self.body) };
        let edge = Stroke::new(color, weight::FINE);
        let paint = |face: &Face| Paint::fill(color, 0.16 + 0.22 * camera.squareness(face));
        solid::draw(panel, camera, &faces, paint, |_| edge);
        let border = Paint::outline(Stroke::new(color, weight::MEDIUM));
        self.draw_outline(
            panel,
            &if faces.is_empty() { Paint { fill: Some((color, 0.24)), ..border } } else { border },
        );
    }

    /// A point that is farthest along a direction.
    pub(super) fn farthest(&self, u: [f64; 3]) -> [f64; 3] {
        self.body.support(u).point()
    }
}
