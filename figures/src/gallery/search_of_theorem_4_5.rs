//! The search of Theorem 4.5, one panel a vertical line.

use crate::figure::{Figure, FigureError, FigureInput};
use crate::min_area::{DrawnLine, Polygon};
use crate::scene::page::{Frame, PageBox, PagePoint, WorldBox};
use crate::scene::text::{Anchor, TextStyle};
use crate::scene::{LegendEntry, Panel, Sample, Scene};
use crate::style::{
    ENCLOSING, FOCUS, GREY, INK, INPUT, INPUT_POINT, Marker, OPTIMAL_CENTER, PALE, Paint, REFLECTED, Shape, Stroke,
    text_size, weight,
};
use zonotope::lad::by_slope_selection::{SearchStep, Side};
use zonotope::numeric::Rational;

/// The search of Theorem 4.5.
pub const FIGURE: Figure = Figure {
    id: "search-of-theorem-4-5",
    title: "The search of Theorem 4.5",
    caption: "The candidates are the vertices of the arrangement of the lines ℓ_t. Each step draws the vertical line \
              through the median candidate, found by slope selection, and finds the minimum of f on it. The directions \
              in which f falls from there tell on which side the optimum lies; the candidates on the other side and on \
              the line are discarded, at least half of all. The search ends when the minimum on the line is the \
              minimum of f. Panels that say so are magnified.",
    claims: &["theorem-4.5", "halving-search", "deciding-side", "coefficient-at-line-minimum", "ties-of-candidates"],
    experiments: &[],
    deterministic: true,
    draw,
};

/// The points of the figure.
const POINTS: [[f64; 2]; 7] =
    [[0.0, 32.0], [8.0, 10.0], [66.0, 2.0], [86.0, 22.0], [86.0, 40.0], [70.0, 60.0], [38.0, 66.0]];
/// The seed of the random choices in slope selection, which affect the time only.
const SEED: u64 = 1;

const COLUMNS: usize = 3;
const CELL: [f64; 2] = [280.0, 262.0];
/// A view is magnified until the strip of the candidates takes at least this part of its width.
const LEAST_STRIP: f64 = 0.5;
/// No view is magnified more: where the lines nearly go through one point, the strip has no width that can be shown.
const MOST_MAGNIFIED: f64 = 1e6;
const LINE: Stroke = Stroke::new(REFLECTED, 0.9).faded(0.55);
const VERTICAL: Stroke = Stroke::new(INK, weight::STRONG);
const CANDIDATE: Marker = Marker::new(Shape::Disc, 3.0, INK);
const DISCARDED: Marker = Marker::new(Shape::Disc, 2.4, PALE.mixed(GREY, 110));
const LINE_MINIMUM: Marker = Marker::new(Shape::Diamond, 6.5, FOCUS);
const ZONOGON: Paint = Paint::fill(ENCLOSING, 0.08).with_outline(Stroke::new(ENCLOSING, weight::STRONG));
const INPUT_POLYGON: Paint = Paint::fill(INPUT, 0.16).with_outline(Stroke::new(INPUT, weight::MEDIUM));
const RULED_OUT: Paint = Paint::fill(PALE, 0.38);
const NEWLY_RULED_OUT: Paint = Paint::fill(FOCUS, 0.25);

/// A vertex of the arrangement.
struct Vertex {
    place: [f64; 2],
    exact_x: Rational,
}

/// The strip of the candidates before a step; without ends at first.
#[derive(Default)]
struct Strip {
    left: Option<(f64, Rational)>,
    right: Option<(f64, Rational)>,
}

impl Strip {
    fn holds(&self, x: &Rational) -> bool {
        self.left.as_ref().is_none_or(|(_, left)| left < x) && self.right.as_ref().is_none_or(|(_, right)| x < right)
    }

    fn narrow(&mut self, step: &SearchStep) {
        let end = Some((step.x, step.exact_x.clone()));
        match step.side {
            Side::Left => self.right = end,
            Side::Right => self.left = end,
            Side::Optimal | Side::Unbounded => {}
        }
    }
}

fn draw(_: &FigureInput<'_>) -> Result<String, FigureError> {
    Ok(search(&Polygon::of_figure(&POINTS), FIGURE.title, FIGURE.caption))
}

/// A panel for each step of the search for the best centre around a polygon, and one for the answer.
pub(crate) fn search(polygon: &Polygon, title: &str, description: &str) -> String {
    let lines = polygon.lines();
    let candidates = polygon.candidates().into_iter();
    let mut vertices: Vec<Vertex> =
        candidates.map(|vertex| Vertex { place: vertex.point, exact_x: vertex.exact_x() }).collect();
    vertices.sort_by(|a, b| a.exact_x.cmp(&b.exact_x));
    let steps = polygon.search(SEED);

    let width = CELL[0] * COLUMNS as f64;
    let legend_top = CELL[1] * (steps.len() + 1).div_ceil(COLUMNS) as f64;
    let mut scene = Scene::new(width, legend_top + 54.0, title, description);
    let mut strip = Strip::default();
    for (number, step) in steps.iter().enumerate() {
        draw_step(&mut scene, cell(number), &Step { number, step, strip: &strip, lines: &lines, vertices: &vertices });
        strip.narrow(step);
    }
    draw_answer(&mut scene, cell(steps.len()), polygon);
    let entries = [
        LegendEntry::new(Sample::Line(LINE), "lines $ℓ_t$"),
        LegendEntry::new(Sample::Point(CANDIDATE), "candidate"),
        LegendEntry::new(Sample::Point(DISCARDED), "discarded"),
        LegendEntry::new(Sample::Line(VERTICAL), "vertical line through the median candidate"),
        LegendEntry::new(Sample::Point(LINE_MINIMUM), "minimum of $f$ on it"),
        LegendEntry::new(Sample::Area(NEWLY_RULED_OUT), "side discarded in this step"),
        LegendEntry::new(Sample::Area(RULED_OUT), "discarded before"),
        LegendEntry::new(Sample::Point(OPTIMAL_CENTER), "optimum"),
    ];
    scene.legend(PagePoint::new(0.0, legend_top + 4.0), width, &entries);
    scene.finish()
}

/// The place of a panel.
fn cell(number: usize) -> PageBox {
    let (column, row) = (number % COLUMNS, number / COLUMNS);
    PageBox::new(CELL[0] * column as f64, CELL[1] * row as f64, CELL[0], CELL[1])
}

/// The picture's part of a panel, below its two lines of text.
const fn window_of(cell: &PageBox) -> PageBox {
    PageBox::new(cell.min.x + 8.0, cell.min.y + 50.0, cell.width() - 16.0, cell.height() - 62.0)
}

fn write_head(scene: &mut Scene, cell: &PageBox, heading: &str, note: &str) {
    let middle = cell.center().x;
    scene.heading(PagePoint::new(middle, cell.min.y + 20.0), heading);
    let style = TextStyle::new(text_size::NOTE, GREY);
    scene.text(PagePoint::new(middle, cell.min.y + 39.0), Anchor::Middle, &style, note);
}

/// The polygon and the zonogon that the search was for.
fn draw_answer(scene: &mut Scene, cell: PageBox, polygon: &Polygon) {
    let best = polygon.optimum();
    let corners = best.body.vertices();
    let mut panel = Panel::new(scene, Frame::fit(&WorldBox::around(&corners), window_of(&cell).inset(14.0)));
    panel.polygon(&corners, &ZONOGON);
    panel.polygon(polygon.vertices(), &INPUT_POLYGON);
    panel.markers(polygon.vertices(), &INPUT_POINT);
    panel.marker(best.body.center(), &OPTIMAL_CENTER);
    write_head(scene, &cell, "The answer", "the polygon in its zonogon of least area");
}

/// A step with what is needed to draw it.
struct Step<'a> {
    number: usize,
    step: &'a SearchStep,
    strip: &'a Strip,
    lines: &'a [DrawnLine],
    vertices: &'a [Vertex],
}

/// The content of a panel, and its scale beside that of the first panel.
fn view_of(drawn: &Step<'_>) -> (WorldBox, f64) {
    let &Step { step, strip, vertices, .. } = drawn;
    let all = WorldBox::around(vertices.iter().map(|vertex| &vertex.place)).grown(0.05);
    let left = strip.left.as_ref().map_or(all.min[0], |(x, _)| *x);
    let right = strip.right.as_ref().map_or(all.max[0], |(x, _)| *x);
    let size = [0, 1].map(|axis| all.max[axis] - all.min[axis]);
    let magnification = magnification(right - left, size[0]);
    if magnification == 1.0 {
        return (all, magnification);
    }
    let middle = [(left + right) / 2.0, step.minimum.map_or((all.min[1] + all.max[1]) / 2.0, |[_, y]| y)];
    let half = size.map(|length| length / 2.0 / magnification);
    let view = WorldBox {
        min: [0, 1].map(|axis| middle[axis] - half[axis]),
        max: [0, 1].map(|axis| middle[axis] + half[axis]),
    };
    (view, magnification)
}

/// The magnification that shows a strip of a view of this width, from 1 to the most.
fn magnification(strip: f64, width: f64) -> f64 {
    libm::ceil(LEAST_STRIP * width / strip).clamp(1.0, MOST_MAGNIFIED)
}

/// The words for a magnification; at the most the strip may be too narrow to be seen, and they say why.
fn magnified(magnification: f64) -> String {
    if magnification < MOST_MAGNIFIED {
        format!("{magnification} ×")
    } else {
        format!("{magnification} ×: here the lines nearly meet in one point")
    }
}

fn draw_step(scene: &mut Scene, cell: PageBox, drawn: &Step<'_>) {
    let &Step { number, step, strip, lines, vertices } = drawn;
    let window = window_of(&cell);
    let (view, magnification) = view_of(drawn);
    let mut panel = Panel::new(scene, Frame::fit(&view, window));
    let page_x = |x: f64| panel.place([x, 0.0]).x.clamp(window.min.x, window.max.x);

    let here = page_x(step.x);
    let left = strip.left.as_ref().map_or(window.min.x, |(x, _)| page_x(*x));
    let right = strip.right.as_ref().map_or(window.max.x, |(x, _)| page_x(*x));
    let mut shade = |from: f64, to: f64, paint: &Paint| {
        let (top, bottom) = (window.min.y, window.max.y);
        let corners = [(from, top), (to, top), (to, bottom), (from, bottom)].map(|(x, y)| PagePoint::new(x, y));
        if from < to {
            panel.scene().polygon(&corners, paint);
        }
    };
    shade(window.min.x, left, &RULED_OUT);
    shade(right, window.max.x, &RULED_OUT);
    match step.side {
        Side::Left => shade(here, right, &NEWLY_RULED_OUT),
        Side::Right => shade(left, here, &NEWLY_RULED_OUT),
        Side::Optimal | Side::Unbounded => {}
    }
    for line in lines {
        panel.line(line.point, line.direction, &window, &LINE);
    }
    panel.scene().segment(PagePoint::new(here, window.min.y), PagePoint::new(here, window.max.y), &VERTICAL);
    for vertex in vertices {
        if window.holds(panel.place(vertex.place)) {
            panel.marker(vertex.place, if strip.holds(&vertex.exact_x) { &CANDIDATE } else { &DISCARDED });
        }
    }
    if let Some(minimum) = step.minimum {
        let optimal = step.side == Side::Optimal;
        panel.marker(minimum, if optimal { &OPTIMAL_CENTER } else { &LINE_MINIMUM });
        let towards = match step.side {
            Side::Left => -30.0,
            Side::Right => 30.0,
            Side::Optimal | Side::Unbounded => 0.0,
        };
        if towards != 0.0 {
            let from = panel.place(minimum);
            panel.scene().arrow(from.moved(towards / 4.0, 0.0), from.moved(towards, 0.0), &Stroke::new(INK, 1.8));
        }
    }
    let outcome = match step.side {
        Side::Left => "the optimum is to the left",
        Side::Right => "the optimum is to the right",
        Side::Optimal => "the minimum on the line is the optimum",
        Side::Unbounded => "no minimum",
    };
    let heading = match step.vertices_before {
        1 => format!("Step {}: 1 candidate", number + 1),
        before => format!("Step {}: {before} candidates", number + 1),
    };
    if magnification > 1.0 {
        let style = TextStyle::new(text_size::NOTE, GREY).haloed();
        panel.scene().text(window.max.moved(-6.0, -7.0), Anchor::End, &style, &magnified(magnification));
    }
    write_head(scene, &cell, &heading, outcome);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_strip_without_width_is_magnified_no_more_than_can_be_shown() {
        assert_eq!(magnification(2.0, 2.0), 1.0);
        assert_eq!(magnified(magnification(0.125, 2.0)), "8 ×");
        for strip in [0.0, 1e-300, 1e-15] {
            assert_eq!(magnified(magnification(strip, 2.0)), "1000000 ×: here the lines nearly meet in one point");
        }
    }
}
