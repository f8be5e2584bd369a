//! A picture of a body and of the body of few generators around it.

use figures::scene::page::WorldBox;
use figures::scene::{LegendEntry, Sample};
use figures::style::{INPUT, Paint, REFLECTED, Stroke, weight};
use zonotope::zonotope::Zonotope;

use crate::commands::page::{Page, thinned};
use crate::commands::view::{axes, shrinking};
use crate::input::Body;

/// The outlines of both: of bodies of the plane as they are, of others in projection.
pub(super) fn draw(name: &str, body: &Body, reduced: &[Vec<f64>]) -> String {
    let shrink = shrinking(reduced);
    let axes = axes(body.center.len());
    let outline = |generators: &[Vec<f64>]| -> Vec<[f64; 2]> {
        let place = |v: Vec<f64>| axes.each_ref().map(|axis| axis.iter().zip(&v).map(|(a, x)| a * x).sum::<f64>());
        let shadow = generators.iter().map(|generator| place(shrink.vector(generator))).collect();
        let shadow = Zonotope::new([0.0; 2], shadow).expect("small generators have finite coordinates");
        thinned(shadow.vertices()).collect()
    };
    let [inner, outer] = [outline(&body.generators), outline(reduced)];
    let title = format!("{name}: {} generators instead of {}", reduced.len(), body.generators.len());
    let seen = if body.center.len() < 3 { "as they are" } else { "in projection" };
    let description = format!("A zonotope of dimension {} and one around it, {seen}.", body.center.len());
    let mut page = Page::new(WorldBox::around(inner.iter().chain(&outer)).grown(0.02), 1, &title, &description);
    let mut panel = page.panel();
    let [own, around] =
        [INPUT, REFLECTED].map(|color| Paint::fill(color, 0.12).with_outline(Stroke::new(color, weight::STRONG)));
    panel.polygon(&outer, &around);
    panel.polygon(&inner, &own);
    page.finish(&[
        LegendEntry::new(Sample::Area(own), "the body"),
        LegendEntry::new(Sample::Area(around), "the body around it"),
    ])
}
