//! A cutting of the dual plane and its image in the tiling.

use std::num::NonZeroU32;

use crate::duality::{DualPair, arrangement_frame, draw_arrangement, draw_tiles, number_tiles, tiling_frame};
use crate::figure::{Figure, FigureError, FigureInput};
use crate::scene::page::{PageBox, PagePoint};
use crate::scene::text::{Anchor, TextStyle};
use crate::scene::{Panel, Scene};
use crate::style::{Color, GREY, PAPER, Paint, SERIES, text_size};
use zonotope::arrangement::LineArrangement;
use zonotope::arrangement::cutting::{Cutting, cutting};

/// The cutting and its image.
pub const FIGURE: Figure = Figure {
    id: "cutting-and-image",
    title: "A cutting of the arrangement, and its image in the tiling",
    caption: "Left, a (1/2)-cutting of the lines of eight generators: trapezoids between vertical walls and lines of \
              the arrangement, each crossed by at most four lines. Right, the same colours in the tiling of Q. The \
              four corners of a tile are dual to the four faces around its crossing: the tile of a crossing within a \
              trapezoid has one colour, that of a crossing on the side of a trapezoid straddles the images of the \
              neighbours.",
    claims: &["lemma-5.3", "tiles-of-cutting-lines"],
    experiments: &[],
    deterministic: true,
    draw,
};

const GENERATOR_ROWS: [[f64; 3]; 8] = [
    [8.0, 2.0, 11.0],
    [5.0, 4.0, 14.0],
    [5.0, 9.0, 2.0],
    [1.0, 8.0, 13.0],
    [-1.0, 8.0, 6.0],
    [-3.0, 8.0, -4.0],
    [-6.0, 3.0, 12.0],
    [-10.0, 1.0, 0.0],
];

/// A trapezoid is crossed by at most this part of the lines.
const R: u32 = 2;

const PANEL: [f64; 2] = [470.0, 470.0];
const TOP: f64 = 40.0;

/// The distance from a crossing at which its faces are asked for their trapezoid, in terms of the values of the lines.
const BESIDE: f64 = 1e-3;

fn draw(_: &FigureInput<'_>) -> Result<String, FigureError> {
    let pair = DualPair::new(&GENERATOR_ROWS);
    let lines = LineArrangement::from_rows(&GENERATOR_ROWS).expect("the generators of a figure are small integers");
    let cut = cutting(&lines, NonZeroU32::new(R).expect("two is not zero"), 1, &mut ());
    let mut scene = Scene::new(2.0 * PANEL[0], TOP + PANEL[1], FIGURE.title, FIGURE.caption);
    let window = |column: f64| PageBox::new(PANEL[0] * column + 20.0, TOP + 6.0, PANEL[0] - 40.0, PANEL[1] - 40.0);
    for (column, heading) in ["The cutting", "Its image"].into_iter().enumerate() {
        scene.heading(PagePoint::new(PANEL[0] * (column as f64 + 0.5), 22.0), heading);
    }
    let note = TextStyle::new(text_size::NOTE, GREY);
    let [count, most] = [cut.trapezoids().len(), cut.limit()];
    let below = PagePoint::new(PANEL[0] * 0.5, TOP + PANEL[1] - 10.0);
    scene.text(below, Anchor::Middle, &note, &format!("{count} trapezoids, at most {most} lines cross each"));

    let world = arrangement_frame(&pair, window(0.0), None);
    for (number, trapezoid) in cut.trapezoids().iter().enumerate() {
        let seen = [window(0.0).min, window(0.0).max].map(|place| world.world_at(place));
        let corners = trapezoid.outline(&lines, seen);
        Panel::new(&mut scene, world).polygon(&corners, &paint(number));
    }
    draw_arrangement(&mut scene, window(0.0), &pair, None);
    draw_tiles(&mut scene, window(1.0), &pair, None);
    let world = tiling_frame(&pair, window(1.0));
    for (number, quarter) in quarters(&pair, &cut) {
        Panel::new(&mut scene, world).polygon(&quarter, &paint(number));
    }
    number_tiles(&mut scene, window(1.0), &pair);
    Ok(scene.finish())
}

/// The colour of a trapezoid: of those with one hue the later ones are paler.
fn paint(number: usize) -> Paint {
    let paler = (number / SERIES.len() * 90).min(200) as u16;
    let color: Color = SERIES[number % SERIES.len()].mixed(PAPER, paler);
    Paint::fill(color, 0.34)
}

/// The quarters of all tiles, each at a corner, with the trapezoid that holds the dual face near the crossing.
fn quarters(pair: &DualPair, cut: &Cutting<'_>) -> Vec<(usize, Vec<[f64; 2]>)> {
    let mut found = Vec::new();
    for crossing in &pair.crossings {
        let [v, w] = crossing.pair.map(|index| pair.generators[index]);
        let determinant = v[0] * w[1] - v[1] * w[0];
        for [s, t] in [[1.0, 1.0], [-1.0, 1.0], [-1.0, -1.0], [1.0, -1.0]] {
            // the point where the two lines have the values s and t, times little
            let [x, y] = [(s * w[1] - t * v[1]) / determinant, (t * v[0] - s * w[0]) / determinant];
            let beside = [crossing.place[0] + BESIDE * x, crossing.place[1] + BESIDE * y];
            let trapezoid = cut.locate(beside).expect("the crossings of a figure are finite");
            let at = |a: f64, b: f64| [0, 1].map(|k| crossing.middle[k] + a * s * v[k] + b * t * w[k]);
            found.push((trapezoid.0 as usize, vec![at(0.0, 0.0), at(1.0, 0.0), at(1.0, 1.0), at(0.0, 1.0)]));
        }
    }
    found
}
