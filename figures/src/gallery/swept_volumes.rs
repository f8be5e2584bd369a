//! Zonotopes around the placements of a turning body, beside samples of these placements.

use crate::figure::{Figure, FigureError, FigureInput};
use crate::scene::page::{Frame, PageBox, PagePoint, WorldBox};
use crate::scene::text::{Anchor, TextStyle};
use crate::scene::{LegendEntry, Panel, Sample, Scene};
use crate::solid::Camera;
use crate::style::{ENCLOSING, GREY, INPUT, Paint, Stroke, text_size, weight};
use experiments::moving::swept::Placements;
use zonotope::motion::space_time::{Method, Sweep, volumes_of_intervals};
use zonotope::motion::{Motion, MotionPiece};
use zonotope::zonotope::{Zonotope, combinatorics};

/// The volumes.
pub const FIGURE: Figure = Figure {
    id: "swept-volumes",
    title: "Zonotopes around what a turning link sweeps",
    caption: "A link turns about an axis at its end, and each outline is a zonotope around all of its placements, some \
              of which are drawn. Below each name the volume that exceeds that of the convex hull of sampled \
              placements, in per cent of it; of the chain of parts it is the largest excess of one part over its own.",
    claims: &["theorem-6.1", "interval-bisection", "placements-by-vertices"],
    experiments: &[],
    deterministic: true,
    draw,
};

const DEGREES: f64 = 100.0;
/// The volumes of a chain.
const PARTS: u32 = 4;
/// Placements that are drawn.
const DRAWN: u32 = 6;
const COLUMNS: usize = 4;
const CELL: [f64; 2] = [215.0, 214.0];
const PLACEMENT: Paint = Paint::fill(INPUT, 0.18).with_outline(Stroke::new(INPUT, weight::FINE));
const VOLUME: Paint = Paint::fill(ENCLOSING, 0.08).with_outline(Stroke::new(ENCLOSING, weight::STRONG));

fn draw(_: &FigureInput<'_>) -> Result<String, FigureError> {
    let angle = DEGREES.to_radians();
    let (link, axis) = (link(), [0.0, 0.0, 1.0]);
    let sweep = Sweep::new([0.0; 3], axis, angle, [0.0; 3]).expect("an axis and an angle");
    let placements = Placements::of(&link, &sweep);
    let hull = placements.hull_volume().expect("a link has a volume");
    let excess = |volume: &Zonotope<3>, hull: f64| 100.0 * (combinatorics(volume).measure.to_f64_fast() / hull - 1.0);
    let mut pictures: Vec<(&str, Vec<Zonotope<3>>, f64)> = Vec::new();
    for (method, name) in NAMES {
        let volume = link.swept_by(&sweep, method).expect("the volume is in range");
        let excess = excess(&volume, hull);
        pictures.push((name, vec![volume], excess));
    }
    let rational = link.swept(&turn(angle)).expect("the volume is in range");
    let over = excess(&rational, hull);
    pictures.push(("box of control points", vec![rational], over));
    let chain = volumes_of_intervals(&sweep, &link, PARTS, Method::ByMiddlePlacement).expect("they are in range");
    let part = Sweep::new([0.0; 3], axis, angle / f64::from(PARTS), [0.0; 3]).expect("an axis and an angle");
    let own = Placements::of(&link, &part).hull_volume().expect("a link has a volume");
    let over = chain.iter().map(|volume| excess(volume, own)).fold(0.0, f64::max);
    pictures.push(("four parts", chain, over));

    let rows = pictures.len().div_ceil(COLUMNS);
    let (width, height) = (CELL[0] * COLUMNS as f64, CELL[1] * rows as f64);
    let mut scene = Scene::new(width, height + 32.0, FIGURE.title, FIGURE.caption);
    let camera = Camera::from_direction([-1.0, -1.6, 2.6]);
    let outlines = |bodies: &[Zonotope<3>]| bodies.iter().map(|body| outline(&camera, body)).collect::<Vec<_>>();
    let all: Vec<[f64; 2]> = pictures.iter().flat_map(|(_, bodies, _)| outlines(bodies)).flatten().collect();
    let world = WorldBox::around(&all);
    for (number, (name, bodies, over)) in pictures.iter().enumerate() {
        let (left, top) = (CELL[0] * (number % COLUMNS) as f64, CELL[1] * (number / COLUMNS) as f64);
        let middle = left + CELL[0] / 2.0;
        scene.heading(PagePoint::new(middle, top + 20.0), name);
        let note = format!("excess {over:.0} %");
        scene.text(PagePoint::new(middle, top + 38.0), Anchor::Middle, &TextStyle::new(text_size::NOTE, GREY), &note);
        let window = PageBox::new(left + 8.0, top + 46.0, CELL[0] - 16.0, CELL[1] - 54.0);
        let mut panel = Panel::new(&mut scene, Frame::fit(&world, window));
        for time in (0..=DRAWN).map(|i| f64::from(i) / f64::from(DRAWN)) {
            panel.polygon(&outline(&camera, &placements.placed_at(time)), &PLACEMENT);
        }
        outlines(bodies).iter().for_each(|corners| panel.polygon(corners, &VOLUME));
    }
    let entries = [
        LegendEntry::new(Sample::Area(PLACEMENT), "placements of the link"),
        LegendEntry::new(Sample::Area(VOLUME), "zonotope around all placements"),
    ];
    scene.legend(PagePoint::new(0.0, height), width, &entries);
    Ok(scene.finish())
}

const NAMES: [(Method, &str); 6] = [
    (Method::ByFarthestVertex, "Theorem 6.1"),
    (Method::ByMiddlePlacement, "from the middle"),
    (Method::ByLeastRectangle, "least rectangle"),
    (Method::ByLeastZonogon, "least zonogon"),
    (Method::ByShadow, "shadow of the body"),
    (Method::ByTurnedGenerators, "turned generators"),
];

fn link() -> Zonotope<3> {
    let generators = vec![[1.0, 0.0, 0.0], [0.0, 0.16, 0.0], [0.12, 0.12, 0.0], [0.0, 0.0, 0.14]];
    Zonotope::new([1.2, 0.0, 0.0], generators).expect("the numbers are finite")
}

/// The turn as a rational motion.
fn turn(angle: f64) -> Motion {
    let (sine, cosine) = libm::sincos(angle / 2.0);
    let piece = MotionPiece {
        until: 1.0,
        from: [1.0, 0.0, 0.0, 0.0],
        to: [cosine, 0.0, 0.0, sine],
        axis_point: [0.0; 3],
        translation: [0.0; 3],
    };
    Motion::from_pieces(&[piece]).expect("less than half a turn")
}

/// The corners of a body as it is seen.
fn outline(camera: &Camera, body: &Zonotope<3>) -> Vec<[f64; 2]> {
    let seen = body.generators().iter().map(|g| camera.project(*g)).collect();
    Zonotope::new(camera.project(body.center()), seen).expect("the numbers are finite").vertices()
}
