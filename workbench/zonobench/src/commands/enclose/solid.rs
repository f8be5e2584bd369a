//! A picture of points in a zonotope: of the plane as they are, of space from a corner, of others by their shadow.

use figures::scene::page::WorldBox;
use figures::scene::{LegendEntry, Sample};
use figures::style::{Dash, ENCLOSING, GREY, INPUT, Marker, OPTIMAL_CENTER, Paint, Shape, Stroke, weight};
use zonotope::zonotope::Zonotope;
use zonotope::zonotope::faces::{FaceLattice, Facet};

use crate::commands::page::{Page, stride, thinned};
use crate::commands::view::{axes, facing, lattice, shrinking};
use crate::input::{Body, Points};

/// Of bodies with more generators the edges behind are left out.
const SEEN_THROUGH_LIMIT: usize = 24;

/// Outline and edges, those behind dashed; the points between.
pub(super) fn draw(name: &str, points: &Points, body: &Body) -> String {
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
