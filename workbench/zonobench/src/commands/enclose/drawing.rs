//! A picture of an answer.

use std::path::Path;

use figures::scene::page::WorldBox;
use figures::scene::{LegendEntry, Sample};
use figures::style::{ENCLOSING, INPUT, INPUT_POINT, Marker, OPTIMAL_CENTER, Paint, Shape, Stroke, weight};
use zonotope::numeric::dyadic::Dyadic;
use zonotope::numeric::scaling::binary_exponent;

use crate::commands::page::{Page, stride, thinned};
use crate::enclosure::Enclosure;

/// The most corners of a hull that are marked; of a hull with more of them the outline alone is drawn.
const MARKED_CORNER_LIMIT: usize = 200;

/// Points, hull, zonogon and centre; scaled by a power of two, so that nothing leaves the range of doubles.
pub(super) fn draw(file: &Path, points: &[[f64; 2]], enclosure: &Enclosure) -> String {
    let found = &enclosure.found;
    let shrink = -i64::from(binary_exponent(largest(points)).unwrap_or(0));
    let small = |coordinates: [Dyadic; 2]| coordinates.map(|coordinate| coordinate.scaled(shrink).to_f64());
    let place = |point: &[f64; 2]| small(point.map(Dyadic::from_f64));
    let exact_vertices = found.body.exact_vertices();
    let vertex_count = exact_vertices.len();
    let vertices: Vec<[f64; 2]> = thinned(exact_vertices).map(small).collect();
    let hull_vertices: Vec<[f64; 2]> = thinned(found.proof.hull().vertices().iter()).map(place).collect();
    let center = place(&found.body.center());
    let name = file.file_name().unwrap_or(file.as_os_str()).to_string_lossy();
    let title = format!("Smallest zonogon around {name}");
    let description = format!(
        "{} points, their convex hull with {} vertices, and the enclosing zonogon of least area with {} vertices.",
        points.len(),
        found.proof.hull().vertex_count(),
        vertex_count
    );
    let world = WorldBox::around(vertices.iter().chain(&hull_vertices));
    let mut page = Page::new(world, 2, &title, &description);
    let mut panel = page.panel();

    let zonogon = Paint::fill(ENCLOSING, 0.1).with_outline(Stroke::new(ENCLOSING, weight::STRONG));
    let hull = Paint::fill(INPUT, 0.12).with_outline(Stroke::new(INPUT, weight::MEDIUM));
    let dot = Marker::new(Shape::Disc, 1.4, INPUT);
    panel.polygon(&vertices, &zonogon);
    panel.polygon(&hull_vertices, &hull);
    let shown: Vec<[f64; 2]> = thinned(points.iter()).map(place).collect();
    panel.markers(&shown, &dot);
    if found.proof.hull().vertex_count() <= MARKED_CORNER_LIMIT {
        panel.markers(&hull_vertices, &INPUT_POINT);
    }
    panel.marker(center, &OPTIMAL_CENTER);

    let some = match stride(points.len()) {
        1 => "points".to_owned(),
        stride => format!("points, one in {stride}"),
    };
    let legend = [
        LegendEntry::new(Sample::Point(dot), &some),
        LegendEntry::new(Sample::Area(hull), "convex hull"),
        LegendEntry::new(Sample::Area(zonogon), "smallest enclosing zonogon"),
        LegendEntry::new(Sample::Point(OPTIMAL_CENTER), "its centre"),
    ];
    page.finish(&legend)
}

fn largest(points: &[[f64; 2]]) -> f64 {
    points.iter().flatten().fold(0.0, |largest, coordinate| largest.max(coordinate.abs()))
}
