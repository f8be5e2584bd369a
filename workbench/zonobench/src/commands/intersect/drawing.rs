//! A picture of two bodies and what proves how they lie.

use figures::scene::page::WorldBox;
use figures::scene::text::TextStyle;
use figures::scene::{LegendEntry, Sample};
use figures::style::{
    Color, Dash, INK, INPUT, Marker, OPTIMAL_CENTER, Paint, REFLECTED, Shape, Stroke, text_size, weight,
};
use zonotope::numeric::dyadic::Dyadic;
use zonotope::zonotope::Zonotope;

use super::meeting::{Meeting, Proof};
use crate::commands::page::{Page, thinned};

const COLORS: [Color; 2] = [INPUT, REFLECTED];

/// Both bodies, projected to a plane that holds the separating direction or both centres.
pub(super) fn draw(name: &str, meeting: &Meeting) -> String {
    drawn(name, meeting, None)
}

/// The same with a point of each body and, between the points, a line.
pub(in crate::commands) fn draw_with_points(name: &str, meeting: &Meeting, points: &[Vec<f64>; 2]) -> String {
    drawn(name, meeting, Some(points))
}

fn drawn(name: &str, meeting: &Meeting, points: Option<&[Vec<f64>; 2]>) -> String {
    let small = Small::of(meeting);
    let view = View::of(meeting, &small);
    let polygons = small.bodies.each_ref().map(|(center, generators)| view.polygon(center, generators));
    let centers = small.bodies.each_ref().map(|(center, _)| view.place(center));
    let meets = meeting.status != "outside";
    let title = format!("{name}: {}", if meets { "a common point" } else { "a separating plane" });
    let description = format!(
        "Two zonotopes of dimension {}, {}, {}.",
        meeting.dimension(),
        view.description(meeting),
        if meets { "with a point that both contain" } else { "with a plane between them" },
    );
    let point = match &meeting.proof {
        Proof::Common { coefficients, .. } => Some(view.place(&small.common_point(coefficients))),
        Proof::Gap(_) => None,
    };
    let world = WorldBox::around(polygons.iter().flatten().chain(&point)).grown(0.02);
    let has_segment = points.is_some() && point.is_none();
    let mut page = Page::new(world, if has_segment { 2 } else { 1 }, &title, &description);
    let window = page.window();
    let mut panel = page.panel();

    let paints = COLORS.map(|color| Paint::fill(color, 0.12).with_outline(Stroke::new(color, weight::STRONG)));
    for (polygon, paint) in polygons.iter().zip(&paints) {
        panel.polygon(polygon, paint);
    }
    let line = Stroke::new(INK, weight::MEDIUM).dashed(Dash::Dashed);
    if let Proof::Gap(gap) = &meeting.proof {
        let normal = view.place(&gap.direction);
        let middle = small.middle(&gap.direction);
        let foot = [normal[0] * middle, normal[1] * middle];
        panel.line(foot, [-normal[1], normal[0]], &window, &line);
    }
    for ((name, center), color) in ["a", "b"].iter().zip(centers).zip(COLORS) {
        panel.marker(center, &Marker::new(Shape::Diamond, 5.0, color));
        panel.label(center, [0.0, 1.0], &TextStyle::new(text_size::LABEL, color), name);
    }
    if let Some(point) = point {
        panel.marker(point, &OPTIMAL_CENTER);
    }
    let nearest = points.filter(|_| point.is_none()).map(|points| small.differences(points));
    let between = Stroke::new(OPTIMAL_CENTER.color, weight::STRONG);
    if let Some(ends) = nearest.map(|ends| ends.map(|end| view.place(&end))) {
        panel.segment(ends[0], ends[1], &between);
        ends.iter().for_each(|end| panel.marker(*end, &OPTIMAL_CENTER));
    }

    let proof = match point {
        Some(_) => LegendEntry::new(Sample::Point(OPTIMAL_CENTER), "a common point"),
        None => LegendEntry::new(
            Sample::Line(line),
            if meeting.dimension() == 2 { "a line between them" } else { "a plane between them, seen from its edge" },
        ),
    };
    let mut legend = vec![
        LegendEntry::new(Sample::Area(paints[0]), "a"),
        LegendEntry::new(Sample::Area(paints[1]), "b"),
        proof,
        LegendEntry::new(Sample::Point(Marker::new(Shape::Diamond, 5.0, INK)), "centres"),
    ];
    if has_segment {
        legend.push(LegendEntry::new(Sample::Line(between), "from nearest point to nearest point"));
    }
    page.finish(&legend)
}

/// The bodies moved so that the first centre is the origin, and scaled by a power of two to about 1.
struct Small {
    bodies: [(Vec<f64>, Vec<Vec<f64>>); 2],
    origin: Vec<f64>,
    shrinking: i64,
}

impl Small {
    fn of(meeting: &Meeting) -> Self {
        let exact = |v: &[f64]| v.iter().map(|&x| Dyadic::from_f64(x)).collect::<Vec<_>>();
        let origin = exact(&meeting.bodies[0].center);
        let centers = meeting
            .bodies
            .each_ref()
            .map(|body| exact(&body.center).into_iter().zip(&origin).map(|(x, o)| &x - o).collect::<Vec<Dyadic>>());
        let reach = |axis: usize| {
            let all = meeting.bodies.iter().flat_map(|body| &body.generators);
            let sum = all.fold(Dyadic::zero(), |sum, generator| sum + Dyadic::from_f64(generator[axis]).abs());
            sum + centers[1][axis].clone().abs()
        };
        let exponents = (0..origin.len()).filter_map(|axis| reach(axis).binary_exponent());
        let shrink = -exponents.max().unwrap_or(0);
        let small = |v: &[Dyadic]| v.iter().map(|x| x.clone().scaled(shrink).to_f64()).collect::<Vec<f64>>();
        let generators = meeting
            .bodies
            .each_ref()
            .map(|body| body.generators.iter().map(|generator| small(&exact(generator))).collect::<Vec<_>>());
        let [a, b] = generators;
        Self {
            bodies: [(small(&centers[0]), a), (small(&centers[1]), b)],
            origin: meeting.bodies[0].center.clone(),
            shrinking: shrink,
        }
    }

    /// Points of the bodies, moved and scaled as they are.
    fn differences(&self, points: &[Vec<f64>; 2]) -> [Vec<f64>; 2] {
        let along =
            |(&x, &o): (&f64, &f64)| (Dyadic::from_f64(x) - Dyadic::from_f64(o)).scaled(self.shrinking).to_f64();
        points.each_ref().map(|point| point.iter().zip(&self.origin).map(along).collect())
    }

    /// The height of the plane in the middle of the gap, in its direction.
    fn middle(&self, direction: &[f64]) -> f64 {
        let [a, b] = &self.bodies;
        let reach = |body: &(Vec<f64>, Vec<Vec<f64>>)| body.1.iter().map(|g| dot(direction, g).abs()).sum::<f64>();
        (dot(direction, &a.0) + reach(a) + dot(direction, &b.0) - reach(b)) / 2.0
    }

    fn common_point(&self, coefficients: &[f64]) -> Vec<f64> {
        let (center, generators) = &self.bodies[0];
        let mut point = center.clone();
        for (generator, delta) in generators.iter().zip(coefficients) {
            point.iter_mut().zip(generator).for_each(|(sum, x)| *sum += delta * x);
        }
        point
    }
}

/// The plane of the picture: two orthonormal vectors.
struct View {
    axes: [Vec<f64>; 2],
}

impl View {
    fn of(meeting: &Meeting, small: &Small) -> Self {
        let dimension = meeting.dimension();
        let unit = |axis: usize| (0..dimension).map(|other| f64::from(u8::from(other == axis))).collect::<Vec<_>>();
        if dimension < 3 {
            let second = if dimension == 2 { unit(1) } else { vec![0.0] };
            return Self { axes: [unit(0), second] };
        }
        let all: Vec<&Vec<f64>> = small.bodies.iter().flat_map(|(_, generators)| generators).collect();
        let extent = |direction: &[f64]| all.iter().map(|g| dot(direction, g).abs()).sum::<f64>();
        // Of the coordinate axes, turned to be orthogonal to `first`, the one along which the bodies are longest.
        let longest = |first: Option<&Vec<f64>>| {
            let turned = |axis: usize| {
                let axis = unit(axis);
                first.map_or(Some(axis.clone()), |first| normalized(&without(&axis, first)))
            };
            let candidates = (0..dimension).filter_map(turned);
            candidates.reduce(|best, next| if extent(&next) > extent(&best) { next } else { best })
        };
        let along = match &meeting.proof {
            Proof::Gap(gap) => Some(gap.direction.clone()),
            Proof::Common { .. } => normalized(&small.bodies[1].0),
        };
        let first = along.or_else(|| longest(None)).unwrap_or_else(|| unit(0));
        let second = longest(Some(&first)).unwrap_or_else(|| unit(1));
        Self { axes: [first, second] }
    }

    fn description(&self, meeting: &Meeting) -> &'static str {
        match (meeting.dimension(), &meeting.proof) {
            (..3, _) => "as they are",
            (_, Proof::Gap(_)) => "projected along the separating plane",
            (_, Proof::Common { .. }) => "projected to a plane that holds both centres",
        }
    }

    fn place(&self, point: &[f64]) -> [f64; 2] {
        self.axes.each_ref().map(|axis| dot(axis, point))
    }

    fn polygon(&self, center: &[f64], generators: &[Vec<f64>]) -> Vec<[f64; 2]> {
        let generators = generators.iter().map(|generator| self.place(generator)).collect();
        let zonogon = Zonotope::new(self.place(center), generators).expect("small bodies have finite coordinates");
        thinned(zonogon.vertices()).collect()
    }
}

fn dot(u: &[f64], v: &[f64]) -> f64 {
    u.iter().zip(v).map(|(u, v)| u * v).sum()
}

fn without(v: &[f64], unit: &[f64]) -> Vec<f64> {
    let along = dot(v, unit);
    v.iter().zip(unit).map(|(v, u)| v - along * u).collect()
}

/// The vector at length 1, unless it is too short to have a direction.
fn normalized(v: &[f64]) -> Option<Vec<f64>> {
    let norm = dot(v, v).sqrt();
    (norm > 1e-6).then(|| v.iter().map(|x| x / norm).collect())
}
