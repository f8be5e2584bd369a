//! A body of many generators and its reductions to few.

use crate::figure::{Figure, FigureError, FigureInput};
use crate::scene::page::{Frame, PageBox, PagePoint, WorldBox};
use crate::scene::text::{Anchor, TextStyle};
use crate::scene::{LegendEntry, Panel, Sample, Scene};
use crate::style::{ENCLOSING, GREY, INPUT, Paint, REFLECTED, Stroke, text_size, weight};
use zonotope::reduction::hausdorff::excess;
use zonotope::reduction::{Method, Problem};
use zonotope::zonotope::Zonotope;

/// The reductions.
pub const FIGURE: Figure = Figure {
    id: "reductions",
    title: "A zonogon of 24 generators and its reductions to 6",
    caption: "Each rule of order reduction finds a zonogon of at most 6 generators around the body. The bar is where \
              it is farthest from it: its length is the Hausdorff distance, given below each name in diameters of the \
              body. It is a bound between two that differ by at most one per cent.",
    claims: &["lemma-5.5", "lemma-5.5-containment"],
    experiments: &[],
    deterministic: true,
    draw,
};

const GENERATORS: usize = 24;
const COUNT: usize = 6;
const RULES: [Method; 6] =
    [Method::Clusters, Method::Patches, Method::Girard, Method::Combastel, Method::Pca, Method::Scott];
const COLUMNS: usize = 3;
const CELL: [f64; 2] = [270.0, 252.0];
const BODY: Paint = Paint::fill(INPUT, 0.3).with_outline(Stroke::new(INPUT, weight::MEDIUM));
const REDUCED: Paint = Paint::fill(ENCLOSING, 0.1).with_outline(Stroke::new(ENCLOSING, 2.0));
const GAP: Stroke = Stroke::new(REFLECTED, 1.5 * weight::STRONG);

/// The bounds of a distance differ by this part of it at most.
const WIDTH: f64 = 0.01;

fn draw(_: &FigureInput<'_>) -> Result<String, FigureError> {
    let body = body();
    let rows = RULES.len().div_ceil(COLUMNS);
    let (width, height) = (CELL[0] * COLUMNS as f64, CELL[1] * rows as f64);
    let mut scene = Scene::new(width, height + 32.0, FIGURE.title, FIGURE.caption);
    let reductions: Vec<(Method, Zonotope<2>)> = RULES.into_iter().map(|rule| (rule, reduced(&body, rule))).collect();
    let all: Vec<[f64; 2]> = reductions.iter().flat_map(|(_, reduced)| reduced.vertices()).collect();
    for (number, (rule, reduced)) in reductions.iter().enumerate() {
        let (left, top) = (CELL[0] * (number % COLUMNS) as f64, CELL[1] * (number / COLUMNS) as f64);
        let window = PageBox::new(left + 14.0, top + 46.0, CELL[0] - 28.0, CELL[1] - 56.0);
        let frame = Frame::fit(&WorldBox::around(&all), window);
        let distance = draw_pair(&mut Panel::new(&mut scene, frame), &body, reduced);
        let middle = left + CELL[0] / 2.0;
        scene.heading(PagePoint::new(middle, top + 20.0), rule.title());
        let style = TextStyle::new(text_size::NOTE, GREY);
        let note = format!("{distance:.3} diameters");
        scene.text(PagePoint::new(middle, top + 38.0), Anchor::Middle, &style, &note);
    }
    let entries = [
        LegendEntry::new(Sample::Area(BODY), "body"),
        LegendEntry::new(Sample::Area(REDUCED), "zonogon of at most 6 generators"),
        LegendEntry::new(Sample::Line(GAP), "where it is farthest from the body"),
    ];
    scene.legend(PagePoint::new(0.0, height), width, &entries);
    Ok(scene.finish())
}

/// Draws both bodies and the gap; returns the distance in diameters.
fn draw_pair(panel: &mut Panel<'_>, body: &Zonotope<2>, reduced: &Zonotope<2>) -> f64 {
    panel.polygon(&reduced.vertices(), &REDUCED);
    panel.polygon(&body.vertices(), &BODY);
    let distance = excess(reduced, body, WIDTH);
    let farthest = reduced.support(distance.direction).point();
    let nearest = [0, 1].map(|k| farthest[k] - distance.lower * distance.direction[k]);
    panel.segment(nearest, farthest, &GAP);
    let point = Zonotope::new(body.center(), Vec::new()).expect("the centre is finite");
    distance.upper / (2.0 * excess(body, &point, WIDTH).lower)
}

fn reduced(body: &Zonotope<2>, rule: Method) -> Zonotope<2> {
    let problem = Problem::new(body, COUNT).expect("six generators are enough in the plane");
    rule.reduce(&problem).expect("the body is far from the range's ends").body
}

/// Generators of many directions, those near one of them longer.
fn body() -> Zonotope<2> {
    let generators = (0..GENERATORS).map(|index| {
        let turn = libm::fmod(0.381_966_011_250_105_1 * index as f64, 1.0);
        let (sine, cosine) = libm::sincos(std::f64::consts::PI * turn);
        let length = 1.0 + 2.0 * cosine * cosine;
        [length * cosine, length * sine]
    });
    Zonotope::new([0.0; 2], generators.collect()).expect("the generators are finite")
}
