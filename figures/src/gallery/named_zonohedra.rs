//! Well-known zonohedra with three of their zones coloured.

use crate::figure::{Figure, FigureError, FigureInput};
use crate::scene::page::{Frame, PageBox, PagePoint, WorldBox};
use crate::scene::text::{Anchor, TextStyle};
use crate::scene::{LegendEntry, Panel, Sample, Scene};
use crate::solid::{self, Camera, Face, faces_of};
use crate::style::{Color, ENCLOSING, FOCUS, GREY, INK, INPUT, PALE, Paint, Stroke, text_size, weight};
use families::bodies::named;
use zonotope::zonotope::Zonotope;

/// Well-known zonohedra.
pub const FIGURE: Figure = Figure {
    id: "named-zonohedra",
    title: "Zonohedra and their zones",
    caption: "Well-known polyhedra as sums of segments, with three of their zones, and with one where three would \
              cover nearly all of the body: the facets that share a generator form a band around the body, crossed by \
              edges along that generator, drawn heavy. A facet where two coloured bands cross has the colour between \
              them; a facet of three or more generators belongs to as many bands. Dotted edges are hidden.",
    claims: &["zones-are-bands", "familiar-zonotopes"],
    experiments: &[],
    deterministic: true,
    draw,
};

const COLUMNS: usize = 3;
const CELL: [f64; 2] = [270.0, 292.0];
const ZONES: [Color; 3] = [FOCUS, ENCLOSING, INPUT];
/// Of bodies with at most so many generators one zone is coloured.
const FEW_GENERATORS: usize = 5;

fn bodies() -> [(&'static str, Zonotope<3>); 9] {
    let generators = [
        ("cube", named::cube()),
        ("hexagonal prism", named::hexagonal_prism()),
        ("rhombic dodecahedron", named::rhombic_dodecahedron()),
        ("elongated dodecahedron", named::elongated_dodecahedron()),
        ("truncated octahedron", named::truncated_octahedron()),
        ("truncated cuboctahedron", named::truncated_cuboctahedron()),
        ("rhombic triacontahedron", named::rhombic_triacontahedron()),
        ("rhombic enneacontahedron", named::rhombic_enneacontahedron()),
        ("polar zonohedron of 8", named::polar_zonohedron(8, 0.6)),
    ];
    generators.map(|(name, generators)| {
        (name, Zonotope::new([0.0; 3], generators).expect("coordinates of named bodies are finite"))
    })
}

fn draw(_: &FigureInput<'_>) -> Result<String, FigureError> {
    let bodies = bodies();
    let rows = bodies.len().div_ceil(COLUMNS);
    let width = CELL[0] * COLUMNS as f64;
    let height = CELL[1] * rows as f64;
    let mut scene = Scene::new(width, height + 36.0, FIGURE.title, FIGURE.caption);
    let camera = Camera::from_direction([2.0, -3.6, 1.7]);
    for (number, (name, body)) in bodies.iter().enumerate() {
        let (left, top) = (CELL[0] * (number % COLUMNS) as f64, CELL[1] * (number / COLUMNS) as f64);
        let faces = faces_of(body);
        scene.heading(PagePoint::new(left + CELL[0] / 2.0, top + 22.0), name);
        let style = TextStyle::new(text_size::NOTE, GREY);
        let note = format!("{} generators, {} facets", body.generators().len(), faces.len());
        scene.text(PagePoint::new(left + CELL[0] / 2.0, top + 40.0), Anchor::Middle, &style, &note);
        let window = PageBox::new(left + 22.0, top + 52.0, CELL[0] - 44.0, CELL[1] - 66.0);
        let zones = if body.generators().len() > FEW_GENERATORS { &ZONES[..] } else { &ZONES[..1] };
        draw_body(&mut scene, window, &camera, &faces, zones);
    }
    let entries = ["one zone", "a second", "a third"].map(|words| words.to_owned());
    let entries: Vec<LegendEntry<'_>> = ZONES
        .iter()
        .zip(&entries)
        .map(|(&color, words)| LegendEntry::new(Sample::Area(Paint::fill(color, 0.55)), words))
        .collect();
    scene.legend(PagePoint::new(0.0, height + 4.0), width, &entries);
    Ok(scene.finish())
}

/// Draws a body with its first zones in colours.
fn draw_body(scene: &mut Scene, window: PageBox, camera: &Camera, faces: &[Face], zones: &[Color]) {
    let seen: Vec<[f64; 2]> =
        faces.iter().flat_map(|face| &face.corners).map(|&corner| camera.project(corner)).collect();
    let mut panel = Panel::new(scene, Frame::fit(&WorldBox::around(&seen), window));
    let paint = |face: &Face| {
        let colors: Vec<Color> =
            zones.iter().enumerate().filter(|(zone, _)| face.sides.contains(zone)).map(|(_, &color)| color).collect();
        let shade = 0.75 - 0.35 * camera.squareness(face);
        match colors[..] {
            [] => Paint::fill(PALE, 0.2 + shade / 3.0),
            [one] => Paint::fill(one, shade),
            [one, other, ..] => Paint::fill(one.mixed(other, 128), shade),
        }
    };
    let side = |zone: usize| match zones.get(zone) {
        Some(color) => Stroke::new(color.mixed(INK, 110), 1.2 * weight::STRONG),
        None => Stroke::new(INK, weight::MEDIUM),
    };
    solid::draw(&mut panel, camera, faces, paint, side);
}
