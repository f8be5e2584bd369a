//! The shortest zonogons around an outline along more and more directions.

use crate::figure::{Figure, FigureError, FigureInput};
use crate::scene::page::{Frame, PageBox, PagePoint, WorldBox};
use crate::scene::text::{Anchor, TextStyle};
use crate::scene::{LegendEntry, Panel, Sample, Scene};
use crate::style::{ENCLOSING, FOCUS, GREY, INPUT, Paint, Stroke, text_size, weight};
use experiments::data::outline;
use std::f64::consts::PI;
use zonotope::enclosing::fixed_directions::{Enclosure, FixedDirections, min_length_along};
use zonotope::enclosing::min_length;
use zonotope::zonotope::Zonotope;

/// The zonogons.
pub const FIGURE: Figure = Figure {
    id: "zonogons-along-directions",
    title: "Shortest zonogons around an outline along k directions",
    caption: "The outline of Norway, its longitudes shortened by the cosine of its middle latitude, in the zonogon of \
              least total length whose edges have k evenly spread directions, shown as rays; below each number the \
              total length as a multiple of the least over all directions, which is the last picture. Edges of unused \
              directions are missing.",
    claims: &["theorem-4.6", "linear-program"],
    experiments: &[],
    deterministic: true,
    draw,
};

const COUNTS: [usize; 7] = [2, 3, 4, 6, 8, 12, 16];
const COLUMNS: usize = 4;
const CELL: [f64; 2] = [206.0, 252.0];
const LAND: Paint = Paint::fill(INPUT, 0.3).with_outline(Stroke::new(INPUT, 0.5));
const ZONOGON: Paint = Paint::fill(ENCLOSING, 0.08).with_outline(Stroke::new(ENCLOSING, 2.0));
const RAY: Stroke = Stroke::new(FOCUS, weight::FINE);

fn draw(_: &FigureInput<'_>) -> Result<String, FigureError> {
    let points = shortened(&outline("norway").expect("the outline is among the data").points);
    let best = min_length(&points, 1e-9).expect("the outline's coordinates are finite");
    let rows = (COUNTS.len() + 1).div_ceil(COLUMNS);
    let (width, height) = (CELL[0] * COLUMNS as f64, CELL[1] * rows as f64);
    let mut scene = Scene::new(width, height + 30.0, FIGURE.title, FIGURE.caption);
    for (number, &count) in COUNTS.iter().enumerate() {
        let directions = spread(count);
        let (zonogon, length) = along(&points, &directions);
        let note = format!("{:.3} × least length", length / best.value);
        draw_cell(&mut scene, number, &format!("$k$ = {count}"), &note, &points, &zonogon, &directions);
    }
    draw_cell(&mut scene, COUNTS.len(), "all directions", "least length", &points, &best.body, &[]);
    let entries = [
        LegendEntry::new(Sample::Area(LAND), "outline"),
        LegendEntry::new(Sample::Area(ZONOGON), "zonogon of least total length"),
        LegendEntry::new(Sample::Line(RAY), "its directions"),
    ];
    scene.legend(PagePoint::new(0.0, height), width, &entries);
    Ok(scene.finish())
}

fn shortened(points: &[[f64; 2]]) -> Vec<[f64; 2]> {
    let latitudes = WorldBox::around(points);
    let shortening = libm::cos((latitudes.min[1] / 2.0 + latitudes.max[1] / 2.0).to_radians());
    points.iter().map(|p| [shortening * p[0], p[1]]).collect()
}

/// `count` unit vectors at equal angles on a half circle.
fn spread(count: usize) -> Vec<[f64; 2]> {
    let angle = |i: usize| PI * i as f64 / count as f64;
    (0..count).map(|i| [libm::cos(angle(i)), libm::sin(angle(i))]).collect()
}

fn along(points: &[[f64; 2]], directions: &[[f64; 2]]) -> (Zonotope<2>, f64) {
    let weights = vec![1.0; directions.len()];
    let problem = FixedDirections::new(points, directions, &weights).expect("the coordinates are finite");
    let Ok(Enclosure::Optimal(answer)) = min_length_along(&problem, &mut ()) else {
        unreachable!("two different directions or more span the plane")
    };
    (answer.zonotope(&problem).expect("the outline is far from the range's ends"), answer.value)
}

fn draw_cell(
    scene: &mut Scene,
    number: usize,
    heading: &str,
    note: &str,
    points: &[[f64; 2]],
    zonogon: &Zonotope<2>,
    directions: &[[f64; 2]],
) {
    let (left, top) = (CELL[0] * (number % COLUMNS) as f64, CELL[1] * (number / COLUMNS) as f64);
    // The rays stand on the left of heading and note.
    let middle = left + CELL[0] / 2.0 + if directions.is_empty() { 0.0 } else { 10.0 };
    scene.heading(PagePoint::new(middle, top + 20.0), heading);
    let style = TextStyle::new(text_size::NOTE, GREY);
    scene.text(PagePoint::new(middle, top + 38.0), Anchor::Middle, &style, note);
    let hub = PagePoint::new(left + 22.0, top + 27.0);
    for [x, y] in directions {
        scene.segment(hub.moved(-14.0 * x, 14.0 * y), hub.moved(14.0 * x, -14.0 * y), &RAY);
    }
    let corners = zonogon.vertices();
    let window = PageBox::new(left + 14.0, top + 50.0, CELL[0] - 28.0, CELL[1] - 60.0);
    let mut panel = Panel::new(scene, Frame::fit(&WorldBox::around(&corners), window));
    panel.polygon(&corners, &ZONOGON);
    panel.polygon(points, &LAND);
}
