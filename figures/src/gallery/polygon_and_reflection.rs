//! A polygon, its reflection, and the zonogon around both, for some centre and for the best one.

use crate::figure::{Figure, FigureError, FigureInput};
use crate::min_area::Polygon;
use crate::scene::page::{Frame, PageBox, PagePoint, WorldBox};
use crate::scene::text::{Anchor, TextStyle};
use crate::scene::{LegendEntry, Panel, Sample, Scene};
use crate::style::{
    CENTER, Color, Dash, ENCLOSING, GREY, INK, INPUT, INPUT_POINT, Marker, OPTIMAL_CENTER, OPTIMUM, Paint, REFLECTED,
    REFLECTED_POINT, Stroke, text_size, weight,
};

/// The polygon and its reflection.
pub const FIGURE: Figure = Figure {
    id: "polygon-and-reflection",
    title: "The smallest zonogon around a polygon, for a given and for the best centre",
    caption: "A zonogon with centre O that contains the points P contains their reflections P' through O as well; \
              Z(O), the convex hull of both, is the smallest one. Its area depends on O: the least area over all \
              centres is that of the minimum-area enclosing zonogon.",
    claims: &["fixed-center-optimum", "theorem-4.5", "planar-symmetric-is-zonogon", "evaluation-in-linear-time"],
    experiments: &[],
    deterministic: true,
    draw,
};

/// A polygon without symmetry.
pub(super) const POINTS: [[f64; 2]; 7] =
    [[0.0, 1.2], [1.6, -0.4], [5.2, 0.0], [7.6, 2.2], [7.2, 4.4], [4.0, 5.6], [1.0, 4.0]];
/// A centre inside of the polygon, away from the best one.
const GIVEN: [f64; 2] = [4.7, 2.1];

const WIDTH: f64 = 840.0;
const HEIGHT: f64 = 420.0;
const INPUT_PAINT: Paint = Paint::fill(INPUT, 0.16).with_outline(Stroke::new(INPUT, weight::MEDIUM));
const REFLECTED_STROKE: Stroke = Stroke::new(REFLECTED, weight::MEDIUM).dashed(Dash::Dashed);
const MIDPOINT_STROKE: Stroke = Stroke::new(GREY, weight::FINE).dashed(Dash::Dotted);
const ENCLOSING_PAINT: Paint = Paint::fill(ENCLOSING, 0.07).with_outline(Stroke::new(ENCLOSING, weight::STRONG));

/// A centre and how it is shown.
struct Choice {
    center: [f64; 2],
    marker: Marker,
    name: &'static str,
    color: Color,
    heading: &'static str,
    left: f64,
}

fn draw(_: &FigureInput<'_>) -> Result<String, FigureError> {
    let polygon = Polygon::of_figure(&POINTS);
    let choices = [
        Choice { center: GIVEN, marker: CENTER, name: "$O$", color: INK, heading: "A given centre $O$", left: 20.0 },
        Choice {
            center: polygon.optimum().body.center(),
            marker: OPTIMAL_CENTER,
            name: "$O^*$",
            color: OPTIMUM,
            heading: "The best centre $O^*$",
            left: 430.0,
        },
    ];
    let corners: Vec<[f64; 2]> =
        choices.iter().flat_map(|choice| polygon.centered_zonogon(choice.center).vertices()).collect();
    let world = WorldBox::around(&corners);
    let mut scene = Scene::new(WIDTH, HEIGHT, FIGURE.title, FIGURE.caption);
    for choice in &choices {
        draw_choice(&mut scene, &polygon, choice, &world);
    }
    let entries = [
        LegendEntry::new(Sample::Area(INPUT_PAINT), "polygon $P$"),
        LegendEntry::new(Sample::Line(REFLECTED_STROKE), "its reflection $P'$"),
        LegendEntry::new(Sample::Area(ENCLOSING_PAINT), "$Z(O)$, the hull of both"),
        LegendEntry::new(Sample::Line(MIDPOINT_STROKE), "$O$ is the midpoint of $P_i$ and $P'_i$"),
    ];
    scene.legend(PagePoint::new(20.0, 386.0), WIDTH - 40.0, &entries);
    Ok(scene.finish())
}

fn draw_choice(scene: &mut Scene, polygon: &Polygon, choice: &Choice, world: &WorldBox) {
    let &Choice { center, marker, name, color, heading, left } = choice;
    let middle = left + 195.0;
    scene.heading(PagePoint::new(middle, 26.0), heading);
    let mut panel = Panel::new(scene, Frame::fit(world, PageBox::new(left + 30.0, 56.0, 330.0, 270.0)));
    let reflected = |point: &[f64; 2]| [0, 1].map(|axis| 2.0 * center[axis] - point[axis]);
    let reflections: Vec<[f64; 2]> = polygon.vertices().iter().map(reflected).collect();
    panel.polygon(&polygon.centered_zonogon(center).vertices(), &ENCLOSING_PAINT);
    panel.polygon(polygon.vertices(), &INPUT_PAINT);
    panel.polygon(&reflections, &Paint::outline(REFLECTED_STROKE));
    for (number, (point, reflection)) in polygon.vertices().iter().zip(&reflections).enumerate() {
        panel.segment(*point, *reflection, &MIDPOINT_STROKE);
        panel.marker(*point, &INPUT_POINT);
        panel.marker(*reflection, &REFLECTED_POINT);
        let wish = |point: &[f64; 2]| [point[0] - center[0], point[1] - center[1]];
        let names = [format!("$P_{}$", number + 1), format!("$P'_{}$", number + 1)];
        panel.label(*point, wish(point), &TextStyle::new(text_size::LABEL, INPUT), &names[0]);
        panel.label(*reflection, wish(reflection), &TextStyle::new(text_size::LABEL, REFLECTED), &names[1]);
    }
    panel.marker(center, &marker);
    panel.label(center, [0.5, 1.0], &TextStyle::new(16.0, color), name);
    let area = polygon.area_at(center);
    let note = format!("area {area:.2}, {:.2} times that of the polygon", area / polygon.area());
    scene.text(PagePoint::new(middle, 358.0), Anchor::Middle, &TextStyle::new(text_size::LABEL, color), &note);
}
