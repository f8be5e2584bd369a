//! The proofs that answers about two bodies carry, in the plane.

use crate::figure::{Figure, FigureError, FigureInput};
use crate::scene::page::{Frame, PageBox, PagePoint, WorldBox};
use crate::scene::text::{Anchor, TextStyle};
use crate::scene::{LegendEntry, Panel, Sample, Scene};
use crate::style::{
    CENTER, Dash, ENCLOSING, GREY, INK, INPUT, Marker, OPTIMUM, Paint, REFLECTED, Shape, Stroke, text_size, weight,
};
use zonotope::collision::{Location, Query, Separation, Witness, by_lad};
use zonotope::zonotope::Zonotope;

/// The proofs of three answers.
pub const FIGURE: Figure = Figure {
    id: "certificates-of-intersection",
    title: "What proves an answer",
    caption: "Three pairs of zonogons with centres p and q. Where they meet, the proof is a coefficient in [−1, 1] for \
              each generator: steps from p by the multiples of the first body's generators and steps from q by those \
              of the second's end in the same point. Where they only touch, that point lies on both boundaries. Where \
              they are disjoint, the proof is a direction u in which the second body begins beyond the end of the \
              first.",
    claims: &["lemma-5.1", "theorem-5.2"],
    experiments: &[],
    deterministic: true,
    draw,
};

const FIRST: [[f64; 2]; 4] = [[4.0, 1.0], [2.0, 3.0], [-1.0, 3.0], [-3.0, 2.0]];
const SECOND: [[f64; 2]; 3] = [[5.0, -1.0], [3.0, 2.0], [-1.0, 3.0]];
/// The second body's centre, and what to say.
const PAIRS: [([f64; 2], &str); 3] =
    [([9.0, 6.0], "the interiors meet"), ([17.0, 3.0], "they touch"), ([19.0, 11.0], "they are disjoint")];
const CELL: [f64; 2] = [290.0, 280.0];
const FIRST_PAINT: Paint = Paint::fill(INPUT, 0.14).with_outline(Stroke::new(INPUT, weight::MEDIUM));
const SECOND_PAINT: Paint = Paint::fill(REFLECTED, 0.14).with_outline(Stroke::new(REFLECTED, weight::MEDIUM));
const COMMON: Marker = Marker::new(Shape::Star, 8.0, OPTIMUM);
const SEPARATING: Stroke = Stroke::new(ENCLOSING, weight::STRONG).dashed(Dash::Dashed);

fn draw(_: &FigureInput<'_>) -> Result<String, FigureError> {
    let mut scene = Scene::new(CELL[0] * 3.0, CELL[1] + 50.0, FIGURE.title, FIGURE.caption);
    for (column, (center, words)) in PAIRS.into_iter().enumerate() {
        let left = CELL[0] * column as f64;
        scene.heading(PagePoint::new(left + CELL[0] / 2.0, 24.0), words);
        draw_pair(&mut scene, PageBox::new(left + 14.0, 40.0, CELL[0] - 28.0, CELL[1] - 52.0), center);
    }
    let entries = [
        LegendEntry::new(Sample::Line(Stroke::new(INPUT, weight::STRONG)), "steps from $p$"),
        LegendEntry::new(Sample::Line(Stroke::new(REFLECTED, weight::STRONG)), "steps from $q$"),
        LegendEntry::new(Sample::Point(COMMON), "common point"),
        LegendEntry::new(Sample::Line(SEPARATING), "separating line, across $u$"),
    ];
    scene.legend(PagePoint::new(0.0, CELL[1] + 14.0), CELL[0] * 3.0, &entries);
    Ok(scene.finish())
}

fn draw_pair(scene: &mut Scene, window: PageBox, second_center: [f64; 2]) {
    let body = |center, generators: &[[f64; 2]]| {
        Zonotope::new(center, generators.to_vec()).expect("the coordinates are small integers")
    };
    let (first, second) = (body([0.0, 0.0], &FIRST), body(second_center, &SECOND));
    let corners = [first.vertices(), second.vertices()];
    let world = WorldBox::around(corners.iter().flatten()).grown(0.04);
    let mut panel = Panel::new(scene, Frame::fit(&world, window));
    panel.polygon(&corners[0], &FIRST_PAINT);
    panel.polygon(&corners[1], &SECOND_PAINT);
    match by_lad::locate(&Query::between(&first, &second), &mut ()) {
        Location::Inside(witness) | Location::Boundary(witness) => draw_witness(&mut panel, &first, &second, &witness),
        Location::Outside(Separation::Rounded(direction)) => draw_separation(&mut panel, &first, &second, direction),
        Location::Outside(Separation::Exact(_)) => {}
    }
    for (center, name) in [(first.center(), "$p$"), (second.center(), "$q$")] {
        panel.marker(center, &CENTER);
        panel.label(center, [0.0, -1.0], &TextStyle::new(text_size::LABEL, INK), name);
    }
}

fn draw_witness(panel: &mut Panel<'_>, first: &Zonotope<2>, second: &Zonotope<2>, witness: &Witness) {
    let (of_first, of_second) = witness.coefficients.split_at(first.generators().len());
    let steps = |start: [f64; 2], sign: f64, coefficients: &[f64], generators: &[[f64; 2]]| {
        let mut place = start;
        let mut chain = vec![start];
        for (coefficient, generator) in coefficients.iter().zip(generators) {
            place = [0, 1].map(|i| place[i] + sign * coefficient * generator[i]);
            chain.push(place);
        }
        chain
    };
    let from_p = steps(first.center(), 1.0, of_first, first.generators());
    let from_q = steps(second.center(), -1.0, of_second, second.generators());
    for (chain, color) in [(&from_p, INPUT), (&from_q, REFLECTED)] {
        for pair in chain.windows(2) {
            panel.arrow(pair[0], pair[1], &Stroke::new(color, weight::STRONG));
        }
    }
    panel.marker(from_p[from_p.len() - 1], &COMMON);
}

fn draw_separation(panel: &mut Panel<'_>, first: &Zonotope<2>, second: &Zonotope<2>, [x, y]: [f64; 2]) {
    let end = first.support([x, y]);
    let begin = second.support([-x, -y]);
    let [tip, start] = [end.point(), begin.point()];
    let middle = [0, 1].map(|i| (tip[i] + start[i]) / 2.0);
    let window = *panel.frame().page();
    panel.line(middle, [-y, x], &window, &SEPARATING);
    let length = (x * x + y * y).sqrt();
    let ahead = [middle[0] + 3.0 * x / length, middle[1] + 3.0 * y / length];
    panel.arrow(middle, ahead, &Stroke::new(ENCLOSING, weight::STRONG));
    panel.label(ahead, [x, y], &TextStyle::new(text_size::LABEL, ENCLOSING), "$u$");
    let style = TextStyle::new(text_size::NOTE, GREY);
    let place = PagePoint::new(window.center().x, window.max.y + 16.0);
    let text = format!("ends at {:.2}, begins at {:.2} along $u$", end.value() / length, -begin.value() / length);
    panel.scene().text(place, Anchor::Middle, &style, &text);
}
