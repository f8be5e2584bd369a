//! Control zonotopes of a stretch of time, and the direction that separates all of them from the origin.

use crate::figure::{Figure, FigureError, FigureInput};
use crate::scene::page::{Frame, PageBox, PagePoint, WorldBox};
use crate::scene::text::TextStyle;
use crate::scene::{LegendEntry, Panel, Sample, Scene};
use crate::style::{CENTER, Dash, ENCLOSING, FOCUS, INK, INPUT, Paint, REFLECTED, Stroke, text_size, weight};
use zonotope::motion::continuous::{FirstContact, SeparatingDirection, first_contact};
use zonotope::motion::{Motion, MotionPiece};
use zonotope::zonotope::Zonotope;

/// The control zonotopes.
pub const FIGURE: Figure = Figure {
    id: "control-zonotopes",
    title: "Control zonotopes and the direction that proves a stretch of time",
    caption: "On the left a link turns past a box; on the right the same as one question about the origin. The gap \
              along a direction, times a positive polynomial, has three Bernstein coefficients: each is the least \
              value along it of one zonotope. The first and the last of them are the differences of the bodies at \
              both ends of the turn, the middle one is the control zonotope between them. A line with the origin \
              on one side and all three on the other proves that the bodies are apart during the whole turn.",
    claims: &["question-4d-intersection", "interval-bisection"],
    experiments: &[],
    deterministic: true,
    draw,
};

const LINK_CENTER: [f64; 2] = [1.1, 0.0];
const LINK: [[f64; 2]; 2] = [[1.0, 0.0], [0.0, 0.12]];
const BLOCK_CENTER: [f64; 2] = [1.0, -0.75];
const BLOCK: [[f64; 2]; 2] = [[0.55, -0.1], [0.06, 0.3]];
/// The quaternion [w, z] at both ends: the second one turns by about 53 degrees.
const TURNS: [[f64; 2]; 2] = [[1.0, 0.0], [2.0, 1.0]];
const PLACEMENTS: u32 = 5;

const WIDTH: f64 = 860.0;
const HEIGHT: f64 = 330.0;
const LINK_PAINT: Paint = Paint::fill(INPUT, 0.16).with_outline(Stroke::new(INPUT, weight::MEDIUM));
const BLOCK_PAINT: Paint = Paint::fill(REFLECTED, 0.16).with_outline(Stroke::new(REFLECTED, weight::MEDIUM));
const END: Paint = Paint::fill(ENCLOSING, 0.12).with_outline(Stroke::new(ENCLOSING, weight::MEDIUM));
const BETWEEN: Paint = Paint::fill(FOCUS, 0.16).with_outline(Stroke::new(FOCUS, weight::MEDIUM));
const LINE: Stroke = Stroke::new(INK, weight::MEDIUM).dashed(Dash::Dashed);

fn draw(_: &FigureInput<'_>) -> Result<String, FigureError> {
    let u = separating_direction();
    let mut scene = Scene::new(WIDTH, HEIGHT + 40.0, FIGURE.title, FIGURE.caption);
    scene.heading(PagePoint::new(WIDTH / 4.0, 20.0), "a link that turns past a box");
    scene.heading(PagePoint::new(0.75 * WIDTH, 20.0), "three control zonotopes and the origin");
    let window = |left: f64| PageBox::new(left + 14.0, 34.0, WIDTH / 2.0 - 28.0, HEIGHT - 44.0);
    let placements: Vec<Vec<[f64; 2]>> =
        (0..=PLACEMENTS).map(|i| placed(f64::from(i) / f64::from(PLACEMENTS)).vertices()).collect();
    let block = zonogon(BLOCK_CENTER, BLOCK.to_vec());
    let corners: Vec<[f64; 2]> = placements.iter().flatten().copied().chain(block.vertices()).collect();
    let mut panel = Panel::new(&mut scene, Frame::fit(&WorldBox::around(&corners).grown(0.04), window(0.0)));
    placements.iter().for_each(|corners| panel.polygon(corners, &LINK_PAINT));
    panel.polygon(&block.vertices(), &BLOCK_PAINT);
    // the line through the middle of the gap when the link is at the begin
    let support = |body: &Zonotope<2>, u: [f64; 2]| body.support(u).point();
    let (tip, near) = (support(&placed(0.0), u), support(&block, u.map(|c| -c)));
    let middle = [0, 1].map(|k| (tip[k] + near[k]) / 2.0);
    panel.line(middle, [-u[1], u[0]], &window(0.0), &LINE);
    let arrow = |panel: &mut Panel<'_>, from: [f64; 2]| {
        let to = [0, 1].map(|k| from[k] + 0.45 * u[k]);
        panel.arrow(from, to, &Stroke::new(INK, weight::STRONG));
        panel.label(to, u, &TextStyle::new(text_size::LABEL, INK), "$u$");
    };
    arrow(&mut panel, middle);

    let controls = control_zonotopes();
    let corners: Vec<[f64; 2]> = controls.iter().flat_map(Zonotope::vertices).chain([[0.0; 2]]).collect();
    let right = WIDTH / 2.0;
    let mut panel = Panel::new(&mut scene, Frame::fit(&WorldBox::around(&corners).grown(0.06), window(right)));
    for (control, paint) in controls.iter().zip([END, BETWEEN, END]) {
        panel.polygon(&control.vertices(), &paint);
    }
    let least = controls.iter().map(|control| dot(support(control, u.map(|c| -c)), u)).fold(f64::INFINITY, f64::min);
    assert!(least > 0.0, "the direction separates them from the origin");
    let between = u.map(|c| c * least / (2.0 * dot(u, u)));
    panel.line(between, [-u[1], u[0]], &window(right), &LINE);
    panel.marker([0.0; 2], &CENTER);
    arrow(&mut panel, between);
    let entries = [
        LegendEntry::new(Sample::Area(LINK_PAINT), "link"),
        LegendEntry::new(Sample::Area(BLOCK_PAINT), "box"),
        LegendEntry::new(Sample::Area(END), "difference at an end"),
        LegendEntry::new(Sample::Area(BETWEEN), "control zonotope between"),
        LegendEntry::new(Sample::Point(CENTER), "origin"),
        LegendEntry::new(Sample::Line(LINE), "separating line"),
    ];
    scene.legend(PagePoint::new(0.0, HEIGHT), WIDTH, &entries);
    Ok(scene.finish())
}

/// The polar form of w² − z² and 2wz: the rotation times the square of the quaternion's length.
fn rotation([w, z]: [f64; 2], [v, y]: [f64; 2]) -> [[f64; 2]; 2] {
    let (cosine, sine) = (w * v - z * y, w * y + z * v);
    [[cosine, -sine], [sine, cosine]]
}

fn image(matrix: [[f64; 2]; 2], v: [f64; 2]) -> [f64; 2] {
    matrix.map(|row| dot(row, v))
}

fn dot(a: [f64; 2], b: [f64; 2]) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}

fn zonogon(center: [f64; 2], generators: Vec<[f64; 2]>) -> Zonotope<2> {
    Zonotope::new(center, generators).expect("the numbers are finite")
}

/// The link where its quaternion is a part of the way.
fn placed(part: f64) -> Zonotope<2> {
    let turn = [0, 1].map(|k| (1.0 - part) * TURNS[0][k] + part * TURNS[1][k]);
    let matrix = rotation(turn, turn).map(|row| row.map(|c| c / dot(turn, turn)));
    zonogon(image(matrix, LINK_CENTER), LINK.map(|g| image(matrix, g)).to_vec())
}

/// The zonotopes whose least values along a direction are the coefficients of the gap, each over its own weight.
fn control_zonotopes() -> [Zonotope<2>; 3] {
    let [first, last] = TURNS;
    [[first, first], [first, last], [last, last]].map(|[q, r]| {
        let matrix = rotation(q, r).map(|row| row.map(|c| c / dot(q, r)));
        let link = image(matrix, LINK_CENTER);
        let center = [0, 1].map(|k| BLOCK_CENTER[k] - link[k]);
        zonogon(center, LINK.map(|g| image(matrix, g)).into_iter().chain(BLOCK).collect())
    })
}

/// The direction by which the library proves the whole turn, of bodies that are as high as each other.
fn separating_direction() -> [f64; 2] {
    let solid = |center: [f64; 2], generators: &[[f64; 2]]| {
        let flat = generators.iter().map(|&[x, y]| [x, y, 0.0]);
        Zonotope::new([center[0], center[1], 0.0], flat.chain([[0.0, 0.0, 0.1]]).collect()).expect("finite")
    };
    let [first, last] = TURNS.map(|[w, z]| [w, 0.0, 0.0, z]);
    let piece = MotionPiece { until: 1.0, from: first, to: last, axis_point: [0.0; 3], translation: [0.0; 3] };
    let turn = Motion::from_pieces(&[piece]).expect("less than half a turn");
    let (link, block) = (solid(LINK_CENTER, &LINK), solid(BLOCK_CENTER, &BLOCK));
    let found = first_contact([&link, &block], [&turn, &Motion::rest()]);
    let FirstContact::Separate { free } = &found else { panic!("the link turns away from the box") };
    let [stretch] = &free[..] else { panic!("one direction proves the whole turn: {free:?}") };
    let SeparatingDirection::Space([x, y, _]) = stretch.direction else { panic!("it is fixed in space: {stretch:?}") };
    let length = (x * x + y * y).sqrt();
    [x / length, y / length]
}
