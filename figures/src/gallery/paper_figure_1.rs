//! The paper's Figure 1: the line arrangement and the tiling dual to it.

use crate::duality::{DualPair, GENERATORS, Separator, draw_arrangement, draw_tiling};
use crate::figure::{Figure, FigureError, FigureInput};
use crate::scene::page::{PageBox, PagePoint};
use crate::scene::text::{Anchor, TextStyle};
use crate::scene::{LegendEntry, Sample, Scene};
use crate::style::{FOCUS, GREY, INK, Paint, Stroke, text_size, weight};

/// The duality of the paper's Figure 1.
pub const FIGURE: Figure = Figure {
    id: "paper-figure-1",
    title: "The duality of the paper's Figure 1",
    caption: "Left: the lines ℓ_i of four generators, their crossings numbered from left to right, and the vertical \
              line L_3 just right of the third crossing. Right: the upper hull of the zonohedron seen from above, a \
              tiling; the tile with the number of a crossing is spanned by the projections of its two generators, in \
              the colours of the lines. L'_3 starts at the top and follows the generators in the order in which L_3 \
              meets their lines from top to bottom; the tiles on its left are those of the first three crossings.",
    claims: &["figure-1", "upper-hull-tiling", "tiling-arrangement-duality", "separator-order", "separators"],
    experiments: &[],
    deterministic: true,
    draw,
};

const GENERATOR_ROWS: [[f64; 3]; 4] = [[7.0, 2.0, 12.0], [4.0, 6.0, 5.0], [-3.0, 8.0, 0.0], [-8.0, 5.0, 2.0]];
const K: usize = 3;
const SEPARATOR: Separator = Separator { k: K, named: true };

fn draw(_: &FigureInput<'_>) -> Result<String, FigureError> {
    let pair = DualPair::new(&GENERATOR_ROWS);
    let mut scene = Scene::new(820.0, 470.0, FIGURE.title, FIGURE.caption);
    scene.heading(PagePoint::new(205.0, 24.0), "Line arrangement Π");
    scene.heading(PagePoint::new(615.0, 24.0), "Tiling 𝒯 of Q");
    draw_arrangement(&mut scene, PageBox::new(30.0, 66.0, 350.0, 320.0), &pair, Some(SEPARATOR));
    draw_tiling(&mut scene, PageBox::new(440.0, 66.0, 350.0, 320.0), &pair, Some(SEPARATOR));

    let order = pair.order_on(pair.separator_x(K));
    let listed = |symbol: &str| order.iter().map(|i| format!("${symbol}_{}$", i + 1)).collect::<Vec<_>>().join(", ");
    let style = TextStyle::new(text_size::NOTE, GREY);
    let from_top = format!("$L_{K}$ meets from top to bottom {}", listed("ℓ"));
    scene.text(PagePoint::new(205.0, 412.0), Anchor::Middle, &style, &from_top);
    let down = format!("$L'_{K}$ goes down by {}", listed("2v'"));
    scene.text(PagePoint::new(615.0, 412.0), Anchor::Middle, &style, &down);
    let entries = [
        LegendEntry::new(Sample::Line(Stroke::new(GENERATORS[0], weight::STRONG)), "line $ℓ_i$ and edges along $v'_i$"),
        LegendEntry::new(Sample::Area(Paint::fill(FOCUS, 0.3)), "the first three crossings, their tiles"),
        LegendEntry::new(Sample::Line(Stroke::new(INK, weight::STRONG)), "separator"),
    ];
    scene.legend(PagePoint::new(20.0, 432.0), 780.0, &entries);
    Ok(scene.finish())
}
