//! The search of Theorem 5.2, one panel a separator.

use crate::duality::{DualPair, generator_stroke};
use crate::figure::{Figure, FigureError, FigureInput};
use crate::scene::page::{Frame, PageBox, PagePoint, WorldBox};
use crate::scene::text::{Anchor, TextStyle};
use crate::scene::{LegendEntry, Panel, Sample, Scene};
use crate::style::{FOCUS, GREY, INK, Marker, OPTIMUM, PALE, PAPER, Paint, Shape, Stroke, text_size};
use zonotope::collision::Query;
use zonotope::collision::by_slope_selection::{self, Hull, SearchStep, Side, Trace};
use zonotope::zonotope::Zonotope;

/// The search of Theorem 5.2.
pub const FIGURE: Figure = Figure {
    id: "search-of-theorem-5-2",
    title: "The search of Theorem 5.2",
    caption: "Is the point p below the upper hull? Its projection p_0 is located among the tiles. Each step takes the \
              separator at the median of the dual vertices that are left, found by slope selection, compares p_0 with \
              the chain, and drops the tiles on the other side, at least half of them. When p_0 lies between the \
              chains just left and just right of a vertex, in its tile, the height of the facet over p_0 decides. The \
              search for the lower hull is the same for −p_0.",
    claims: &["theorem-5.2"],
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
const POINT: [f64; 3] = [14.0, -3.0, 4.0];
/// The seed of the random choices in slope selection.
const SEED: u64 = 1;
const COLUMNS: usize = 3;
const CELL: [f64; 2] = [280.0, 306.0];
const CANDIDATE: Paint = Paint::fill(PAPER, 1.0);
const DROPPED: Paint = Paint::fill(PALE, 0.45);
const NEWLY_DROPPED: Paint = Paint::fill(FOCUS, 0.3);
const FOUND: Paint = Paint::fill(OPTIMUM, 0.3);
const CHAIN: Stroke = Stroke::new(INK, 4.5);
const QUERY: Marker = Marker::new(Shape::Diamond, 6.0, OPTIMUM);

/// The tiles that are still candidates, by the abscissas of their dual vertices.
#[derive(Clone, Copy)]
struct Strip {
    left: f64,
    right: f64,
}

impl Strip {
    const WHOLE: Self = Self { left: f64::NEG_INFINITY, right: f64::INFINITY };

    fn holds(&self, x: f64) -> bool {
        self.left < x && x < self.right
    }

    fn after(&self, step: &SearchStep) -> Self {
        match step.side {
            Side::Left => Self { right: step.x, ..*self },
            Side::Right => Self { left: step.x, ..*self },
            Side::Within => *self,
        }
    }
}

fn draw(_: &FigureInput<'_>) -> Result<String, FigureError> {
    let pair = DualPair::new(&GENERATOR_ROWS);
    let body = Zonotope::new([0.0; 3], GENERATOR_ROWS.to_vec()).expect("the coordinates are small integers");
    let question = Query::of_point(POINT, &body).expect("the coordinates are small integers");
    let trace = by_slope_selection::trace(&question, SEED);
    let steps: Vec<&SearchStep> = trace.steps.iter().filter(|step| step.hull == Hull::Upper).collect();

    let width = CELL[0] * COLUMNS as f64;
    let legend_top = CELL[1] * (steps.len() + 1).div_ceil(COLUMNS) as f64;
    let mut scene = Scene::new(width, legend_top + 40.0, FIGURE.title, FIGURE.caption);
    let mut strip = Strip::WHOLE;
    for (number, step) in steps.iter().enumerate() {
        draw_step(&mut scene, cell(number), &pair, number, step, strip);
        strip = strip.after(step);
    }
    draw_tile(&mut scene, cell(steps.len()), &pair, &trace);
    let entries = [
        LegendEntry::new(Sample::Area(CANDIDATE.with_outline(Stroke::new(GREY, 0.8))), "candidate tile"),
        LegendEntry::new(Sample::Area(NEWLY_DROPPED), "dropped in this step"),
        LegendEntry::new(Sample::Area(DROPPED), "dropped before"),
        LegendEntry::new(Sample::Line(CHAIN), "separator"),
        LegendEntry::new(Sample::Point(QUERY), "$p_0$"),
    ];
    scene.legend(PagePoint::new(0.0, legend_top + 4.0), width, &entries);
    Ok(scene.finish())
}

fn cell(number: usize) -> PageBox {
    let (column, row) = (number % COLUMNS, number / COLUMNS);
    PageBox::new(CELL[0] * column as f64, CELL[1] * row as f64, CELL[0], CELL[1])
}

fn write_head(scene: &mut Scene, cell: &PageBox, heading: &str, note: &str) {
    let middle = cell.center().x;
    scene.heading(PagePoint::new(middle, cell.min.y + 20.0), heading);
    let style = TextStyle::new(text_size::NOTE, GREY);
    scene.text(PagePoint::new(middle, cell.min.y + 39.0), Anchor::Middle, &style, note);
}

/// The tiles in their paints, with their edges, in a panel of the cell.
fn draw_tiles<'a>(
    scene: &'a mut Scene,
    cell: &PageBox,
    pair: &DualPair,
    paint: impl Fn(f64) -> Paint,
    chain: Option<&[[f64; 2]]>,
) -> Panel<'a> {
    let window = PageBox::new(cell.min.x + 14.0, cell.min.y + 52.0, cell.width() - 28.0, cell.height() - 62.0);
    let mut panel = Panel::new(scene, Frame::fit(&WorldBox::around(&pair.outline()), window));
    for crossing in &pair.crossings {
        panel.polygon(&pair.tile(crossing), &paint(crossing.place[0]));
    }
    if let Some(chain) = chain {
        panel.polyline(chain, &CHAIN);
    }
    for crossing in &pair.crossings {
        let tile = pair.tile(crossing);
        for side in 0..4 {
            let stroke = Stroke { width: 1.0, ..generator_stroke(crossing.pair[side % 2]) };
            panel.segment(tile[side], tile[(side + 1) % 4], &stroke);
        }
    }
    panel.marker([POINT[0], POINT[1]], &QUERY);
    panel
}

fn draw_step(scene: &mut Scene, cell: PageBox, pair: &DualPair, number: usize, step: &SearchStep, strip: Strip) {
    let after = strip.after(step);
    let paint = |x: f64| match (strip.holds(x), after.holds(x)) {
        (_, true) => CANDIDATE,
        (true, false) => NEWLY_DROPPED,
        (false, false) => DROPPED,
    };
    let [left, right] = &step.chains;
    let (chain, outcome) = match step.side {
        Side::Left => (left, "p₀ is left of the chain"),
        Side::Right => (right, "p₀ is right of the chain"),
        Side::Within => (left, "p₀ is in the tile at the median"),
    };
    draw_tiles(scene, &cell, pair, paint, Some(chain));
    let heading = match step.tiles_before {
        1 => format!("Step {}: 1 tile", number + 1),
        before => format!("Step {}: {before} tiles", number + 1),
    };
    write_head(scene, &cell, &heading, outcome);
}

/// The tile over which p lies, and what the facet says.
fn draw_tile(scene: &mut Scene, cell: PageBox, pair: &DualPair, trace: &Trace) {
    let Some(tile) = trace.tiles.iter().find(|tile| tile.hull == Hull::Upper) else {
        return;
    };
    let mut panel = draw_tiles(scene, &cell, pair, |_| DROPPED, None);
    panel.polygon(&tile.corners, &FOUND.with_outline(Stroke::new(INK, 2.0)));
    panel.marker([POINT[0], POINT[1]], &QUERY);
    let names: Vec<String> = tile.generators.iter().map(|index| (index + 1).to_string()).collect();
    let words = if tile.depth >= 0.0 { "below" } else { "above" };
    let note = format!("p is {:.2} {words} the facet", tile.depth.abs());
    write_head(scene, &cell, &format!("The tile of generators {}", names.join(" and ")), &note);
}
