//! A picture of an answer.

use std::path::Path;

use figures::scene::page::{Frame, PageBox, PagePoint, WorldBox};
use figures::scene::{LegendEntry, Panel, Sample, Scene};
use figures::style::{ENCLOSING, INPUT, INPUT_POINT, Marker, OPTIMAL_CENTER, Paint, Shape, Stroke, weight};

use crate::enclosure::Enclosure;

const WIDTH: f64 = 760.0;
/// The least and the greatest height of the picture proper.
const HEIGHTS: [f64; 2] = [160.0, 560.0];
const MARGIN: f64 = 24.0;
const LEGEND: f64 = 56.0;

/// More points than this are thinned out; the hull shows all of them.
const MOST_POINTS: usize = 4000;

/// Points, hull, zonogon and centre.
pub(super) fn draw(file: &Path, points: &[[f64; 2]], enclosure: &Enclosure) -> String {
    let found = &enclosure.found;
    let vertices = found.zonogon.vertices();
    let name = file.file_name().unwrap_or(file.as_os_str()).to_string_lossy();
    let title = format!("Smallest zonogon around {name}");
    let description = format!(
        "{} points, their convex hull with {} vertices, and the enclosing zonogon of least area with {} vertices.",
        points.len(),
        found.hull.vertex_count(),
        vertices.len()
    );
    let world = WorldBox::around(vertices.iter().chain(found.hull.vertices()));
    let width = WIDTH - 2.0 * MARGIN;
    let height = height_for(&world, width);
    let mut scene = Scene::new(WIDTH, height + 2.0 * MARGIN + LEGEND, &title, &description);
    let page = PageBox::new(MARGIN, MARGIN, width, height);
    let mut panel = Panel::new(&mut scene, Frame::fit(&world, page));

    let zonogon = Paint::fill(ENCLOSING, 0.1).with_outline(Stroke::new(ENCLOSING, weight::STRONG));
    let hull = Paint::fill(INPUT, 0.12).with_outline(Stroke::new(INPUT, weight::MEDIUM));
    let dot = Marker::new(Shape::Disc, 1.4, INPUT);
    panel.polygon(&vertices, &zonogon);
    panel.polygon(found.hull.vertices(), &hull);
    let step = points.len().div_ceil(MOST_POINTS).max(1);
    let shown: Vec<[f64; 2]> = points.iter().copied().step_by(step).collect();
    panel.markers(&shown, &dot);
    if found.hull.vertex_count() <= MOST_POINTS {
        panel.markers(found.hull.vertices(), &INPUT_POINT);
    }
    panel.marker(found.zonogon.center(), &OPTIMAL_CENTER);

    let some = if step > 1 { format!("points, one in {step}") } else { "points".to_owned() };
    let legend = [
        LegendEntry::new(Sample::Point(dot), &some),
        LegendEntry::new(Sample::Area(hull), "convex hull"),
        LegendEntry::new(Sample::Area(zonogon), "smallest enclosing zonogon"),
        LegendEntry::new(Sample::Point(OPTIMAL_CENTER), "its centre"),
    ];
    scene.legend(PagePoint::new(MARGIN, height + 2.0 * MARGIN), width, &legend);
    scene.finish()
}

/// The height at which the world fills the width, within limits; computed on halves, which do not overflow.
fn height_for(world: &WorldBox, width: f64) -> f64 {
    let half = |axis: usize| world.max[axis] / 2.0 - world.min[axis] / 2.0;
    let height = width * (half(1) / half(0));
    if height.is_nan() { HEIGHTS[0] } else { height.clamp(HEIGHTS[0], HEIGHTS[1]) }
}
