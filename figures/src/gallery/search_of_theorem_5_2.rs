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
    let asked = Asked { pair: DualPair::new(&GENERATOR_ROWS), upright: Vec::new(), point: POINT };
    Ok(search(&asked, FIGURE.title, FIGURE.caption))
}

/// Generators around the origin, and the point that is searched for.
pub(crate) struct Asked {
    /// The generators that have lines, with their tiles.
    pub(crate) pair: DualPair,
    /// Generators that point straight up, which raise every tile.
    pub(crate) upright: Vec<[f64; 3]>,
    /// The point.
    pub(crate) point: [f64; 3],
}

/// A panel for each step of the search for the tile over which a point lies, and one for that tile.
pub(crate) fn search(asked: &Asked, title: &str, description: &str) -> String {
    let generators = [asked.pair.generators.as_slice(), &asked.upright].concat();
    let body = Zonotope::new([0.0; 3], generators).expect("generators that are drawn are finite");
    let question = Query::of_point(asked.point, &body).expect("points that are drawn are finite");
    let trace = by_slope_selection::trace(&question, SEED);
    let steps: Vec<&SearchStep> = trace.steps.iter().filter(|step| step.hull == Hull::Upper).collect();

    let width = CELL[0] * COLUMNS as f64;
    let legend_top = CELL[1] * (steps.len() + 1).div_ceil(COLUMNS) as f64;
    let mut scene = Scene::new(width, legend_top + 40.0, title, description);
    let mut strip = Strip::WHOLE;
    for (number, step) in steps.iter().enumerate() {
        draw_step(&mut scene, cell(number), asked, number, step, strip);
        strip = strip.after(step);
    }
    draw_tile(&mut scene, cell(steps.len()), asked, &trace);
    let entries = [
        LegendEntry::new(Sample::Area(CANDIDATE.with_outline(Stroke::new(GREY, 0.8))), "candidate tile"),
        LegendEntry::new(Sample::Area(NEWLY_DROPPED), "dropped in this step"),
        LegendEntry::new(Sample::Area(DROPPED), "dropped before"),
        LegendEntry::new(Sample::Line(CHAIN), "separator"),
        LegendEntry::new(Sample::Point(QUERY), "$p_0$"),
    ];
    scene.legend(PagePoint::new(0.0, legend_top + 4.0), width, &entries);
    scene.finish()
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
    Asked { pair, point, .. }: &Asked,
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
    panel.marker([point[0], point[1]], &QUERY);
    panel
}

fn draw_step(scene: &mut Scene, cell: PageBox, asked: &Asked, number: usize, step: &SearchStep, strip: Strip) {
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
    draw_tiles(scene, &cell, asked, paint, Some(chain));
    let heading = match step.tiles_before {
        1 => format!("Step {}: 1 tile", number + 1),
        before => format!("Step {}: {before} tiles", number + 1),
    };
    write_head(scene, &cell, &heading, outcome);
}

/// The tile over which p lies, and what the facet says.
fn draw_tile(scene: &mut Scene, cell: PageBox, asked: &Asked, trace: &Trace) {
    let tile = trace.tiles.iter().find(|tile| tile.hull == Hull::Upper);
    let mut panel = draw_tiles(scene, &cell, asked, |_| DROPPED, None);
    let Some(tile) = tile else {
        write_head(scene, &cell, "No tile", "p₀ is beside all tiles: p is outside");
        return;
    };
    panel.polygon(&tile.corners, &FOUND.with_outline(Stroke::new(INK, 2.0)));
    panel.marker([asked.point[0], asked.point[1]], &QUERY);
    let names: Vec<String> = tile.generators.iter().map(|index| (index + 1).to_string()).collect();
    let words = if tile.depth >= 0.0 { "below" } else { "above" };
    let note = format!("p is {} {words} the facet", short(tile.depth.abs()));
    write_head(scene, &cell, &format!("The tile of generators {}", names.join(" and ")), &note);
}

/// A height with two decimals, or with a power of ten where these say little.
fn short(height: f64) -> String {
    if height == 0.0 || (0.01..1e6).contains(&height) { format!("{height:.2}") } else { format!("{height:.2e}") }
}
