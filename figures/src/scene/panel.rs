//! Drawing in world coordinates.

use super::Scene;
use super::page::{Frame, PageBox, PagePoint};
use super::text::TextStyle;
use crate::style::{Marker, Paint, Stroke};

/// A view of a part of the page through a [`Frame`].
#[derive(Debug)]
pub struct Panel<'a> {
    scene: &'a mut Scene,
    frame: Frame,
}

impl<'a> Panel<'a> {
    /// Looks at `scene` through `frame`.
    pub const fn new(scene: &'a mut Scene, frame: Frame) -> Self {
        Self { scene, frame }
    }

    /// The map to the page.
    pub const fn frame(&self) -> &Frame {
        &self.frame
    }

    /// The page behind, for what is drawn in page coordinates.
    pub const fn scene(&mut self) -> &mut Scene {
        self.scene
    }

    /// The place of a point of the world on the page.
    pub fn place(&self, point: [f64; 2]) -> PagePoint {
        self.frame.place(point)
    }

    fn places(&self, points: &[[f64; 2]]) -> Vec<PagePoint> {
        points.iter().map(|&point| self.place(point)).collect()
    }

    /// Draws a closed polygon.
    pub fn polygon(&mut self, corners: &[[f64; 2]], paint: &Paint) {
        let corners = self.places(corners);
        self.scene.polygon(&corners, paint);
    }

    /// Draws an open chain of segments.
    pub fn polyline(&mut self, points: &[[f64; 2]], stroke: &Stroke) {
        let points = self.places(points);
        self.scene.polyline(&points, stroke);
    }

    /// Draws a segment.
    pub fn segment(&mut self, from: [f64; 2], to: [f64; 2], stroke: &Stroke) {
        let (from, to) = (self.place(from), self.place(to));
        self.scene.segment(from, to, stroke);
    }

    /// Draws an arrow.
    pub fn arrow(&mut self, from: [f64; 2], to: [f64; 2], stroke: &Stroke) {
        let (from, to) = (self.place(from), self.place(to));
        self.scene.arrow(from, to, stroke);
    }

    /// Draws the part inside `window` of the line through `point` in a direction; returns its ends, if it has any,
    /// the one that the direction points to last.
    pub fn line(
        &mut self,
        point: [f64; 2],
        direction: [f64; 2],
        window: &PageBox,
        stroke: &Stroke,
    ) -> Option<(PagePoint, PagePoint)> {
        let (from, to) = self.line_inside(point, direction, window)?;
        self.scene.segment(from, to, stroke);
        Some((from, to))
    }

    /// The part inside `window` of the line through `point` in a direction.
    pub fn line_inside(
        &self,
        point: [f64; 2],
        direction: [f64; 2],
        window: &PageBox,
    ) -> Option<(PagePoint, PagePoint)> {
        let middle = self.place(point);
        let ahead = self.place([point[0] + direction[0], point[1] + direction[1]]);
        let (dx, dy) = (ahead.x - middle.x, ahead.y - middle.y);
        let length = (dx * dx + dy * dy).sqrt();
        if length == 0.0 {
            return None;
        }
        let center = window.center();
        let away = ((middle.x - center.x).abs() + (middle.y - center.y).abs()) + window.width() + window.height();
        let (sx, sy) = (dx / length * away, dy / length * away);
        window.clip(middle.moved(-sx, -sy), middle.moved(sx, sy))
    }

    /// Marks a point.
    pub fn marker(&mut self, point: [f64; 2], marker: &Marker) {
        let place = self.place(point);
        self.scene.marker(place, marker);
    }

    /// Marks points.
    pub fn markers(&mut self, points: &[[f64; 2]], marker: &Marker) {
        for &point in points {
            self.marker(point, marker);
        }
    }

    /// Asks for a label near a point, preferably in the direction `wish` of the world.
    pub fn label(&mut self, point: [f64; 2], wish: [f64; 2], style: &TextStyle, source: &str) {
        let place = self.place(point);
        self.scene.label(place, [wish[0], -wish[1]], style, source);
    }
}
