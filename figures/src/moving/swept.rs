//! The placements of one body in motion, and the volume around them.

use zonotope::motion::Motion;
use zonotope::zonotope::Zonotope;

use super::placed::View;
use crate::own_data::OwnDataError;
use crate::scene::page::{Frame, PageBox, PagePoint, WorldBox};
use crate::scene::text::{Anchor, TextStyle};
use crate::scene::{LegendEntry, Panel, Sample, Scene};
use crate::style::{ENCLOSING, GREY, INPUT, Paint, Stroke, text_size, weight};

const WIDTH: f64 = 700.0;
const WINDOW: PageBox = PageBox::new(40.0, 62.0, 620.0, 440.0);
const LEGEND: f64 = 62.0;

/// The body is drawn at the ends of so many equal parts of the time.
const PARTS: u8 = 8;

const BETWEEN: Paint = Paint::outline(Stroke::new(INPUT, weight::FINE).faded(0.75));

/// A body at some times of its motion, in a volume that holds it at every time.
///
/// # Errors
/// If coordinates are too large or too small to be drawn.
pub fn swept(name: &str, body: &Zonotope<3>, motion: &Motion, volume: &Zonotope<3>) -> Result<String, OwnDataError> {
    let title = format!("A volume around {name} in motion");
    let description = format!(
        "{} placements of a body with {} generators in a zonotope with {}",
        PARTS + 1,
        body.generators().len(),
        volume.generators().len()
    );
    let view = View::around(body.center());
    let times = (0..=PARTS).map(|part| f64::from(part) / f64::from(PARTS));
    let placed = times.map(|time| view.placed(body, motion, time)).collect::<Result<Vec<_>, _>>()?;
    let around = view.still(volume)?;
    let corners = placed.iter().chain([&around]).flat_map(|body| &body.outline);
    let world = WorldBox::around(corners).grown(0.02);
    let mut scene = Scene::new(WIDTH, WINDOW.max.y + LEGEND, &title, &description);
    scene.heading(PagePoint::new(WIDTH / 2.0, 22.0), &title);
    let note = TextStyle::new(text_size::NOTE, GREY);
    scene.text(PagePoint::new(WIDTH / 2.0, 43.0), Anchor::Middle, &note, &description);
    let mut panel = Panel::new(&mut scene, Frame::fit(&world, WINDOW));
    around.draw(&mut panel, &view.camera, ENCLOSING);
    if let [first, between @ .., last] = &placed[..] {
        for body in between {
            body.draw_outline(&mut panel, &BETWEEN);
        }
        first.draw(&mut panel, &view.camera, INPUT);
        last.draw(&mut panel, &view.camera, INPUT);
    }
    let area = |color| Sample::Area(Paint::fill(color, 0.3).with_outline(Stroke::new(color, weight::MEDIUM)));
    let entries = [
        LegendEntry::new(area(INPUT), "the body at the start and at the end"),
        LegendEntry::new(Sample::Area(BETWEEN), "between"),
        LegendEntry::new(area(ENCLOSING), "volume around every placement"),
    ];
    scene.legend(PagePoint::new(WINDOW.min.x, WINDOW.max.y + 20.0), WINDOW.width(), &entries);
    Ok(scene.finish())
}
