//! The forces that prove a lower bound, and their zonotope in the unit disc.

use crate::figure::{Figure, FigureError, FigureInput};
use crate::scene::page::{Frame, PageBox, PagePoint, WorldBox};
use crate::scene::text::{Anchor, TextStyle};
use crate::scene::{LegendEntry, Panel, Sample, Scene};
use crate::style::{
    Dash, ENCLOSING, GREY, INPUT_POINT, Marker, OPTIMUM, Paint, REFLECTED, Shape, Stroke, text_size, weight,
};
use std::f64::consts::TAU;
use zonotope::enclosing::min_length;
use zonotope::enclosing::min_total_length::{MinLengthZonotope, Net, by_direction_net};
use zonotope::zonotope::Zonotope;

/// The dual zonotope.
pub const FIGURE: Figure = Figure {
    id: "dual-zonotope",
    title: "What proves that no zonogon is shorter",
    caption: "Left: points, a short zonogon around them, and forces λ at some of the points that add up to zero. \
              Right: the zonogon Σ [−1, 1] λ of the forces, scaled so that its farthest vertices lie on the unit \
              circle. Then no zonotope around the points has a total length below Σ λ · p. Above, along a coarse net: \
              the farthest vertices are not where the net has directions, and the bound suffers. Below, along \
              directions found as needed, each that of a farthest vertex: the dual zonogon reaches the circle just \
              along the edges of the zonogon, and the bound meets the length.",
    claims: &["theorem-4.7"],
    experiments: &[],
    deterministic: true,
    draw,
};

const POINTS: [[f64; 2]; 7] = [[0.0, 1.0], [3.0, -1.0], [7.0, 0.0], [9.0, 3.0], [6.0, 6.0], [2.0, 5.0], [4.5, 2.5]];
const CELL: [f64; 2] = [400.0, 330.0];
const ZONOGON: Paint = Paint::fill(ENCLOSING, 0.08).with_outline(Stroke::new(ENCLOSING, weight::STRONG));
const FORCE: Stroke = Stroke::new(REFLECTED, weight::STRONG);
const DUAL: Paint = Paint::fill(REFLECTED, 0.12).with_outline(Stroke::new(REFLECTED, weight::MEDIUM));
const CIRCLE: Stroke = Stroke::new(GREY, weight::MEDIUM).dashed(Dash::Dashed);
const FARTHEST: Marker = Marker::new(Shape::Star, 8.0, OPTIMUM);
const CIRCLE_POINTS: usize = 120;
/// The distance from the circle below which a vertex is marked.
const MARKED_DISTANCE: f64 = 1e-4;

fn draw(_: &FigureInput<'_>) -> Result<String, FigureError> {
    let coarse = by_direction_net::min_length_by_net(&POINTS, 0.9, Net::Cells, &mut ()).expect("the points are finite");
    let fine = min_length(&POINTS, 1e-6).expect("the points are finite");
    let (width, height) = (2.0 * CELL[0], 2.0 * CELL[1]);
    let mut scene = Scene::new(width, height + 44.0, FIGURE.title, FIGURE.caption);
    for (row, (words, answer)) in [("a coarse net", &coarse), ("directions as needed", &fine)].into_iter().enumerate() {
        let top = CELL[1] * row as f64;
        let window = |column: f64| PageBox::new(CELL[0] * column + 40.0, top + 58.0, CELL[0] - 80.0, CELL[1] - 80.0);
        scene.heading(PagePoint::new(CELL[0] * 0.5, top + 24.0), words);
        scene.heading(PagePoint::new(CELL[0] * 1.5, top + 24.0), "its dual zonogon");
        let style = TextStyle::new(text_size::NOTE, GREY);
        let length = format!("length {:.4}", answer.value);
        scene.text(PagePoint::new(CELL[0] * 0.5, top + 43.0), Anchor::Middle, &style, &length);
        let bound = format!("proves at least {:.4}: ratio {:.4}", answer.lower_bound, answer.ratio());
        scene.text(PagePoint::new(CELL[0] * 1.5, top + 43.0), Anchor::Middle, &style, &bound);
        let (forces, dual) = scaled_forces(answer);
        draw_points(&mut scene, window(0.0), answer, &forces);
        draw_dual(&mut scene, window(1.0), &dual);
    }
    let entries = [
        LegendEntry::new(Sample::Point(INPUT_POINT), "point"),
        LegendEntry::new(Sample::Area(ZONOGON), "zonogon"),
        LegendEntry::new(Sample::Line(FORCE), "force λ"),
        LegendEntry::new(Sample::Line(CIRCLE), "unit circle"),
        LegendEntry::new(Sample::Point(FARTHEST), "farthest vertices"),
    ];
    scene.legend(PagePoint::new(0.0, height + 8.0), width, &entries);
    Ok(scene.finish())
}

/// A point, from 0, and its multiplier.
type Force = (usize, [f64; 2]);

fn norm([x, y]: [f64; 2]) -> f64 {
    (x * x + y * y).sqrt()
}

/// The forces, each with its point, and their zonogon, divided by the distance of its farthest vertex.
fn scaled_forces(answer: &MinLengthZonotope<2>) -> (Vec<Force>, Vec<[f64; 2]>) {
    let vectors: Vec<[f64; 2]> = answer.proof.multipliers.iter().map(|force| force.vector).collect();
    let dual = Zonotope::new([0.0; 2], vectors).expect("forces are finite").vertices();
    let farthest = dual.iter().map(|&v| norm(v)).fold(f64::MIN_POSITIVE, f64::max);
    let forces =
        answer.proof.multipliers.iter().map(|force| (force.point, force.vector.map(|c| c / farthest))).collect();
    (forces, dual.into_iter().map(|v| v.map(|c| c / farthest)).collect())
}

fn draw_points(scene: &mut Scene, window: PageBox, answer: &MinLengthZonotope<2>, forces: &[Force]) {
    /// The length, in units of the picture, of an arrow for a force of length 1.
    const FORCE_LENGTH: f64 = 5.0;
    let corners = answer.body.vertices();
    let tip = |(point, force): &Force| [0, 1].map(|c| POINTS[*point][c] + FORCE_LENGTH * force[c]);
    let tips: Vec<[f64; 2]> = forces.iter().map(tip).collect();
    let mut panel = Panel::new(scene, Frame::fit(&WorldBox::around(corners.iter().chain(&tips)), window));
    panel.polygon(&corners, &ZONOGON);
    for ((point, _), tip) in forces.iter().zip(&tips) {
        panel.arrow(POINTS[*point], *tip, &FORCE);
    }
    panel.markers(&POINTS, &INPUT_POINT);
}

fn draw_dual(scene: &mut Scene, window: PageBox, dual: &[[f64; 2]]) {
    let angle = |i: usize| TAU * i as f64 / CIRCLE_POINTS as f64;
    let circle: Vec<[f64; 2]> = (0..CIRCLE_POINTS).map(|i| [libm::cos(angle(i)), libm::sin(angle(i))]).collect();
    let mut panel = Panel::new(scene, Frame::fit(&WorldBox::around(&circle), window));
    panel.polygon(dual, &DUAL);
    panel.polygon(&circle, &Paint::outline(CIRCLE));
    for vertex in dual.iter().filter(|v| norm(**v) > 1.0 - MARKED_DISTANCE) {
        panel.marker(*vertex, &FARTHEST);
    }
}
