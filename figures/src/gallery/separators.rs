//! All separators of a tiling, one panel each.

use crate::duality::{DualPair, Separator, draw_tiling};
use crate::figure::{Figure, FigureError, FigureInput};
use crate::scene::Scene;
use crate::scene::page::{PageBox, PagePoint};
use crate::scene::text::{Anchor, TextStyle};
use crate::style::{GREY, text_size};

/// The sweep of the separators.
pub const FIGURE: Figure = Figure {
    id: "separators",
    title: "The separators sweep the tiling",
    caption: "As the vertical line L_k moves over the crossings of the dual lines from left to right, its chain L'_k \
              passes over the tiles one by one: from one panel to the next two consecutive steps of the chain change \
              places, around the tile that has been passed. The words below a panel are the order of the generators \
              from top to bottom.",
    claims: &["separator-order", "separators", "separator-steps"],
    experiments: &[],
    deterministic: true,
    draw,
};

const GENERATOR_ROWS: [[f64; 3]; 5] =
    [[8.0, 2.0, -7.0], [6.0, 6.0, 11.0], [0.0, 8.0, -10.0], [-6.0, 7.0, 9.0], [-8.0, 3.0, -9.0]];
const COLUMNS: usize = 4;
const CELL: [f64; 2] = [230.0, 254.0];

fn draw(_: &FigureInput<'_>) -> Result<String, FigureError> {
    Ok(sweep(&DualPair::new(&GENERATOR_ROWS), FIGURE.title, FIGURE.caption))
}

/// A panel for every separator of a tiling.
pub(crate) fn sweep(pair: &DualPair, title: &str, description: &str) -> String {
    let panels = pair.crossings.len() + 1;
    let rows = panels.div_ceil(COLUMNS);
    let mut scene = Scene::new(CELL[0] * COLUMNS as f64, CELL[1] * rows as f64 + 8.0, title, description);
    for k in 0..panels {
        let (left, top) = (CELL[0] * (k % COLUMNS) as f64, CELL[1] * (k / COLUMNS) as f64);
        scene.heading(PagePoint::new(left + CELL[0] / 2.0, top + 22.0), &format!("$k$ = {k}"));
        let window = PageBox::new(left + 16.0, top + 34.0, CELL[0] - 32.0, CELL[1] - 68.0);
        draw_tiling(&mut scene, window, pair, Some(Separator { k, named: false }));
        let order = pair.order_on(pair.separator_x(k));
        let words: Vec<String> = order.iter().map(|index| (index + 1).to_string()).collect();
        let style = TextStyle::new(text_size::NOTE, GREY);
        scene.text(
            PagePoint::new(left + CELL[0] / 2.0, top + CELL[1] - 12.0),
            Anchor::Middle,
            &style,
            &words.join(" "),
        );
    }
    scene.finish()
}
