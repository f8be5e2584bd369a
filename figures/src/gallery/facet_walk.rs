//! A walk from facet to facet, on the tiling and on the arrangement at once.

use crate::duality::{DualPair, arrangement_frame, draw_arrangement, draw_tiles, number_tiles, tiling_frame};
use crate::figure::{Figure, FigureError, FigureInput};
use crate::scene::page::{PageBox, PagePoint};
use crate::scene::text::{Anchor, TextStyle};
use crate::scene::{Panel, Scene};
use crate::style::{GREY, INK, Marker, PAPER, REFLECTED, Shape, Stroke, text_size, weight};
use zonotope::arrangement::facet_walk::{FacetName, FacetWalk, HullWalk, NormalSense};

/// The walk.
pub const FIGURE: Figure = Figure {
    id: "facet-walk",
    title: "A walk over facets, on the tiling and on the arrangement",
    caption: "The walk begins at the facet that is dual to the first crossing and goes to the facet in which a ray \
              from the centre leaves the body. Left, each step leads along a line to the next crossing on it; right, \
              across an edge of the tiling, which belongs to the generator of that line. The numbers are those of the \
              crossings from left to right.",
    claims: &["lemma-5.6", "local-walk"],
    experiments: &[],
    deterministic: true,
    draw,
};

const GENERATOR_ROWS: [[f64; 3]; 7] = [
    [9.0, 1.0, 11.0],
    [6.0, 5.0, -6.0],
    [4.0, 7.0, 8.0],
    [1.0, 7.0, -1.0],
    [-1.0, 9.0, -13.0],
    [-6.0, 7.0, 14.0],
    [-8.0, 4.0, 0.0],
];

/// The crossing that is dual to the facet in the middle of which the ray leaves.
const TARGET: usize = 17;

const PANEL: [f64; 2] = [470.0, 470.0];
const TOP: f64 = 40.0;
const PATH: Stroke = Stroke::new(REFLECTED.mixed(PAPER, 120), 4.0 * weight::STRONG);

fn draw(_: &FigureInput<'_>) -> Result<String, FigureError> {
    let pair = DualPair::new(&GENERATOR_ROWS);
    let visited = visited(&pair);
    let mut scene = Scene::new(2.0 * PANEL[0], TOP + PANEL[1], FIGURE.title, FIGURE.caption);
    let window = |column: f64| PageBox::new(PANEL[0] * column + 20.0, TOP + 6.0, PANEL[0] - 40.0, PANEL[1] - 40.0);
    for (column, heading) in ["From crossing to crossing", "From tile to tile"].into_iter().enumerate() {
        scene.heading(PagePoint::new(PANEL[0] * (column as f64 + 0.5), 22.0), heading);
    }
    let note = TextStyle::new(text_size::NOTE, GREY);
    let below = PagePoint::new(PANEL[0], TOP + PANEL[1] - 10.0);
    let steps = visited.len() - 1;
    scene.text(below, Anchor::Middle, &note, &format!("{steps} steps among {} facets", pair.crossings.len()));

    let places: Vec<[f64; 2]> = visited.iter().map(|&index| pair.crossings[index].place).collect();
    let middles: Vec<[f64; 2]> = visited.iter().map(|&index| pair.crossings[index].middle).collect();
    Panel::new(&mut scene, arrangement_frame(&pair, window(0.0), None)).polyline(&places, &PATH);
    draw_arrangement(&mut scene, window(0.0), &pair, None);
    draw_tiles(&mut scene, window(1.0), &pair, None);
    let mut panel = Panel::new(&mut scene, tiling_frame(&pair, window(1.0)));
    panel.marker(middles[steps], &Marker::new(Shape::Ring, 12.0, INK));
    panel.polyline(&middles, &PATH);
    number_tiles(&mut scene, window(1.0), &pair);
    Ok(scene.finish())
}

/// The crossings of the facets that the walk visits, which are all of the upper hull.
fn visited(pair: &DualPair) -> Vec<usize> {
    let mut walk = HullWalk::new(&GENERATOR_ROWS).expect("the generators of a figure span space");
    walk.place_at(upper_facet(pair, 0)).expect("a crossing is dual to a facet");
    let [x, y] = pair.crossings[TARGET].middle;
    let ray = [x, y, pair.crossings[TARGET].height];
    let left = |walk: &HullWalk| walk.clone().walk_to(ray).expect("the ray has a direction");
    let mut visited = vec![0];
    while left(&walk) > 0 {
        let next = (0..walk.edges().len()).map(|edge| {
            let mut next = walk.clone();
            next.step(edge).expect("the edge is one of the facet's");
            next
        });
        walk = next.min_by_key(left).expect("a facet has edges");
        let at = (0..pair.crossings.len()).find(|&index| upper_facet(pair, index) == walk.facet());
        visited.push(at.expect("the walk stays on the upper hull"));
    }
    visited
}

/// The facet of the upper hull that is dual to a crossing.
fn upper_facet(pair: &DualPair, crossing: usize) -> FacetName {
    let [i, j] = pair.crossings[crossing].pair;
    let [first, second] = [i.min(j), i.max(j)];
    let [v, w] = [first, second].map(|index| pair.generators[index]);
    let points_up = v[0] * w[1] > v[1] * w[0];
    FacetName::new(first, second, if points_up { NormalSense::Along } else { NormalSense::Against })
}
