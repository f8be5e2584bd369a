use super::*;
use crate::style::{CENTER, INPUT};
use svg::parser::Event;

fn drawn() -> String {
    let mut scene = Scene::new(200.0, 100.0, "a < b", "a \"description\"");
    scene.polygon(
        &[PagePoint::new(10.0, 10.0), PagePoint::new(90.0, 10.0), PagePoint::new(50.0, 90.0)],
        &Paint::fill(INPUT, 0.5).with_outline(Stroke::new(INPUT, 1.0)),
    );
    scene.arrow(PagePoint::new(0.0, 0.0), PagePoint::new(50.0, 50.0), &Stroke::new(INK, 1.0));
    scene.marker(PagePoint::new(50.0, 50.0), &CENTER);
    scene.label(PagePoint::new(50.0, 50.0), [0.0, 0.0], &TextStyle::new(14.0, INK), "$O$ & $P'_1$");
    let entries = [LegendEntry::new(Sample::Point(CENTER), "centre"); 3];
    let height = scene.legend(PagePoint::new(0.0, 60.0), 200.0, &entries);
    assert_eq!(height, 2.0 * 1.68 * 12.5, "two entries in the first row, one in the second");
    scene.finish()
}

#[test]
fn the_document_is_well_formed() {
    let drawn = drawn();
    let mut open = Vec::new();
    for event in svg::read(&drawn).expect("an SVG document") {
        match event {
            Event::Error(error) => panic!("{error}"),
            Event::Tag(name, svg::node::element::tag::Type::Start, _) => open.push(name.to_owned()),
            Event::Tag(name, svg::node::element::tag::Type::End, _) => assert_eq!(open.pop().as_deref(), Some(name)),
            _ => {}
        }
    }
    assert!(open.is_empty(), "{open:?}");
    assert!(drawn.contains("a &lt; b") && drawn.contains("&amp; "));
}

#[test]
fn an_arrow_ends_at_its_target() {
    let drawn = drawn();
    assert!(drawn.contains("<polygon fill=\"#1f242b\" points=\"50,50 "), "{drawn}");
}

#[test]
fn two_drawings_have_the_same_bytes() {
    assert_eq!(drawn(), drawn());
}
