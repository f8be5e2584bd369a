//! A picture of a body: a zonogon as it is, a body of space seen from a corner, others by their shadow.

use figures::scene::page::WorldBox;
use figures::scene::{LegendEntry, Sample};
use figures::style::{CENTER, INPUT, Paint, SERIES, Stroke, weight};
use zonotope::zonotope::Zonotope;
use zonotope::zonotope::faces::Facet;

use crate::commands::page::{Page, thinned};
use crate::commands::view::{axes, facing, lattice, shade, shrinking};
use crate::input::Body;

/// The outline, in space with the facets in front and each edge in the colour of its zone.
pub(super) fn draw(name: &str, body: &Body) -> String {
    let shrink = shrinking(&body.generators);
    let small = body.generators.iter().map(|generator| shrink.vector(generator)).collect::<Vec<_>>();
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
