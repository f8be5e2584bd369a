//! The levels of a hierarchy around a body and within it.

use crate::figure::{Figure, FigureError, FigureInput};
use crate::scene::page::{Frame, PageBox, PagePoint, WorldBox};
use crate::scene::{LegendEntry, Panel, Sample, Scene};
use crate::style::{Dash, INK, INPUT, Paint, SERIES, Stroke, weight};
use zonotope::collision::hierarchy::Hierarchy;
use zonotope::zonotope::Zonotope;

/// The levels.
pub const FIGURE: Figure = Figure {
    id: "nested-hierarchy",
    title: "Nested levels of a body of 2,000 generators",
    caption: "The body and its levels, seen along an axis: each outer body contains the next finer one, and the inner \
              ones, dashed, lie within the body.",
    claims: &["summary-repeated-tests", "variable-complexity"],
    experiments: &[],
    deterministic: true,
    draw,
};

const GENERATORS: usize = 2000;

/// The levels that can be told apart in the picture, from the coarsest.
const SHOWN: usize = 3;

const WIDTH: f64 = 640.0;
const HEIGHT: f64 = 470.0;
const LEGEND: f64 = 60.0;
const BODY: Paint = Paint::fill(INPUT, 0.25).with_outline(Stroke::new(INK, weight::FINE));

fn draw(_: &FigureInput<'_>) -> Result<String, FigureError> {
    let hierarchy = Hierarchy::new(body());
    let shown = SHOWN.min(hierarchy.level_count() - 1);
    let outlines: Vec<(usize, Vec<[f64; 2]>)> = (0..shown)
        .map(|level| hierarchy.outer(level).body())
        .map(|outer| (outer.generators().len(), outline(outer)))
        .collect();
    let mut scene = Scene::new(WIDTH, HEIGHT + LEGEND, FIGURE.title, FIGURE.caption);
    let frame = Frame::fit(&WorldBox::around(&outlines[0].1), PageBox::new(16.0, 16.0, WIDTH - 32.0, HEIGHT - 32.0));
    let mut panel = Panel::new(&mut scene, frame);
    panel.polygon(&outline(hierarchy.body()), &BODY);
    for (level, (_, outer)) in outlines.iter().enumerate() {
        panel.polygon(outer, &Paint::outline(outer_stroke(level)));
        if let Some(inner) = hierarchy.inner(level) {
            panel.polygon(&outline(inner.body()), &Paint::outline(outer_stroke(level).dashed(Dash::Dashed)));
        }
    }
    let mut entries = vec![(Sample::Area(BODY), format!("body, {GENERATORS} generators"))];
    let levels = outlines.iter().enumerate();
    entries
        .extend(levels.map(|(level, (count, _))| (Sample::Line(outer_stroke(level)), format!("{count} generators"))));
    let entries: Vec<LegendEntry<'_>> = entries.iter().map(|(sample, text)| LegendEntry::new(*sample, text)).collect();
    scene.legend(PagePoint::new(0.0, HEIGHT), WIDTH, &entries);
    Ok(scene.finish())
}

fn outer_stroke(level: usize) -> Stroke {
    Stroke::new(SERIES[level + 1], weight::STRONG)
}

/// The corners of the projection along the second axis.
fn outline(body: &Zonotope<3>) -> Vec<[f64; 2]> {
    let projected = body.generators().iter().map(|&[x, _, z]| [x, z]);
    let zonogon = Zonotope::new([0.0; 2], projected.collect()).expect("the generators of a body are finite");
    zonogon.vertices()
}

/// Generators of all directions, those near the first axis longer.
fn body() -> Zonotope<3> {
    let generators = (0..GENERATORS).map(|index| {
        let height = (index as f64 + 0.5) / GENERATORS as f64;
        let turn = libm::fmod(0.381_966_011_250_105_1 * index as f64, 1.0);
        let (sine, cosine) = libm::sincos(std::f64::consts::TAU * turn);
        let radius = (1.0 - height * height).sqrt();
        [1.6 * radius * cosine, radius * sine, height]
    });
    Zonotope::new([0.0; 3], generators.collect()).expect("the generators are finite")
}
