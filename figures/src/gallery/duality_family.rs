//! The duality for four to eight generators, beside the zonohedra.

use crate::duality::{DualPair, draw_arrangement, draw_tiling, generator_stroke};
use crate::figure::{Figure, FigureError, FigureInput};
use crate::scene::page::{Frame, PageBox, PagePoint, WorldBox};
use crate::scene::text::{Anchor, TextStyle};
use crate::scene::{Panel, Scene};
use crate::solid::{self, Camera};
use crate::style::{GREY, INPUT, Paint, text_size};

/// The duality for four to eight generators.
pub const FIGURE: Figure = Figure {
    id: "duality-family",
    title: "Arrangement, tiling and zonohedron",
    caption: "For n = 4 to 8 generators: the lines of the generators with their n(n − 1)/2 crossings numbered from \
              left to right, the tiling of Q with the dual tiles under the same numbers, and the zonohedron whose \
              upper hull it is. Line, edges of the tiling and edges of the body that belong to one generator have one \
              colour. Tiles that are too narrow for their number have none.",
    claims: &["tiling-arrangement-duality", "upper-hull-tiling"],
    experiments: &[],
    deterministic: true,
    draw,
};

const FAMILY: [&[[f64; 3]]; 5] = [
    &[[7.0, 2.0, 12.0], [4.0, 6.0, 5.0], [-3.0, 8.0, 0.0], [-8.0, 5.0, 2.0]],
    &[[8.0, 2.0, -7.0], [6.0, 6.0, 11.0], [0.0, 8.0, -10.0], [-6.0, 7.0, 9.0], [-8.0, 3.0, -9.0]],
    &[[8.0, 3.0, -4.0], [5.0, 5.0, 5.0], [3.0, 10.0, -5.0], [-3.0, 7.0, 6.0], [-7.0, 6.0, -6.0], [-9.0, 3.0, -12.0]],
    &[
        [9.0, 1.0, 11.0],
        [6.0, 5.0, -6.0],
        [4.0, 7.0, 8.0],
        [1.0, 7.0, -1.0],
        [-1.0, 9.0, -13.0],
        [-6.0, 7.0, 14.0],
        [-8.0, 4.0, 0.0],
    ],
    &[
        [8.0, 2.0, 11.0],
        [5.0, 4.0, 14.0],
        [5.0, 9.0, 2.0],
        [1.0, 8.0, 13.0],
        [-1.0, 8.0, 6.0],
        [-3.0, 8.0, -4.0],
        [-6.0, 3.0, 12.0],
        [-10.0, 1.0, 0.0],
    ],
];

const ROW: f64 = 330.0;
const COLUMN: f64 = 330.0;
const TOP: f64 = 46.0;

fn draw(_: &FigureInput<'_>) -> Result<String, FigureError> {
    let mut scene = Scene::new(3.0 * COLUMN, TOP + ROW * FAMILY.len() as f64, FIGURE.title, FIGURE.caption);
    for (column, heading) in ["Lines", "Tiles", "Body"].into_iter().enumerate() {
        scene.heading(PagePoint::new(COLUMN * (column as f64 + 0.5), 24.0), heading);
    }
    let camera = Camera::from_direction([1.0, -3.0, 2.2]);
    for (row, generators) in FAMILY.into_iter().enumerate() {
        let pair = DualPair::new(generators);
        let top = TOP + ROW * row as f64;
        let window = |column: f64| PageBox::new(COLUMN * column + 24.0, top + 34.0, COLUMN - 48.0, ROW - 58.0);
        let style = TextStyle::new(text_size::NOTE, GREY);
        let note = format!("$n$ = {}, {} crossings", generators.len(), pair.crossings.len());
        scene.text(PagePoint::new(COLUMN * 0.5, top + 8.0), Anchor::Middle, &style, &note);
        let note = format!("{} tiles", pair.crossings.len());
        scene.text(PagePoint::new(COLUMN * 1.5, top + 8.0), Anchor::Middle, &style, &note);
        let faces = pair.faces();
        scene.text(PagePoint::new(COLUMN * 2.5, top + 8.0), Anchor::Middle, &style, &format!("{} facets", faces.len()));

        draw_arrangement(&mut scene, window(0.0), &pair, None);
        draw_tiling(&mut scene, window(1.0), &pair, None);
        let seen: Vec<[f64; 2]> =
            faces.iter().flat_map(|face| &face.corners).map(|&corner| camera.project(corner)).collect();
        let mut panel = Panel::new(&mut scene, Frame::fit(&WorldBox::around(&seen), window(2.0)));
        let paint = |face: &solid::Face| Paint::fill(INPUT, 0.26 - 0.22 * camera.squareness(face));
        solid::draw(&mut panel, &camera, &faces, paint, generator_stroke);
    }
    Ok(scene.finish())
}
