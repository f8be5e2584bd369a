//! Drawing: a point outside of a zonogon, and the line that separates the two, as a picture in SVG.

use figures::scene::page::{Frame, PageBox, PagePoint, WorldBox};
use figures::scene::text::TextStyle;
use figures::scene::{LegendEntry, Panel, Sample, Scene};
use figures::style::{ENCLOSING, FOCUS, INK, Marker, Paint, Shape, Stroke, text_size};
use zonotope::{Separation, Zonotope};

const HEXAGON: Paint = Paint::fill(ENCLOSING, 0.1).with_outline(Stroke::new(ENCLOSING, 2.0));
const BETWEEN: Stroke = Stroke::new(FOCUS, 1.5);

/// Draws, writes the picture to a folder and asserts what it shows.
pub fn main() {
    let svg = picture();
    assert!(svg.starts_with("<svg") && svg.contains("polygon"));
    let path = std::env::temp_dir().join("separated.svg");
    std::fs::write(&path, svg).expect("the folder for temporary files can be written to");
    println!("{}", path.display());
}

fn picture() -> String {
    let body = Zonotope::new([0.0, 0.0], vec![[2.0, 0.5], [0.5, 1.5], [-1.0, 1.0]]).expect("the generators are finite");
    let point = [3.0, 3.0];
    let located = body.locate(point).expect("the point is finite");
    let Some(Separation::Rounded(u)) = located.separation() else {
        panic!("the point lies outside, and a direction of doubles separates it from the body")
    };

    // the line through the middle of the gap, where u · x is midway between the body's reach and the point
    let (reach, along) = (body.support(*u).value(), u[0] * point[0] + u[1] * point[1]);
    assert!(along > reach);
    let factor = (along + reach) / 2.0 / (u[0] * u[0] + u[1] * u[1]);

    let mut scene = Scene::new(360.0, 360.0, "A point beside a zonogon", "A hexagon, a point, a line between the two.");
    let vertices = body.vertices();
    let world = WorldBox::around(vertices.iter().chain([&point])).grown(0.1);
    let window = PageBox::new(20.0, 10.0, 320.0, 310.0);
    let mut panel = Panel::new(&mut scene, Frame::fit(&world, window));
    panel.polygon(&vertices, &HEXAGON);
    panel.line(u.map(|c| c * factor), [-u[1], u[0]], &window, &BETWEEN);
    panel.marker(point, &Marker::new(Shape::Disc, 4.0, INK));
    panel.label(point, [1.0, 1.0], &TextStyle::new(text_size::NOTE, INK), "the point");
    let entries = [
        LegendEntry::new(Sample::Area(HEXAGON), "zonogon"),
        LegendEntry::new(Sample::Line(BETWEEN), "separating line"),
    ];
    scene.legend(PagePoint::new(0.0, 330.0), 360.0, &entries);
    scene.finish()
}
