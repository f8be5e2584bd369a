//! The paper's Figure 3, and what encloses the same arcs more tightly.

use crate::figure::{Figure, FigureError, FigureInput};
use crate::scene::page::{Frame, PageBox, PagePoint, WorldBox};
use crate::scene::text::{Anchor, TextStyle};
use crate::scene::{LegendEntry, Panel, Sample, Scene};
use crate::style::{CENTER, Dash, ENCLOSING, FOCUS, GREY, INPUT, Paint, Stroke, text_size, weight};
use zonotope::motion::space_time::{Method, Sweep};
use zonotope::zonotope::Zonotope;

/// The paper's Figure 3.
pub const FIGURE: Figure = Figure {
    id: "paper-figure-3",
    title: "The arcs of a turning body's vertices, moved to a common origin (the paper's Figure 3)",
    caption: "A body turns about an axis that is seen end on, and each arc is the way of one of its vertices from \
              where it was. The arcs lie in the circle through the farthest end, and a square around it gives the two \
              generators of Theorem 6.1. Counted from the middle of the turn the same arcs reach little more than half \
              as far. The rectangle and the zonogon of least area hold the arcs without the circle. Below each name \
              the area, as a part of the area of the paper's square.",
    claims: &["figure-3", "arcs-in-circle", "theorem-6.1"],
    experiments: &[],
    deterministic: true,
    draw,
};

/// The body's projection along the axis, which goes through the origin.
const BODY_CENTER: [f64; 2] = [1.6, 0.4];
const BODY: [[f64; 2]; 4] = [[0.9, 0.1], [0.5, 0.6], [0.0, 0.5], [-0.3, 0.4]];
/// The angle of the turn in degrees.
const DEGREES: f64 = 70.0;
/// Points of an arc that are joined by segments.
const ARC_POINTS: u32 = 32;
/// Points of a circle that are joined by segments.
const CIRCLE_POINTS: u32 = 96;

const PANELS: [(Method, &str); 4] = [
    (Method::ByFarthestVertex, "Theorem 6.1"),
    (Method::ByMiddlePlacement, "from the middle"),
    (Method::ByLeastRectangle, "least rectangle"),
    (Method::ByLeastZonogon, "least zonogon"),
];
const CELL: [f64; 2] = [215.0, 262.0];
const ARC: Stroke = Stroke::new(INPUT, weight::MEDIUM);
const CIRCLE: Stroke = Stroke::new(FOCUS, weight::MEDIUM).dashed(Dash::Dashed);
const AROUND: Paint = Paint::fill(ENCLOSING, 0.1).with_outline(Stroke::new(ENCLOSING, weight::STRONG));

/// The displacements of the vertices from one placement, and the zonogon around them that a method adds.
struct Arcs {
    arcs: Vec<Vec<[f64; 2]>>,
    around: Zonotope<2>,
}

impl Arcs {
    fn of(method: Method) -> Self {
        let angle = DEGREES.to_radians();
        let in_space = |v: &[f64; 2]| [v[0], v[1], 0.0];
        let body = Zonotope::new(in_space(&BODY_CENTER), BODY.iter().map(in_space).collect());
        let body = body.expect("the numbers are finite");
        let sweep = Sweep::new([0.0; 3], [0.0, 0.0, 1.0], angle, [0.0; 3]).expect("an axis and an angle");
        let volume = body.swept_by(&sweep, method).expect("the volume is in range");
        let start = if method == Method::ByMiddlePlacement { angle / 2.0 } else { 0.0 };
        let from = turned(BODY_CENTER, start);
        let center = [0, 1].map(|k| volume.center()[k] - from[k]);
        let added = volume.generators()[BODY.len()..].iter().map(|&[x, y, _]| [x, y]).collect();
        let flat = Zonotope::new(BODY_CENTER, BODY.to_vec()).expect("the numbers are finite");
        let arc = |vertex: &[f64; 2]| {
            let own = turned(*vertex, start);
            let moved = (0..=ARC_POINTS).map(|i| turned(*vertex, angle * f64::from(i) / f64::from(ARC_POINTS)));
            moved.map(|point| [point[0] - own[0], point[1] - own[1]]).collect()
        };
        Self {
            arcs: flat.vertices().iter().map(arc).collect(),
            around: Zonotope::new(center, added).expect("the volume is finite"),
        }
    }

    /// The largest distance of a point of an arc from the common origin.
    fn radius(&self) -> f64 {
        self.arcs.iter().flatten().map(|[x, y]| (x * x + y * y).sqrt()).fold(0.0, f64::max)
    }
}

fn turned([x, y]: [f64; 2], angle: f64) -> [f64; 2] {
    let (sine, cosine) = libm::sincos(angle);
    [cosine * x - sine * y, sine * x + cosine * y]
}

fn draw(_: &FigureInput<'_>) -> Result<String, FigureError> {
    let width = CELL[0] * PANELS.len() as f64;
    let mut scene = Scene::new(width, CELL[1] + 32.0, FIGURE.title, FIGURE.caption);
    let panels = PANELS.map(|(method, name)| (method, name, Arcs::of(method)));
    let corners: Vec<[f64; 2]> = panels.iter().flat_map(|(_, _, arcs)| arcs.around.vertices()).collect();
    let world = WorldBox::around(&corners).grown(0.03);
    let square = area(&panels[0].2.around);
    for (column, (method, name, arcs)) in panels.iter().enumerate() {
        let left = CELL[0] * column as f64;
        let middle = left + CELL[0] / 2.0;
        scene.heading(PagePoint::new(middle, 20.0), name);
        let note = format!("area {:.2}", area(&arcs.around) / square);
        scene.text(PagePoint::new(middle, 38.0), Anchor::Middle, &TextStyle::new(text_size::NOTE, GREY), &note);
        let window = PageBox::new(left + 8.0, 46.0, CELL[0] - 16.0, CELL[1] - 52.0);
        let mut panel = Panel::new(&mut scene, Frame::fit(&world, window));
        panel.polygon(&arcs.around.vertices(), &AROUND);
        if matches!(method, Method::ByFarthestVertex | Method::ByMiddlePlacement) {
            panel.polygon(&circle(arcs.radius()), &Paint::outline(CIRCLE));
        }
        arcs.arcs.iter().for_each(|arc| panel.polyline(arc, &ARC));
        panel.marker([0.0; 2], &CENTER);
    }
    let entries = [
        LegendEntry::new(Sample::Line(ARC), "way of a vertex"),
        LegendEntry::new(Sample::Point(CENTER), "common origin"),
        LegendEntry::new(Sample::Line(CIRCLE), "circle of the farthest point"),
        LegendEntry::new(Sample::Area(AROUND), "what is added to the body"),
    ];
    scene.legend(PagePoint::new(0.0, CELL[1]), width, &entries);
    Ok(scene.finish())
}

fn circle(radius: f64) -> Vec<[f64; 2]> {
    let turn = |i| std::f64::consts::TAU * f64::from(i) / f64::from(CIRCLE_POINTS);
    (0..CIRCLE_POINTS).map(|i| turned([radius, 0.0], turn(i))).collect()
}

/// The area of a zonogon by its corners.
fn area(zonogon: &Zonotope<2>) -> f64 {
    let corners = zonogon.vertices();
    let sides = corners.iter().zip(corners.iter().cycle().skip(1));
    sides.map(|(a, b)| a[0] * b[1] - a[1] * b[0]).sum::<f64>().abs() / 2.0
}
