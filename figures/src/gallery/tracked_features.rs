//! The closest features of two bodies, tracked from frame to frame while one of them translates.

use crate::figure::{Figure, FigureError, FigureInput};
use crate::scene::page::{Frame, PageBox, PagePoint, WorldBox};
use crate::scene::text::{Anchor, TextStyle};
use crate::scene::{LegendEntry, Panel, Sample, Scene};
use crate::solid::{self, Camera, Face, cross, dot};
use crate::style::{
    Color, ENCLOSING, GREY, INK, INPUT, Marker, OPTIMUM, Paint, REFLECTED, Shape, Stroke, text_size, weight,
};
use zonotope::arrangement::facet_walk::{FacetName, NormalSense};
use zonotope::collision::distance::{FeatureKind, Proximity};
use zonotope::collision::tracking::WalkingTracker;
use zonotope::zonotope::Zonotope;

/// The closest features.
pub const FIGURE: Figure = Figure {
    id: "tracked-features",
    title: "Closest features of two bodies, from frame to frame",
    caption: "The small body translates past the large one in 73 frames; seven of them are drawn. Left, the nearest \
              points of the two bodies. Right, the same motion as the tracker sees it: the displacement of the centres \
              moves beside the sum of one body and the reflected other one, and the tracker walks over the facets of \
              that sum to the nearest point, whose mark tells in what least face it is. Shaded facets are those at \
              which a frame's walk ended.",
    claims: &["local-walk"],
    experiments: &[],
    deterministic: true,
    draw,
};

const LARGE: [[f64; 3]; 5] = [[1.0, 0.2, 0.0], [-0.3, 1.0, 0.1], [0.1, -0.2, 0.9], [0.6, 0.5, 0.5], [-0.5, 0.4, 0.4]];
const SMALL: [[f64; 3]; 3] = [[0.4, 0.1, 0.0], [-0.1, 0.3, 0.15], [0.05, -0.15, 0.35]];

const FRAMES: usize = 73;

/// Each so many frames the bodies are drawn.
const STRIDE: usize = 12;

const EYE: [f64; 3] = [3.0, -4.0, 2.2];

const PANEL: [f64; 2] = [470.0, 430.0];
const TOP: f64 = 40.0;
const LEGEND: f64 = 62.0;
const MOVING: Paint = Paint::fill(REFLECTED, 0.16).with_outline(Stroke::new(REFLECTED, weight::FINE));
const PATH: Stroke = Stroke::new(INK, weight::MEDIUM);
const GAP: Stroke = Stroke::new(INK, weight::FINE);
const EDGE: Stroke = Stroke::new(INPUT, weight::FINE);

/// The facts about a frame.
struct Tracked {
    displacement: [f64; 3],
    /// The nearest points of both bodies.
    points: [[f64; 3]; 2],
    /// The least face of the sum that holds the nearest point.
    kind: FeatureKind,
    /// The normal of the facet at which the walk ended, of any length.
    normal: [f64; 3],
    steps: u64,
}

fn draw(_: &FigureInput<'_>) -> Result<String, FigureError> {
    let [large, small] = [&LARGE[..], &SMALL[..]].map(|generators| at([0.0; 3], generators));
    let sum = at([0.0; 3], &[&LARGE[..], &SMALL[..]].concat());
    let frames = tracked(&large, &small);
    let camera = Camera::from_direction(EYE);
    let mut scene = Scene::new(2.0 * PANEL[0], TOP + PANEL[1] + LEGEND, FIGURE.title, FIGURE.caption);
    for (column, heading) in ["Both bodies", "Their sum, and the displacement of the centres"].into_iter().enumerate() {
        scene.heading(PagePoint::new(PANEL[0] * (column as f64 + 0.5), 22.0), heading);
    }

    let moved: Vec<Zonotope<3>> = frames.iter().step_by(STRIDE).map(|frame| at(frame.displacement, &SMALL)).collect();
    let corners = moved.iter().chain([&large]).flat_map(|body| outline(&camera, body)).collect::<Vec<_>>();
    let mut panel = Panel::new(&mut scene, frame_around(&corners, 0.0));
    solid::draw(&mut panel, &camera, &solid::faces_of(&large), |face| paint(&camera, face), |_| EDGE);
    for body in &moved {
        panel.polygon(&outline(&camera, body), &MOVING);
    }
    draw_gaps(&mut panel, &camera, &frames, |frame| frame.points);

    let path: Vec<[f64; 2]> = frames.iter().map(|frame| camera.project(frame.displacement)).collect();
    let corners = [outline(&camera, &sum), path.clone()].concat();
    let mut panel = Panel::new(&mut scene, frame_around(&corners, 1.0));
    let visited = |face: &Face| frames.iter().any(|frame| are_along(face.normal, frame.normal));
    let shade = |face: &Face| if visited(face) { Paint::fill(INPUT, 0.42) } else { paint(&camera, face) };
    solid::draw(&mut panel, &camera, &solid::faces_of(&sum), shade, |_| EDGE);
    panel.polyline(&path, &PATH);
    draw_gaps(&mut panel, &camera, &frames, |frame| [nearest_of_sum(frame), frame.displacement]);

    let steps: u64 = frames.iter().skip(1).map(|frame| frame.steps).sum();
    let most = frames.iter().skip(1).map(|frame| frame.steps).max().unwrap_or(0);
    let note = format!("{FRAMES} frames, {steps} edges crossed after the first one, at most {most} in a frame");
    let style = TextStyle::new(text_size::NOTE, GREY);
    scene.text(PagePoint::new(PANEL[0], TOP + PANEL[1] + 4.0), Anchor::Middle, &style, &note);
    let kinds = [
        (FeatureKind::Facet, "inside a facet of the sum"),
        (FeatureKind::Edge, "inside an edge"),
        (FeatureKind::Vertex, "a corner"),
    ];
    let seen = kinds.into_iter().filter(|(kind, _)| frames.iter().any(|frame| frame.kind == *kind));
    let marks = seen.map(|(kind, text)| LegendEntry::new(Sample::Point(mark(kind)), text));
    let entries: Vec<LegendEntry<'_>> =
        marks.chain([LegendEntry::new(Sample::Area(MOVING), "the body that moves")]).collect();
    scene.legend(PagePoint::new(0.0, TOP + PANEL[1] + 14.0), 2.0 * PANEL[0], &entries);
    Ok(scene.finish())
}

/// All frames by the tracker, the nearest points by the distance of the two bodies.
fn tracked(large: &Zonotope<3>, small: &Zonotope<3>) -> Vec<Tracked> {
    let mut tracker = WalkingTracker::new(large, small).expect("the bodies span space");
    let frames = (0..FRAMES).filter_map(|number| {
        let displacement = displacement(number as f64 / (FRAMES - 1) as f64);
        let frame = tracker.frame([0.0; 3], displacement).expect("the places are finite");
        let (kind, steps, normal) = (frame.closest()?, frame.steps(), normal(frame.facet()));
        let Proximity::Disjoint(gap) = large.proximity(&at(displacement, &SMALL)) else { return None };
        Some(Tracked { displacement, points: gap.points, kind, normal, steps })
    });
    frames.collect()
}

/// The displacement of the centres at a time from 0 to 1: a curve beside the sum, on the side of the eye.
fn displacement(time: f64) -> [f64; 3] {
    let (sine, cosine) = libm::sincos(std::f64::consts::PI * (1.27 + 0.83 * time));
    let height = 1.3 * libm::sin(std::f64::consts::TAU * time);
    [3.3 * cosine, 3.1 * sine, height]
}

/// The body that moves, with its centre at a place.
fn at(center: [f64; 3], generators: &[[f64; 3]]) -> Zonotope<3> {
    Zonotope::new(center, generators.to_vec()).expect("the generators are finite")
}

/// The outward normal of a facet of the sum, by its name.
fn normal(facet: FacetName) -> [f64; 3] {
    let generator = |index: usize| LARGE.iter().chain(&SMALL).nth(index).copied().unwrap_or_default();
    let normal = cross(generator(facet.first), generator(facet.second));
    match facet.normal {
        NormalSense::Along => normal,
        NormalSense::Against => normal.map(|c| -c),
    }
}

/// Whether two vectors have one direction, up to rounding.
fn are_along(a: [f64; 3], b: [f64; 3]) -> bool {
    dot(a, b) > (1.0 - 1e-9) * (dot(a, a) * dot(b, b)).sqrt()
}

/// The point of the sum that is nearest to the displacement of the centres.
fn nearest_of_sum(frame: &Tracked) -> [f64; 3] {
    let [first, second] = frame.points;
    std::array::from_fn(|k| frame.displacement[k] - (second[k] - first[k]))
}

/// The corners of what is seen of a body: those of the projected generators' zonogon.
fn outline(camera: &Camera, body: &Zonotope<3>) -> Vec<[f64; 2]> {
    let projected = body.generators().iter().map(|&v| camera.project(v)).collect();
    Zonotope::new(camera.project(body.center()), projected).expect("the generators of a body are finite").vertices()
}

fn frame_around(corners: &[[f64; 2]], column: f64) -> Frame {
    let window = PageBox::new(PANEL[0] * column + 20.0, TOP + 6.0, PANEL[0] - 40.0, PANEL[1] - 26.0);
    Frame::fit(&WorldBox::around(corners), window)
}

/// Lighter the more squarely a face is turned to the eye.
fn paint(camera: &Camera, face: &Face) -> Paint {
    Paint::fill(INPUT, 0.2 - 0.14 * camera.squareness(face))
}

/// Draws the segments between nearest points, stronger where the bodies are drawn, and the marks of the first ones.
fn draw_gaps(panel: &mut Panel<'_>, camera: &Camera, frames: &[Tracked], points: impl Fn(&Tracked) -> [[f64; 3]; 2]) {
    for (number, frame) in frames.iter().enumerate() {
        let [from, to] = points(frame).map(|point| camera.project(point));
        let stroke = if number.is_multiple_of(STRIDE) { GAP } else { GAP.faded(0.25) };
        panel.segment(from, to, &stroke);
    }
    for frame in frames {
        panel.marker(camera.project(points(frame)[0]), &mark(frame.kind));
    }
}

/// The mark of a nearest point by the face that holds it.
fn mark(kind: FeatureKind) -> Marker {
    let color: Color = match kind {
        FeatureKind::Facet => ENCLOSING,
        FeatureKind::Edge => OPTIMUM,
        FeatureKind::Vertex => INK,
    };
    Marker::new(Shape::Disc, 3.2, color)
}
