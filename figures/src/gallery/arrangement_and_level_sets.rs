//! The arrangement of the lines ℓ_t with level sets of the area of Z(O), and the optimum.

use crate::figure::{Figure, FigureError, FigureInput};
use crate::min_area::Polygon;
use crate::scene::page::{Frame, PageBox, PagePoint, WorldBox};
use crate::scene::text::{Anchor, TextStyle};
use crate::scene::{LegendEntry, Panel, Sample, Scene};
use crate::style::{
    Color, Dash, INK, INPUT, INPUT_POINT, OPTIMAL_CENTER, PAPER, Paint, REFLECTED, Stroke, text_size, weight,
};

/// The arrangement and the level sets.
pub const FIGURE: Figure = Figure {
    id: "arrangement-and-level-sets",
    title: "The area of Z(O) over the arrangement of the lines ℓ_t",
    caption: "Each edge of the polygon has a line ℓ_t, parallel to it, halfway to the farthest vertex: the edge is on \
              the boundary of Z(O) exactly when O lies on its left. The area f of Z(O) is affine in every cell of the \
              arrangement, so its level sets bend only at the lines; f is convex, so they are nested convex polygons, \
              and the minimum is at a vertex of the arrangement.",
    claims: &["lemma-4.1", "lemma-4.3", "corollary-4.4", "edge-criterion", "minimum-at-vertex"],
    experiments: &[],
    deterministic: true,
    draw,
};

/// A polygon without symmetry, the same as in the figure of its reflections.
const POINTS: [[f64; 2]; 7] = super::polygon_and_reflection::POINTS;

/// Levels as multiples of the least area, the largest first.
const LEVELS: [f64; 8] = [1.9, 1.7, 1.5, 1.35, 1.2, 1.1, 1.05, 1.01];
/// Smaller levels are too close to each other for names.
const LEAST_NAMED: f64 = 1.1;
/// The names stand on a ray from the optimum in this direction, between two lines.
const NAMES_TOWARDS: [f64; 2] = [-0.1, 1.0];

const WIDTH: f64 = 840.0;
const HEIGHT: f64 = 630.0;
const LINE: Stroke = Stroke::new(REFLECTED, 1.2);
const OUTLINE: Stroke = Stroke::new(INPUT, weight::MEDIUM).dashed(Dash::Dashed);
/// The innermost level sets have this colour, the outermost are near the page's.
const DEEP: Color = Color::new(0x5b, 0x8f, 0xb9);

fn draw(_: &FigureInput<'_>) -> Result<String, FigureError> {
    Ok(picture(&Polygon::of_figure(&POINTS), FIGURE.title, FIGURE.caption))
}

/// A polygon with its lines ℓ_t, level sets of f, and the minimum.
pub(crate) fn picture(polygon: &Polygon, title: &str, description: &str) -> String {
    let best = polygon.optimum();
    let lines = polygon.lines();
    let window = PageBox::new(20.0, 16.0, WIDTH - 40.0, 560.0);
    let mut scene = Scene::new(WIDTH, HEIGHT, title, description);
    let frame = Frame::fit(&WorldBox::around(polygon.vertices()), window.inset(28.0));
    let mut panel = Panel::new(&mut scene, frame);

    let center = best.body.center();
    draw_level_sets(&mut panel, polygon, center);
    panel.polygon(polygon.vertices(), &Paint::outline(OUTLINE));
    for (t, line) in lines.iter().enumerate() {
        let Some((from, to)) = panel.line_inside(line.point, line.direction, &window) else { continue };
        panel.scene().arrow(from, to, &LINE);
        let style = TextStyle::new(text_size::LABEL, REFLECTED);
        panel.scene().label(to, [from.x - to.x, from.y - to.y], &style, &format!("$ℓ_{{{}}}$", t + 1));
    }
    for (number, point) in polygon.vertices().iter().enumerate() {
        panel.marker(*point, &INPUT_POINT);
        let wish = [point[0] - center[0], point[1] - center[1]];
        panel.label(*point, wish, &TextStyle::new(text_size::LABEL, INPUT), &format!("$P_{{{}}}$", number + 1));
    }
    panel.marker(center, &OPTIMAL_CENTER);
    let entries = [
        LegendEntry::new(Sample::Line(OUTLINE), "polygon"),
        LegendEntry::new(Sample::Line(LINE), "line $ℓ_t$"),
        LegendEntry::new(Sample::Area(Paint::fill(shade(3), 1.0)), "level sets of $f$, as multiples of its minimum"),
        LegendEntry::new(Sample::Point(OPTIMAL_CENTER), "minimum"),
    ];
    scene.legend(PagePoint::new(20.0, 596.0), WIDTH - 40.0, &entries);
    scene.finish()
}

fn draw_level_sets(panel: &mut Panel<'_>, polygon: &Polygon, center: [f64; 2]) {
    let least = polygon.area_at(center);
    let sets = polygon.level_sets(&LEVELS.map(|factor| factor * least));
    let contour = Stroke::new(PAPER.mixed(INK, 120), weight::FINE);
    for (depth, (factor, corners)) in LEVELS.into_iter().zip(sets).enumerate() {
        panel.polygon(&corners, &Paint::fill(shade(depth), 1.0).with_outline(contour));
        if factor < LEAST_NAMED {
            continue;
        }
        if let Some(place) = crossing_with_ray(&corners, center, NAMES_TOWARDS) {
            let place = panel.place(place).moved(0.0, 4.0);
            let style = TextStyle::new(text_size::NOTE, INK);
            panel.scene().text(place, Anchor::Middle, &style.haloed(), &format!("{factor}"));
        }
    }
}

/// The colour of the level set of this depth.
const fn shade(depth: usize) -> Color {
    PAPER.mixed(DEEP, 40 + 30 * depth as u16)
}

/// The point where the boundary of a convex polygon around `center` meets the ray from there.
fn crossing_with_ray(corners: &[[f64; 2]], center: [f64; 2], ray: [f64; 2]) -> Option<[f64; 2]> {
    let side = |point: [f64; 2]| ray[0] * (point[1] - center[1]) - ray[1] * (point[0] - center[0]);
    (0..corners.len()).find_map(|i| {
        let (from, to) = (corners[i], corners[(i + 1) % corners.len()]);
        let (before, after) = (side(from), side(to));
        // Counter-clockwise the boundary passes the ray from its right to its left.
        (before < 0.0 && after >= 0.0).then(|| {
            let part = before / (before - after);
            [0, 1].map(|axis| from[axis] + part * (to[axis] - from[axis]))
        })
    })
}
