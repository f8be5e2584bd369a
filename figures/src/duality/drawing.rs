//! The two pictures of a [`DualPair`], in matching colours and with matching numbers.

use super::DualPair;
use super::crossings::{self, number_box, write_number};
use crate::scene::page::{Frame, PageBox, PagePoint, WorldBox};
use crate::scene::text::{Anchor, TextStyle};
use crate::scene::{Panel, Scene};
use crate::style::{Color, FOCUS, INK, PAPER, Paint, SERIES, Stroke, text_size, weight};

/// The colours of the generators.
pub(crate) const GENERATORS: [Color; 8] = [
    SERIES[0],
    SERIES[1],
    SERIES[2],
    SERIES[3],
    SERIES[4],
    SERIES[5],
    Color::new(0x4b, 0x4b, 0x9e),
    Color::new(0x99, 0x4f, 0x4f),
];

/// The sizes of the numbers of tiles, as shares of those of crossings.
const TILE_NUMBER_SIZES: [f64; 2] = [1.0, 9.0 / 11.0];

/// The gap between a number and the edges of its tile.
const EDGE_GAP: f64 = 1.0;

const SEPARATOR: Stroke = Stroke::new(INK, weight::STRONG);
const SEPARATOR_CHAIN: Stroke = Stroke::new(INK, 6.0);
const LEFT_TILE: Paint = Paint::fill(FOCUS, 0.3);
const RIGHT_TILE: Paint = Paint::fill(PAPER, 1.0);

/// The separator of a picture.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Separator {
    /// The number of tiles on the left of the separator.
    pub(crate) k: usize,
    /// Whether the name of the separator stands at its upper end.
    pub(crate) named: bool,
}

/// The place of the plane of the lines in a window of the page.
pub(crate) fn arrangement_frame(pair: &DualPair, window: PageBox, separator: Option<Separator>) -> Frame {
    let height = |x: f64, &[a, b, c]: &[f64; 3]| -(a * x + c) / b;
    let met = separator.iter().flat_map(|separator| {
        let x = pair.separator_x(separator.k);
        pair.generators.iter().map(move |line| [x, height(x, line)])
    });
    let places: Vec<[f64; 2]> = pair.crossings.iter().map(|crossing| crossing.place).chain(met).collect();
    // Equal scales, so that a line is seen at right angles to its generator's edges.
    Frame::fit(&WorldBox::around(&places).grown(0.16), window)
}

/// The place of the tiling in a window of the page.
pub(crate) fn tiling_frame(pair: &DualPair, window: PageBox) -> Frame {
    Frame::fit(&WorldBox::around(&pair.outline()), window)
}

/// Draws the lines with their crossings numbered from left to right and the vertical line L_k, in a window of the page.
pub(crate) fn draw_arrangement(scene: &mut Scene, window: PageBox, pair: &DualPair, separator: Option<Separator>) {
    let mut panel = Panel::new(scene, arrangement_frame(pair, window, separator));
    for (index, &[a, b, c]) in pair.generators.iter().enumerate() {
        let color = color(index);
        let ends = panel.line([0.0, -c / b], [b, -a], &window, &generator_stroke(index));
        if let Some((_, end)) = ends {
            let style = TextStyle::new(text_size::LABEL, color).bold();
            panel.scene().label(end, [-0.6, -0.8], &style, &format!("$ℓ_{{{}}}$", index + 1));
        }
    }
    let left = separator.map_or(0, |separator| separator.k);
    if let Some(Separator { k, named }) = separator {
        let x = panel.place([pair.separator_x(k), 0.0]).x;
        let top = PagePoint::new(x, window.min.y - 6.0);
        panel.scene().segment(top, PagePoint::new(x, window.max.y), &SEPARATOR);
        if named {
            let style = TextStyle::new(text_size::LABEL, INK);
            panel.scene().text(top.moved(0.0, -6.0), Anchor::Middle, &style, &format!("$L_{{{k}}}$"));
        }
    }
    let places: Vec<[f64; 2]> = pair.crossings.iter().map(|crossing| crossing.place).collect();
    crossings::draw(&mut panel, &places, left);
}

/// Draws the tiles with the numbers of their crossings and the chain L'_k.
pub(crate) fn draw_tiling(scene: &mut Scene, window: PageBox, pair: &DualPair, separator: Option<Separator>) {
    draw_tiles(scene, window, pair, separator);
    number_tiles(scene, window, pair);
}

/// Draws the tiles and the chain L'_k.
pub(crate) fn draw_tiles(scene: &mut Scene, window: PageBox, pair: &DualPair, separator: Option<Separator>) {
    let left = separator.map_or(0, |separator| separator.k);
    let mut panel = Panel::new(scene, tiling_frame(pair, window));
    for (index, crossing) in pair.crossings.iter().enumerate() {
        panel.polygon(&pair.tile(crossing), if index < left { &LEFT_TILE } else { &RIGHT_TILE });
    }
    if let Some(Separator { k, named }) = separator {
        let chain = pair.chain(k);
        panel.polyline(&chain, &SEPARATOR_CHAIN);
        if named {
            let top = panel.place(chain[0]);
            let style = TextStyle::new(text_size::LABEL, INK);
            panel.scene().text(top.moved(0.0, -8.0), Anchor::Middle, &style, &format!("$L'_{{{k}}}$"));
        }
    }
    for face in pair.crossings.iter().map(|crossing| pair.upper_face(crossing)) {
        let corner = |side: usize| {
            let [x, y, _] = face.corners[side % 4];
            [x, y]
        };
        for (side, &generator) in face.sides.iter().enumerate() {
            panel.segment(corner(side), corner(side + 1), &generator_stroke(generator));
        }
    }
}

/// Writes the numbers of the crossings on the tiles, smaller where the tile is narrow; tiles that are too narrow for
/// their number at its least size have none, as it would lie on their edges.
pub(crate) fn number_tiles(scene: &mut Scene, window: PageBox, pair: &DualPair) {
    let frame = tiling_frame(pair, window);
    for (index, crossing) in pair.crossings.iter().enumerate() {
        let corners: Vec<PagePoint> = pair.tile(crossing).iter().map(|&corner| frame.place(corner)).collect();
        let middle = frame.place(crossing.middle);
        let size = TILE_NUMBER_SIZES.into_iter().find(|&size| has_room(&corners, middle, number_box(index, size)));
        if let Some(size) = size {
            write_number(scene, middle, index, size);
        }
    }
}

/// Whether a box of this half width and half height about the middle of a convex tile keeps off its edges.
fn has_room(corners: &[PagePoint], middle: PagePoint, [half_width, half_height]: [f64; 2]) -> bool {
    corners.iter().zip(corners.iter().cycle().skip(1)).all(|(a, b)| {
        let (x, y) = (b.x - a.x, b.y - a.y);
        let away = ((middle.x - a.x) * y - (middle.y - a.y) * x).abs();
        away >= y.abs() * half_width + x.abs() * half_height + EDGE_GAP * libm::hypot(x, y)
    })
}

/// The line and the edges of a generator.
pub(crate) fn generator_stroke(generator: usize) -> Stroke {
    Stroke::new(color(generator), weight::MEDIUM + 0.4)
}

/// The colour of a generator; from the ninth on they repeat.
fn color(generator: usize) -> Color {
    GENERATORS[generator % GENERATORS.len()]
}
