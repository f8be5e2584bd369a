//! The stretches of time by which the methods prove one motion free of contact.

use crate::figure::{Figure, FigureError, FigureInput};
use crate::scene::Scene;
use crate::scene::page::PagePoint;
use crate::scene::text::{Anchor, TextStyle};
use crate::style::{GREY, INK, PALE, Paint, Stroke, method_color, text_size, weight};
use experiments::moving::MovingBodies;
use families::motions::find;
use zonotope::motion::continuous::{FirstContact, Method};

/// The time bar.
pub const FIGURE: Figure = Figure {
    id: "motion-time-bar",
    title: "The stretches of time by which one motion is proved free",
    caption: "A box on an arm swings half a turn past a cube, one thousandth of a unit apart when it is nearest. The \
              curve is their distance over the time. Each bar is cut where a method's stretches end: within a stretch \
              one direction separates the bodies at every time, and the number of stretches stands at the right.",
    claims: &["interval-bisection", "summary-space-time"],
    experiments: &[],
    deterministic: true,
    draw,
};

const SEED: u64 = 3;
const CLEARANCE: f64 = 1e-3;
/// Two times between which a contact would be.
const RESOLUTION: f64 = 1e-9;
const WIDTH: f64 = 860.0;
const LEFT: f64 = 236.0;
const RIGHT: f64 = 64.0;
const CURVE: [f64; 2] = [16.0, 116.0];
const BAR: [f64; 2] = [20.0, 34.0];
/// Samples of the distance.
const SAMPLES: u32 = 200;

fn draw(_: &FigureInput<'_>) -> Result<String, FigureError> {
    let family = find("swing_180").expect("it is among the families");
    let moving = MovingBodies::at_clearance(family, SEED, CLEARANCE).expect("the box swings past the cube");
    let height = CURVE[1] + 24.0 + BAR[1] * Method::ALL.len() as f64 + 40.0;
    let mut scene = Scene::new(WIDTH, height, FIGURE.title, FIGURE.caption);
    let across = |time: f64| LEFT + time * (WIDTH - LEFT - RIGHT);
    let label = TextStyle::new(text_size::LABEL, INK);
    let note = TextStyle::new(text_size::NOTE, GREY);

    let times = (0..=SAMPLES).map(|i| f64::from(i) / f64::from(SAMPLES));
    let distances: Vec<[f64; 2]> = times.map(|time| [time, moving.distance_at(time)]).collect();
    let most = distances.iter().map(|[_, distance]| *distance).fold(0.0, f64::max);
    let place =
        |[time, distance]: [f64; 2]| PagePoint::new(across(time), CURVE[1] - (CURVE[1] - CURVE[0]) * distance / most);
    scene.segment(place([0.0, 0.0]), place([1.0, 0.0]), &Stroke::new(PALE, weight::MEDIUM));
    let curve: Vec<PagePoint> = distances.into_iter().map(place).collect();
    scene.polyline(&curve, &Stroke::new(INK, weight::MEDIUM));
    scene.text(PagePoint::new(LEFT - 14.0, 70.0), Anchor::End, &label, "distance of the bodies");

    for (row, method) in Method::ALL.into_iter().enumerate() {
        let top = CURVE[1] + 24.0 + BAR[1] * row as f64;
        let (bodies, motions) = (moving.bodies.each_ref(), moving.motions.each_ref());
        let found = method.first_contact(bodies, motions, RESOLUTION, &mut ());
        assert!(matches!(found, FirstContact::Separate { .. }), "the bodies are apart");
        for (index, stretch) in found.free().iter().enumerate() {
            let (from, until) = (across(stretch.from), across(stretch.until));
            let corners = [(from, top), (until, top), (until, top + BAR[0]), (from, top + BAR[0])];
            let fill = Paint::fill(method_color(method.id()), if index % 2 == 0 { 0.75 } else { 0.35 });
            scene.polygon(&corners.map(|(x, y)| PagePoint::new(x, y)), &fill);
        }
        let base = top + 15.0;
        scene.text(PagePoint::new(LEFT - 14.0, base), Anchor::End, &label, NAMES[row]);
        let count = found.free().len().to_string();
        scene.text(PagePoint::new(WIDTH - RIGHT + 12.0, base), Anchor::Start, &label, &count);
    }
    let bottom = height - 20.0;
    for (time, text) in [(0.0, "0"), (0.5, "time"), (1.0, "1")] {
        scene.text(PagePoint::new(across(time), bottom), Anchor::Middle, &note, text);
    }
    Ok(scene.finish())
}

/// Names of the methods, in the order of their registry.
const NAMES: [&str; Method::ALL.len()] =
    ["control points", "chord", "conservative advancement", "Theorem 6.1 and bisection"];
