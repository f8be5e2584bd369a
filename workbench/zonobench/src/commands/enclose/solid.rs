//! A picture of points in a zonotope: of the plane as they are, of space from a corner, of others by their shadow; of
//! a mesh with its faces.

use figures::scene::page::WorldBox;
use figures::scene::{LegendEntry, Sample};
use figures::skin::{MESH, Skin, ZONOHEDRON, draw_inside};
use figures::solid::{Camera, faces_of};
use figures::style::{Dash, ENCLOSING, GREY, INPUT, Marker, OPTIMAL_CENTER, Paint, Shape, Stroke, weight};
use zonotope::zonotope::Zonotope;
use zonotope::zonotope::faces::{FaceLattice, Facet};

use crate::commands::page::{Page, stride, thinned};
use crate::commands::view::{EYE, LATTICE_GENERATOR_LIMIT, axes, facing, lattice, shrinking};
use crate::input::{Body, Points, Reading};

/// Of bodies with more generators the edges behind are left out.
const SEEN_THROUGH_LIMIT: usize = 24;

/// Of meshes with more faces the vertices alone are drawn.
const FACE_LIMIT: usize = 20_000;

/// The mesh in the body, if the points are those of a mesh and the body has faces that can be seen; else the points.
pub(super) fn draw(name: &str, reading: &Reading, body: &Body) -> String {
    match mesh_in_body(name, reading, body) {
        Some(picture) => picture,
        None => points_in_body(name, &reading.points, body),
    }
}

/// The faces of a mesh between the edges behind and the faces in front, as the gallery draws them.
fn mesh_in_body(name: &str, reading: &Reading, body: &Body) -> Option<String> {
    let Points::Space(vertices) = &reading.points else { return None };
    let mesh = &reading.faces;
    if mesh.is_empty() || mesh.len() > FACE_LIMIT || body.generators.len() > LATTICE_GENERATOR_LIMIT {
        return None;
    }
    let scale = shrinking(&body.generators);
    let in_space = |v: Vec<f64>| <[f64; 3]>::try_from(v).ok();
    let generators = body.generators.iter().map(|generator| in_space(scale.vector(generator)));
    let small = Zonotope::new([0.0; 3], generators.collect::<Option<_>>()?).ok()?;
    let faces = faces_of(&small);
    if faces.is_empty() {
        return None;
    }
    let vertices = vertices.iter().map(|vertex| in_space(scale.difference(vertex, &body.center)));
    let camera = Camera::from_direction(EYE);
    let skin = Skin::seen(&camera, &vertices.collect::<Option<Vec<_>>>()?, mesh);
    let corners: Vec<[f64; 2]> = faces.iter().flat_map(|face| &face.corners).map(|&c| camera.project(c)).collect();
    let title = format!("A zonotope of small total length around {name}");
    let description = format!(
        "A mesh of {} faces and an enclosing zonotope with {} generators, seen from a corner.",
        mesh.len(),
        body.generators.len()
    );
    let mut page = Page::new(WorldBox::around(&corners).grown(0.02), 1, &title, &description);
    draw_inside(&mut page.panel(), &camera, &faces, &skin);
    let legend = [LegendEntry::new(Sample::Area(MESH), "mesh"), LegendEntry::new(Sample::Area(ZONOHEDRON), "zonotope")];
    Some(page.finish(&legend))
}

/// Outline and edges, those behind dashed; the points between.
fn points_in_body(name: &str, points: &Points, body: &Body) -> String {
    let scale = shrinking(&body.generators);
    let small: Vec<Vec<f64>> = body.generators.iter().map(|generator| scale.vector(generator)).collect();
    let dimension = body.center.len();
    let axes = axes(dimension);
    let place = |v: &[f64]| axes.each_ref().map(|axis| axis.iter().zip(v).map(|(a, x)| a * x).sum::<f64>());
    let shadow = small.iter().map(|generator| place(generator)).collect();
    let shadow = Zonotope::new([0.0; 2], shadow).expect("small generators have finite coordinates");
    let outline: Vec<[f64; 2]> = thinned(shadow.vertices()).collect();
    let shown: Vec<[f64; 2]> =
        thinned(points.rows()).map(|point| place(&scale.difference(point, &body.center))).collect();

    let title = format!("A zonotope of small total length around {name}");
    let seen = match dimension {
        1 | 2 => "",
        3 => ", seen from a corner",
        _ => ", in projection",
    };
    let description =
        format!("{} points and an enclosing zonotope with {} generators{seen}.", points.len(), body.generators.len());
    let mut page = Page::new(WorldBox::around(outline.iter().chain(&shown)).grown(0.02), 2, &title, &description);
    let mut panel = page.panel();
    let border = Stroke::new(ENCLOSING, weight::STRONG);
    let front = Stroke::new(ENCLOSING, weight::FINE);
    let back = Stroke::new(GREY, weight::FINE).dashed(Dash::Dotted).faded(0.6);
    let inside = Paint::fill(ENCLOSING, 0.08);
    let dot = Marker::new(Shape::Disc, if shown.len() > 500 { 1.2 } else { 2.2 }, INPUT);
    panel.polygon(&outline, &inside);
    let seen = |lattice: &FaceLattice, index: u32| {
        let corners: Vec<[f64; 3]> = lattice.facet_vertices(Facet(index)).map(|vertex| lattice.point(vertex)).collect();
        Seen { in_front: facing(&corners) > 0.0, corners: corners.iter().map(|corner| place(corner)).collect() }
    };
    let lattice = lattice(&small);
    let facets: Vec<Seen> = lattice
        .iter()
        .flat_map(|lattice| (0..lattice.facet_count() as u32).map(move |index| seen(lattice, index)))
        .collect();
    let draws_back = small.len() <= SEEN_THROUGH_LIMIT;
    if draws_back {
        for (from, to) in edges(&facets, false) {
            panel.segment(from, to, &back);
        }
    }
    panel.markers(&shown, &dot);
    for (from, to) in edges(&facets, true) {
        panel.segment(from, to, &front);
    }
    panel.polygon(&outline, &Paint::outline(border));
    panel.marker([0.0, 0.0], &OPTIMAL_CENTER);

    let some = match stride(points.len()) {
        1 => "points".to_owned(),
        stride => format!("points, one in {stride}"),
    };
    let mut legend = vec![
        LegendEntry::new(Sample::Point(dot), &some),
        LegendEntry::new(
            Sample::Area(inside.with_outline(border)),
            if dimension > 3 { "projection of the zonotope" } else { "zonotope" },
        ),
        LegendEntry::new(Sample::Point(OPTIMAL_CENTER), "its centre"),
    ];
    if !facets.is_empty() {
        legend.push(LegendEntry::new(Sample::Line(front), "edges in front"));
    }
    if !facets.is_empty() && draws_back {
        legend.push(LegendEntry::new(Sample::Line(back), "edges behind"));
    }
    page.finish(&legend)
}

/// The edges of the facets in front, or behind, each once: neighbours run through theirs in opposite ways. Of those
/// on the outline, which is drawn by itself, some are left out.
fn edges(facets: &[Seen], in_front: bool) -> impl Iterator<Item = ([f64; 2], [f64; 2])> {
    let chosen = facets.iter().filter(move |facet| facet.in_front == in_front);
    let all = chosen.flat_map(|facet| facet.corners.iter().zip(facet.corners.iter().cycle().skip(1)));
    all.filter(|(from, to)| from < to).map(|(from, to)| (*from, *to))
}

/// A facet as it is seen.
struct Seen {
    in_front: bool,
    corners: Vec<[f64; 2]>,
}
