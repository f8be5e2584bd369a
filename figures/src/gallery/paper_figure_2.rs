//! The paper's Figure 2, with the pieces that its area formula adds up.

use crate::figure::{Figure, FigureError, FigureInput};
use crate::min_area::Polygon;
use crate::scene::page::{Frame, PageBox, PagePoint, WorldBox};
use crate::scene::text::{Anchor, TextStyle};
use crate::scene::{LegendEntry, Panel, Sample, Scene};
use crate::style::{
    CENTER, Color, Dash, ENCLOSING, FOCUS, GREY, INK, INPUT, INPUT_POINT, Marker, Paint, REFLECTED, REFLECTED_POINT,
    Stroke, text_size, weight,
};
use zonotope::enclosing::centered_zonogon::{CenteredZonogon, Run};

/// The paper's Figure 2.
pub const FIGURE: Figure = Figure {
    id: "paper-figure-2",
    title: "A part of a zonotope (the paper's Figure 2)",
    caption: "The boundary of Z(O) alternates between runs of points P and runs of their reflections P'. The sector \
              from one run of points to the next splits into a quadrilateral at O and two caps; the area of Z(O) is \
              the sum over the sectors. O is the midpoint of every point and its reflection, so the caps can be \
              written with points of the polygon and O alone, and the area is an affine function of O as long as the \
              runs stay the same.",
    claims: &["figure-2", "area-formula", "combinatorial-description"],
    experiments: &[],
    deterministic: true,
    draw,
};

/// A polygon whose Z(O), for a centre near its middle, has three runs of points and three of reflections.
const POINTS: [[f64; 2]; 12] = [
    [4.95, 0.45],
    [4.72, 1.95],
    [4.05, 3.15],
    [3.3, 4.15],
    [-2.95, 4.05],
    [-3.85, 3.3],
    [-4.6, 2.05],
    [-4.95, 0.7],
    [-1.95, -4.75],
    [-0.7, -5.2],
    [0.75, -5.15],
    [2.0, -4.7],
];
const O: [f64; 2] = [0.05, 0.15];

const WIDTH: f64 = 840.0;
const HEIGHT: f64 = 490.0;

/// One sector of Z(O): a run of points, the following run of reflections, and the first point of the next run.
struct Sector {
    points: Vec<[f64; 2]>,
    reflections: Vec<[f64; 2]>,
    next: [f64; 2],
    /// The point whose reflection the second run starts with.
    first_reflected: [f64; 2],
    /// The vertices of Z(O) before and after.
    around: [[f64; 2]; 2],
}

impl Sector {
    fn starting_at(run: usize, zonogon: &CenteredZonogon<'_>) -> Self {
        let runs = zonogon.description();
        let at = |offset: usize| &runs[(run + offset) % runs.len()];
        let next = vertices_of(at(2), zonogon);
        let before = vertices_of(at(runs.len() - 1), zonogon);
        Self {
            points: vertices_of(at(0), zonogon),
            reflections: vertices_of(at(1), zonogon),
            next: next[0],
            first_reflected: zonogon.hull().vertex(at(1).first),
            around: [before[before.len() - 1], next[1]],
        }
    }

    fn outline(&self) -> Vec<[f64; 2]> {
        let tail = self.reflections.iter().chain([&self.next]);
        self.points.iter().chain(tail).copied().collect()
    }
}

fn vertices_of(run: &Run, zonogon: &CenteredZonogon<'_>) -> Vec<[f64; 2]> {
    let (hull, [x, y]) = (zonogon.hull(), zonogon.center());
    let mut vertex = run.first;
    let mut vertices = Vec::new();
    loop {
        let point = hull.vertex(vertex);
        vertices.push(if run.reflected { [2.0 * x - point[0], 2.0 * y - point[1]] } else { point });
        if vertex == run.last {
            return vertices;
        }
        vertex = hull.next(vertex);
    }
}

fn draw(_: &FigureInput<'_>) -> Result<String, FigureError> {
    let polygon = Polygon::of_figure(&POINTS);
    let zonogon = polygon.centered_zonogon(O);
    // The run of points on the right, whose sector opens upwards.
    let is_right = |run: &Run| !run.reflected && vertices_of(run, &zonogon)[0][0] > 4.0;
    let start = zonogon
        .description()
        .iter()
        .position(is_right)
        .expect("a run of points lies on the right because the polygon was chosen so");
    let sector = Sector::starting_at(start, &zonogon);

    let mut scene = Scene::new(WIDTH, HEIGHT, FIGURE.title, FIGURE.caption);
    scene.heading(PagePoint::new(265.0, 26.0), "One sector of $Z(O)$");
    draw_sector(&mut scene, &sector);
    scene.heading(PagePoint::new(680.0, 26.0), "Where it lies");
    draw_whole(&mut scene, &polygon, &zonogon, &sector);
    write_formula(&mut scene);
    Ok(scene.finish())
}

const fn light(color: Color) -> Paint {
    Paint::fill(color, 0.22)
}

const fn quadrilateral() -> Paint {
    Paint::fill(FOCUS, 0.26)
}

fn seen_from_o(point: [f64; 2]) -> [f64; 2] {
    [point[0] - O[0], point[1] - O[1]]
}

fn draw_sector(scene: &mut Scene, sector: &Sector) {
    let outline = sector.outline();
    let mut corners = outline.clone();
    corners.push(O);
    let frame = Frame::fit(&WorldBox::around(&corners), PageBox::new(50.0, 66.0, 430.0, 270.0));
    let mut panel = Panel::new(scene, frame);
    let Sector { points, reflections, next, around, .. } = sector;
    let turn = reflections[0];
    panel.polygon(&[O, points[0], turn, *next], &quadrilateral());
    panel.polygon(&outline[..=points.len()], &light(INPUT));
    panel.polygon(&outline[points.len()..], &light(REFLECTED));
    let thin = Stroke::new(INK, weight::FINE);
    for (from, to) in [(O, points[0]), (O, turn), (O, *next), (points[0], turn), (turn, *next)] {
        panel.segment(from, to, &thin);
    }
    let boundary = Stroke::new(ENCLOSING, weight::STRONG);
    for (end, beyond) in [(points[0], around[0]), (*next, around[1])] {
        let stub = [0, 1].map(|axis| end[axis] + 0.3 * (beyond[axis] - end[axis]));
        panel.segment(end, stub, &boundary.dashed(Dash::Dotted));
    }
    panel.polyline(&outline, &boundary);
    panel.markers(points, &INPUT_POINT);
    panel.marker(*next, &INPUT_POINT);
    panel.markers(reflections, &REFLECTED_POINT);
    panel.marker(O, &CENTER);
    for (point, color, name) in [
        (points[0], INPUT, "$P_{a_s}$"),
        (points[points.len() - 1], INPUT, "$P_{b_s}$"),
        (turn, REFLECTED, "$P'_{a'_s}$"),
        (reflections[reflections.len() - 1], REFLECTED, "$P'_{b'_s}$"),
        (*next, INPUT, "$P_{a_{s+1}}$"),
    ] {
        panel.label(point, seen_from_o(point), &TextStyle::new(17.0, color), name);
    }
    panel.label(O, [0.0, -1.0], &TextStyle::new(17.0, INK), "$O$");
}

fn draw_whole(scene: &mut Scene, polygon: &Polygon, zonogon: &CenteredZonogon<'_>, sector: &Sector) {
    let corners = zonogon.vertices();
    let frame = Frame::fit(&WorldBox::around(&corners), PageBox::new(565.0, 66.0, 230.0, 264.0));
    let mut panel = Panel::new(scene, frame);
    panel.polygon(polygon.vertices(), &Paint::fill(INPUT, 0.1).with_outline(Stroke::new(INPUT, weight::FINE)));
    let mut part = sector.outline();
    part.push(O);
    panel.polygon(&part, &quadrilateral());
    panel.polygon(&corners, &Paint::outline(Stroke::new(ENCLOSING, weight::STRONG)));
    let turn = sector.reflections[0];
    panel.segment(sector.first_reflected, turn, &Stroke::new(GREY, weight::MEDIUM).dashed(Dash::Dashed));
    let small = |marker: Marker| Marker { radius: 2.6, ..marker };
    for (place, vertex) in corners.iter().zip(zonogon.boundary()) {
        panel.marker(*place, &small(if vertex.reflected { REFLECTED_POINT } else { INPUT_POINT }));
    }
    panel.marker(O, &CENTER);
    for (point, wish, color, name) in [
        (O, [1.0, -0.4], INK, "$O$"),
        (turn, seen_from_o(turn), REFLECTED, "$P'_{a'_s}$"),
        (sector.first_reflected, seen_from_o(sector.first_reflected), INPUT, "$P_{a'_s}$"),
    ] {
        panel.label(point, wish, &TextStyle::new(text_size::LABEL, color), name);
    }
    panel.scene().legend(
        PagePoint::new(545.0, 354.0),
        270.0,
        &[
            LegendEntry::new(Sample::Area(Paint::fill(INPUT, 0.1).with_outline(Stroke::new(INPUT, 1.0))), "polygon"),
            LegendEntry::new(Sample::Line(Stroke::new(ENCLOSING, weight::STRONG)), "$Z(O)$"),
            LegendEntry::new(Sample::Point(INPUT_POINT), "point $P$"),
            LegendEntry::new(Sample::Point(REFLECTED_POINT), "reflection $P'$"),
        ],
    );
}

/// The first line of the area formula, each term beside a sample of its colour, and the step to the second.
fn write_formula(scene: &mut Scene) {
    let style = TextStyle::new(text_size::LABEL, INK);
    let (left, top) = (34.0, 384.0);
    let write = |scene: &mut Scene, y: f64, text: &str| {
        scene.text(PagePoint::new(left, y), Anchor::Start, &style, text);
    };
    write(scene, top, "$f(O)$, the area of $Z(O)$, is the sum over all sectors $s$ of");
    let terms = [
        (left, quadrilateral(), "$[O P_{a_s} P'_{a'_s} P_{a_{s+1}}]$"),
        (left + 178.0, light(INPUT), "$[P_{a_s} … P_{b_s} P'_{a'_s}]$"),
        (left + 340.0, light(REFLECTED), "$[P'_{a'_s} … P'_{b'_s} P_{a_{s+1}}]$"),
    ];
    for (x, paint, term) in terms {
        let entry = LegendEntry::new(Sample::Area(paint.with_outline(Stroke::new(INK, 0.6))), term);
        scene.sample_with_text(PagePoint::new(x, top + 26.0), text_size::LABEL, &entry);
    }
    write(scene, top + 62.0, "$O$ is the midpoint of $P_{a'_s}$ and $P'_{a'_s}$, hence");
    write(
        scene,
        top + 88.0,
        "$[P_{a_s} … P_{b_s} P'_{a'_s}]$  =  2 $[P_{a_s} … P_{b_s} O]$  −  $[P_{a_s} … P_{b_s} P_{a'_s}]$",
    );
}
