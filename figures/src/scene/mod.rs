//! A picture: areas, lines, points and labels on a page, written as SVG whose bytes depend on nothing but the input.
//!
//! [`Scene`] draws on the page; [`Panel`] draws in world coordinates through a [`Frame`](page::Frame), clipped where
//! needed. Labels are collected and placed last, clear of everything drawn (see `labels.rs`). The document uses plain
//! attributes only (no style sheet, no ids), so that many pictures can stand in one page of HTML.

mod labels;
mod legend;
pub mod page;
mod panel;
pub mod text;

pub use legend::{LegendEntry, Sample};
pub use panel::Panel;

use self::labels::{Obstacle, Request};
use self::page::{PageBox, PagePoint, decimals};
use self::text::{Anchor, Line, TextStyle};
use crate::style::{INK, Marker, PAPER, Paint, Shape, Stroke, text_size};
use svg::node::element::{Circle, Element, Group, Polygon, Polyline, Rectangle};
use svg::node::{Blob, Text};

/// A picture in the making.
#[derive(Debug)]
pub struct Scene {
    page: PageBox,
    title: String,
    description: String,
    drawn: Group,
    requests: Vec<Request>,
    obstacles: Vec<Obstacle>,
}

impl Scene {
    /// An empty page with a title and a description for readers who hear the picture.
    pub fn new(width: f64, height: f64, title: &str, description: &str) -> Self {
        Self {
            page: PageBox::new(0.0, 0.0, width, height),
            title: title.into(),
            description: description.into(),
            drawn: Group::new().set("stroke-linejoin", "round").set("stroke-linecap", "round"),
            requests: Vec::new(),
            obstacles: Vec::new(),
        }
    }

    /// The whole page.
    pub const fn page(&self) -> &PageBox {
        &self.page
    }

    /// Draws a closed polygon.
    pub fn polygon(&mut self, corners: &[PagePoint], paint: &Paint) {
        let mut element: Element = Polygon::new().set("points", listed(corners)).into();
        paint_on(&mut element, paint);
        self.add(element);
        if paint.stroke.is_some() {
            self.avoid_chain(corners);
            if let (Some(&last), Some(&first)) = (corners.last(), corners.first()) {
                self.obstacles.push(Obstacle::Segment(last, first));
            }
        }
    }

    /// Draws an open chain of segments.
    pub fn polyline(&mut self, points: &[PagePoint], stroke: &Stroke) {
        let mut element: Element = Polyline::new().set("points", listed(points)).into();
        paint_on(&mut element, &Paint::outline(*stroke));
        self.add(element);
        self.avoid_chain(points);
    }

    /// Draws a segment.
    pub fn segment(&mut self, from: PagePoint, to: PagePoint, stroke: &Stroke) {
        let mut element: Element = svg::node::element::Line::new()
            .set("x1", decimals(from.x))
            .set("y1", decimals(from.y))
            .set("x2", decimals(to.x))
            .set("y2", decimals(to.y))
            .into();
        stroke_on(&mut element, stroke);
        self.add(element);
        self.obstacles.push(Obstacle::Segment(from, to));
    }

    /// Draws a segment with a head at its end; a segment too short for a head stays without one.
    pub fn arrow(&mut self, from: PagePoint, to: PagePoint, stroke: &Stroke) {
        let (dx, dy) = (to.x - from.x, to.y - from.y);
        let length = (dx * dx + dy * dy).sqrt();
        let head = 3.0 + 3.2 * stroke.width;
        if length <= head {
            self.segment(from, to, stroke);
            return;
        }
        let (ux, uy) = (dx / length, dy / length);
        let base = to.moved(-head * ux, -head * uy);
        self.segment(from, base, stroke);
        let half = 0.42 * head;
        self.polygon(
            &[to, base.moved(-half * uy, half * ux), base.moved(half * uy, -half * ux)],
            &Paint::fill(stroke.color, stroke.opacity),
        );
    }

    /// Marks a point.
    pub fn marker(&mut self, place: PagePoint, marker: &Marker) {
        let radius = marker.radius;
        match marker.shape {
            Shape::Disc | Shape::Ring => {
                let element =
                    Circle::new().set("cx", decimals(place.x)).set("cy", decimals(place.y)).set("r", decimals(radius));
                let element = if marker.shape == Shape::Disc {
                    element.set("fill", marker.color.hex())
                } else {
                    element.set("fill", PAPER.hex()).set("stroke", marker.color.hex()).set("stroke-width", "1.6")
                };
                self.add(element);
            }
            Shape::Diamond => {
                let corners = [(0.0, -1.0), (1.0, 0.0), (0.0, 1.0), (-1.0, 0.0)]
                    .map(|(x, y)| place.moved(x * radius, y * radius));
                self.rimmed(&corners, marker);
            }
            Shape::Star => {
                let corners: Vec<PagePoint> = STAR.iter().map(|[x, y]| place.moved(x * radius, y * radius)).collect();
                self.rimmed(&corners, marker);
            }
            Shape::Cross => {
                let stroke = Stroke::new(marker.color, 1.6);
                let (a, b) = (radius, -radius);
                self.segment(place.moved(b, b), place.moved(a, a), &stroke);
                self.segment(place.moved(b, a), place.moved(a, b), &stroke);
            }
        }
        self.obstacles.push(Obstacle::Solid(PageBox::new(
            place.x - radius,
            place.y - radius,
            2.0 * radius,
            2.0 * radius,
        )));
    }

    fn rimmed(&mut self, corners: &[PagePoint], marker: &Marker) {
        let paint = Paint::fill(marker.color, 1.0).with_outline(Stroke::new(PAPER, 1.0));
        let mut element: Element = Polygon::new().set("points", listed(corners)).into();
        paint_on(&mut element, &paint);
        self.add(element);
    }

    /// Writes a line of text at a fixed place.
    pub fn text(&mut self, place: PagePoint, anchor: Anchor, style: &TextStyle, source: &str) {
        let line = Line::parse(source);
        self.obstacles.push(Obstacle::Solid(line.extent(place, anchor, style)));
        self.add(Blob::new(line.element(place, anchor, style)));
    }

    /// Writes the heading of a panel, its base line's middle at `place`.
    pub fn heading(&mut self, place: PagePoint, source: &str) {
        let style = TextStyle::new(text_size::HEADING, INK).bold();
        self.text(place, Anchor::Middle, &style, source);
    }

    /// Asks for a label near `anchor`, preferably in the direction `wish` (page coordinates; zero: anywhere).
    pub fn label(&mut self, anchor: PagePoint, wish: [f64; 2], style: &TextStyle, source: &str) {
        self.requests.push(Request { line: Line::parse(source), style: style.haloed(), anchor, wish, gap: 6.5 });
    }

    /// Keeps labels off the segment between two places without drawing it.
    pub fn avoid(&mut self, from: PagePoint, to: PagePoint) {
        self.obstacles.push(Obstacle::Segment(from, to));
    }

    fn avoid_chain(&mut self, points: &[PagePoint]) {
        for pair in points.windows(2) {
            self.avoid(pair[0], pair[1]);
        }
    }

    fn add(&mut self, node: impl Into<Box<dyn svg::Node>>) {
        svg::Node::append(&mut self.drawn, node);
    }

    /// Places the labels and writes the document.
    pub fn finish(mut self) -> String {
        let places = labels::place(&self.requests, &self.obstacles, &self.page.inset(2.0));
        for (request, place) in std::mem::take(&mut self.requests).iter().zip(places) {
            let element = request.line.element(place, Anchor::Start, &request.style);
            self.add(Blob::new(element));
        }
        let background = Rectangle::new().set("width", "100%").set("height", "100%").set("fill", PAPER.hex());
        let mut title = Element::new("title");
        svg::Node::append(&mut title, Text::new(self.title));
        let mut description = Element::new("desc");
        svg::Node::append(&mut description, Text::new(self.description));
        let (width, height) = (decimals(self.page.max.x), decimals(self.page.max.y));
        let document = svg::Document::new()
            .set("role", "img")
            .set("width", width.as_str())
            .set("height", height.as_str())
            .set("viewBox", format!("0 0 {width} {height}"))
            .add(title)
            .add(description)
            .add(background)
            .add(self.drawn);
        format!("{document}\n")
    }
}

/// A star of five rays in the unit circle, y downwards: sin and −cos of multiples of 36 degrees, inner radius 0.45.
const STAR: [[f64; 2]; 10] = [
    [0.0, -1.0],
    [0.2645, -0.3641],
    [0.9511, -0.3090],
    [0.4280, 0.1391],
    [0.5878, 0.8090],
    [0.0, 0.45],
    [-0.5878, 0.8090],
    [-0.4280, 0.1391],
    [-0.9511, -0.3090],
    [-0.2645, -0.3641],
];

fn listed(points: &[PagePoint]) -> String {
    let listed: Vec<String> =
        points.iter().map(|point| format!("{},{}", decimals(point.x), decimals(point.y))).collect();
    listed.join(" ")
}

fn paint_on(element: &mut Element, paint: &Paint) {
    let attributes = element.get_attributes_mut();
    match paint.fill {
        Some((color, opacity)) => {
            attributes.insert("fill".into(), color.hex().into());
            if opacity < 1.0 {
                attributes.insert("fill-opacity".into(), decimals(opacity).into());
            }
        }
        None => {
            attributes.insert("fill".into(), "none".into());
        }
    }
    if let Some(stroke) = &paint.stroke {
        stroke_on(element, stroke);
    }
}

fn stroke_on(element: &mut Element, stroke: &Stroke) {
    let attributes = element.get_attributes_mut();
    attributes.insert("stroke".into(), stroke.color.hex().into());
    attributes.insert("stroke-width".into(), decimals(stroke.width).into());
    if let Some(pattern) = stroke.dash.pattern() {
        attributes.insert("stroke-dasharray".into(), pattern.into());
    }
    if stroke.opacity < 1.0 {
        attributes.insert("stroke-opacity".into(), decimals(stroke.opacity).into());
    }
}

#[cfg(test)]
mod tests;
