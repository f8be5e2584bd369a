//! A picture of a body: a zonogon as it is, a body of space seen from a corner, others by their shadow.

use figures::scene::page::WorldBox;
use figures::scene::{LegendEntry, Sample};
use figures::style::{CENTER, Color, INK, INPUT, PAPER, Paint, SERIES, Stroke, weight};
use zonotope::numeric::dyadic::Dyadic;
use zonotope::zonotope::Zonotope;
use zonotope::zonotope::faces::{FaceLattice, Faces, Facet, faces};

use crate::commands::page::{Page, thinned};
use crate::input::Body;

/// Of bodies with more generators only the outline is drawn.
const MOST_GENERATORS: usize = 120;

/// From where a body of space is seen: a unit vector.
const EYE: [f64; 3] = [0.48, 0.6, 0.64];

/// The part of the way to white of the facet that faces the eye and of one seen from its edge, in 1/256.
const SHADES: [f64; 2] = [235.0, 120.0];

/// The outline, in space with the facets in front and each edge in the colour of its zone.
pub(super) fn draw(name: &str, body: &Body) -> String {
    let small = small(&body.generators);
    let axes = axes(body.center.len());
    let place = |v: &[f64]| axes.each_ref().map(|axis| axis.iter().zip(v).map(|(a, x)| a * x).sum::<f64>());
    let shadow = small.iter().map(|generator| place(generator)).collect();
    let shadow = Zonotope::new([0.0; 2], shadow).expect("small generators have finite coordinates");
    let outline: Vec<[f64; 2]> = thinned(shadow.vertices()).collect();
    let lattice = lattice(&small);

    let description = format!(
        "A zonotope with {} generators in {} dimensions{}.",
        body.generators.len(),
        body.center.len(),
        match (body.center.len(), &lattice) {
            (1 | 2, _) => "",
            (3, Some(_)) => ": the facets in front, with edges coloured by zone",
            _ => ": its outline in projection",
        }
    );
    let world = WorldBox::around(&outline).grown(0.02);
    let mut page = Page::new(world, 1, name, &description);
    let mut panel = page.panel();
    let edge = Stroke::new(INPUT, weight::STRONG);
    match &lattice {
        Some(lattice) => {
            for facet in (0..lattice.facet_count()).map(|index| Facet(index as u32)) {
                let corners: Vec<[f64; 3]> =
                    lattice.facet_vertices(facet).map(|vertex| lattice.point(vertex)).collect();
                let turned = facing(&corners);
                if turned <= 0.0 {
                    continue;
                }
                let corners: Vec<[f64; 2]> = corners.iter().map(|corner| place(corner)).collect();
                panel.polygon(&corners, &Paint::fill(shade(turned), 1.0));
                for (index, zone) in lattice.facet_edges(facet).map(|edge| lattice.edge_zone(edge)).enumerate() {
                    let color = SERIES[zone.0 as usize % SERIES.len()];
                    let (from, to) = (corners[index], corners[(index + 1) % corners.len()]);
                    panel.segment(from, to, &Stroke::new(color, weight::STRONG));
                }
            }
        }
        None => panel.polygon(&outline, &Paint::fill(INPUT, 0.12).with_outline(edge)),
    }
    if lattice.is_none() {
        panel.marker([0.0, 0.0], &CENTER);
    }
    let legend = match (&lattice, body.center.len()) {
        (Some(_), _) => vec![LegendEntry::new(
            Sample::Line(Stroke::new(SERIES[0], weight::STRONG)),
            "edges of one colour are parallel: a zone (colours repeat after six)",
        )],
        (None, 1 | 2) => vec![LegendEntry::new(Sample::Point(CENTER), "centre")],
        (None, _) => vec![
            LegendEntry::new(Sample::Line(edge), "outline of the projection"),
            LegendEntry::new(Sample::Point(CENTER), "centre"),
        ],
    };
    page.finish(&legend)
}

/// The generators scaled by a power of two, so that the body is about as large as 1.
fn small(generators: &[Vec<f64>]) -> Vec<Vec<f64>> {
    let dimension = generators.first().map_or(0, Vec::len);
    let reach = |axis: usize| {
        let sum = |sum: Dyadic, generator: &Vec<f64>| sum + Dyadic::from_f64(generator[axis]).abs();
        generators.iter().fold(Dyadic::zero(), sum).binary_exponent()
    };
    let shrink = -(0..dimension).filter_map(reach).max().unwrap_or(0);
    let scaled = |x: &f64| Dyadic::from_f64(*x).scaled(shrink).to_f64();
    generators.iter().map(|generator| generator.iter().map(scaled).collect()).collect()
}

/// Two orthonormal vectors that span the page: across and up.
fn axes(dimension: usize) -> [Vec<f64>; 2] {
    let unit = |axis: usize| (0..dimension).map(|other| f64::from(u8::from(other == axis))).collect::<Vec<_>>();
    match dimension {
        1 => [unit(0), vec![0.0]],
        2 => [unit(0), unit(1)],
        3 => {
            let [x, y, z] = EYE;
            let flat = (x * x + y * y).sqrt();
            [vec![-y / flat, x / flat, 0.0], vec![-x * z / flat, -y * z / flat, flat]]
        }
        // Across and up wind around all the coordinate axes, so that none is seen from its end.
        _ => {
            let across: Vec<f64> = (0..dimension).map(|axis| turn(axis, dimension, 0.0)).collect();
            let up: Vec<f64> = (0..dimension).map(|axis| turn(axis, dimension, 0.5)).collect();
            let scale = (2.0 / dimension as f64).sqrt();
            [across, up].map(|axis| axis.into_iter().map(|x| x * scale).collect())
        }
    }
}

/// The cosine of π (axis / dimension − shift): over all axes the squares add up to half the dimension.
fn turn(axis: usize, dimension: usize, shift: f64) -> f64 {
    libm::cos(std::f64::consts::PI * (axis as f64 / dimension as f64 - shift))
}

/// The faces of a body of space, if they are few enough to be seen.
fn lattice(generators: &[Vec<f64>]) -> Option<FaceLattice> {
    if generators.len() > MOST_GENERATORS {
        return None;
    }
    let space = generators.iter().map(|generator| <[f64; 3]>::try_from(generator.as_slice()).ok());
    let body = Zonotope::new([0.0; 3], space.collect::<Option<_>>()?).ok()?;
    match faces(&body) {
        Ok(Faces::Flat(lattice) | Faces::Solid(lattice)) => Some(lattice),
        _ => None,
    }
}

/// How far a polygon of space is turned to the eye: the cosine of the angle of its normal, by twice its area.
fn facing(corners: &[[f64; 3]]) -> f64 {
    let mut normal = [0.0; 3];
    for (a, b) in corners.iter().zip(corners.iter().cycle().skip(1)) {
        let [a, b] = [a, b].map(|p| [p[0] - corners[0][0], p[1] - corners[0][1], p[2] - corners[0][2]]);
        normal[0] += a[1] * b[2] - a[2] * b[1];
        normal[1] += a[2] * b[0] - a[0] * b[2];
        normal[2] += a[0] * b[1] - a[1] * b[0];
    }
    let dot = |u: &[f64; 3], v: &[f64; 3]| u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
    let length = dot(&normal, &normal).sqrt();
    if length > 0.0 { dot(&normal, &EYE) / length } else { 0.0 }
}

fn shade(facing: f64) -> Color {
    let part = SHADES[1] + (SHADES[0] - SHADES[1]) * facing.clamp(0.0, 1.0);
    INK.mixed(INPUT, 160).mixed(PAPER, part as u16)
}
