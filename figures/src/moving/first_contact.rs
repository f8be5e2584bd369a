//! Two bodies in motion at some times, and a bar of the time with the intervals that are proved to be free.

use zonotope::motion::Motion;
use zonotope::motion::continuous::{FirstContact, FreeStretch, SeparatingDirection};
use zonotope::zonotope::Zonotope;

use super::placed::{Placed, View};
use crate::own_data::OwnDataError;
use crate::scene::page::{Frame, PageBox, PagePoint, WorldBox, decimals};
use crate::scene::text::{Anchor, TextStyle};
use crate::scene::{LegendEntry, Panel, Sample, Scene};
use crate::solid::{cross, dot};
use crate::style::{
    Color, ENCLOSING, FOCUS, GREY, INK, INPUT, Marker, OPTIMUM, PALE, Paint, REFLECTED, Shape, Stroke, text_size,
    weight,
};

const WIDTH: f64 = 760.0;
const MARGIN: f64 = 24.0;
const TITLE: f64 = 54.0;
const PANEL: [f64; 2] = [350.0, 250.0];
const PANEL_HEADING: f64 = 24.0;
const BAR: f64 = 24.0;
/// The room around the bar for the marks above and the numbers below.
const BAR_ROOM: [f64; 2] = [30.0, 52.0];
const LEGEND: f64 = 56.0;

/// The bodies are drawn at the ends of so many equal parts of the time until they meet.
const PARTS: u8 = 3;

/// The length on the page of a direction that is seen from its side.
const ARROW: f64 = 52.0;

/// A direction shorter than that on the page points to the eye, or away from it.
const LEAST_ARROW: f64 = 9.0;

const BODY_COLORS: [Color; 2] = [INPUT, REFLECTED];
const CONTACT: Marker = Marker::new(Shape::Diamond, 6.0, INK);
const GRAZING: Marker = Marker::new(Shape::Diamond, 6.0, FOCUS);
const UNASKED: Paint = Paint::fill(PALE, 0.4);

/// The frames in which a direction may stand still: the name of each, and its colour on the bar.
const FRAMES: [(&str, Color); 4] = [
    ("direction fixed in space", ENCLOSING),
    ("turning with the first body", INPUT),
    ("turning with the second", REFLECTED),
    ("normal to two edges", OPTIMUM),
];

/// The first contact of two bodies: both at a few times with the direction that separates them, and the time with the
/// intervals in which such a direction is proved.
///
/// # Errors
/// If coordinates are too large or too small to be drawn.
pub fn first_contact(
    names: [&str; 2],
    bodies: [&Zonotope<3>; 2],
    motions: [&Motion; 2],
    found: &FirstContact,
) -> Result<String, OwnDataError> {
    let title = format!("{} and {} in motion", names[0], names[1]);
    let times = times(found);
    let view = View::around(bodies[0].center());
    let at = |time: f64| -> Result<[Placed; 2], OwnDataError> {
        Ok([view.placed(bodies[0], motions[0], time)?, view.placed(bodies[1], motions[1], time)?])
    };
    let placed = times.iter().map(|&time| at(time)).collect::<Result<Vec<_>, _>>()?;
    let corners = placed.iter().flatten().flat_map(|body| &body.outline);
    let world = WorldBox::around(corners).grown(0.06);

    let rows = times.len().div_ceil(2);
    let bottom = TITLE + rows as f64 * (PANEL_HEADING + PANEL[1]);
    let bar = PageBox::new(MARGIN, bottom + BAR_ROOM[0], WIDTH - 2.0 * MARGIN, BAR);
    let height = bar.max.y + BAR_ROOM[1] + LEGEND;
    let mut scene = Scene::new(WIDTH, height, &title, &described(found));
    scene.heading(PagePoint::new(WIDTH / 2.0, 22.0), &title);
    let note = TextStyle::new(text_size::NOTE, GREY);
    scene.text(PagePoint::new(WIDTH / 2.0, 43.0), Anchor::Middle, &note, &described(found));

    for (number, (&time, bodies)) in times.iter().zip(&placed).enumerate() {
        let [x, y] = [WIDTH / 2.0 * (number % 2) as f64, TITLE + (number / 2) as f64 * (PANEL_HEADING + PANEL[1])];
        let label = format!("time {}", short(time));
        scene.text(PagePoint::new(x + WIDTH / 4.0, y + 16.0), Anchor::Middle, &note, &label);
        let page = PageBox::new(x + (WIDTH / 2.0 - PANEL[0]) / 2.0, y + PANEL_HEADING, PANEL[0], PANEL[1]);
        let mut panel = Panel::new(&mut scene, Frame::fit(&world, page));
        draw_placed(&mut panel, &view, &placed[..number], bodies);
        if let Some(u) = interval_at(found.free(), time).map(|free| direction_at(&free.direction, bodies)) {
            draw_direction(&mut panel, &view, bodies, u);
        }
    }
    draw_bar(&mut scene, bar, found, &times);
    draw_legend(&mut scene, bar.max.y + BAR_ROOM[1], names, found);
    Ok(scene.finish())
}

/// The times at which the bodies are drawn: from 0 to the end, or to where they meet.
fn times(found: &FirstContact) -> Vec<f64> {
    let end = match found {
        FirstContact::Separate { .. } => 1.0,
        FirstContact::Contact { time, .. } | FirstContact::Grazing { time, .. } => time[1],
    };
    if end == 0.0 {
        return vec![0.0];
    }
    (0..=PARTS).map(|part| if part == PARTS { end } else { end * f64::from(part) / f64::from(PARTS) }).collect()
}

/// The interval that holds a time; of two that meet there the later one, and at the end the last one.
fn interval_at(free: &[FreeStretch], time: f64) -> Option<&FreeStretch> {
    free.iter().rev().find(|free| free.from <= time && time <= free.until)
}

/// The direction in space at the time of the placements.
fn direction_at(direction: &SeparatingDirection, bodies: &[Placed; 2]) -> [f64; 3] {
    let turned = |i: usize, v: [f64; 3]| bodies[i].matrix.map(|row| dot(row, v));
    match *direction {
        SeparatingDirection::Space(u) => u,
        SeparatingDirection::First(u) => turned(0, u),
        SeparatingDirection::Second(u) => turned(1, u),
        SeparatingDirection::Edges([e, f]) => cross(turned(0, e), turned(1, f)),
    }
}

/// Both bodies, the farther one first, on the outlines of where they were before.
fn draw_placed(panel: &mut Panel<'_>, view: &View, before: &[[Placed; 2]], bodies: &[Placed; 2]) {
    for (body, color) in before.iter().flat_map(|bodies| bodies.iter().zip(BODY_COLORS)) {
        body.draw_outline(panel, &Paint::outline(Stroke::new(color, weight::FINE).faded(0.4)));
    }
    let nearness = bodies.each_ref().map(|placed| view.camera.nearness(placed.body.center()));
    let order = if nearness[0] <= nearness[1] { [0, 1] } else { [1, 0] };
    for i in order {
        bodies[i].draw(panel, &view.camera, BODY_COLORS[i]);
    }
}

/// The direction as an arrow between the points of the bodies that are nearest along it.
fn draw_direction(panel: &mut Panel<'_>, view: &View, bodies: &[Placed; 2], u: [f64; 3]) {
    let largest = u.iter().fold(0.0f64, |largest, c| largest.max(c.abs()));
    if largest == 0.0 || !largest.is_finite() {
        return;
    }
    let u = u.map(|c| c / largest);
    let [from, to] = [bodies[0].farthest(u), bodies[1].farthest(u.map(|c| -c))];
    let middle = panel.place(view.camera.project([0, 1, 2].map(|k| (from[k] + to[k]) / 2.0)));
    let [x, y] = view.camera.project(u).map(|c| c / dot(u, u).sqrt() * ARROW / 2.0);
    let stroke = Stroke::new(INK, weight::MEDIUM);
    let scene = panel.scene();
    if 2.0 * x.hypot(y) < LEAST_ARROW {
        scene.marker(middle, &Marker::new(Shape::Ring, 4.0, INK));
    } else {
        scene.arrow(middle.moved(-x, y), middle.moved(x, -y), &stroke);
    }
}

/// The time from 0 to 1: free intervals in the colours of their directions, and what is at their end.
fn draw_bar(scene: &mut Scene, bar: PageBox, found: &FirstContact, times: &[f64]) {
    let x = |time: f64| bar.min.x + bar.width() * time;
    let area = |from: f64, to: f64| {
        let (from, to) = (x(from), x(to));
        [
            PagePoint::new(from, bar.min.y),
            PagePoint::new(to, bar.min.y),
            PagePoint::new(to, bar.max.y),
            PagePoint::new(from, bar.max.y),
        ]
    };
    let end = found.free().last().map_or(0.0, |free| free.until);
    scene.polygon(&area(end, 1.0), &UNASKED);
    for free in found.free() {
        let (_, color) = FRAMES[frame(&free.direction)];
        scene.polygon(&area(free.from, free.until), &Paint::fill(color, 0.45));
    }
    let rule = Stroke::new(INK, weight::FINE);
    for free in found.free().iter().filter(|free| free.from > 0.0) {
        scene.segment(PagePoint::new(x(free.from), bar.min.y), PagePoint::new(x(free.from), bar.max.y), &rule);
    }
    scene.polygon(&area(0.0, 1.0), &Paint::outline(rule));
    let middle = (bar.min.y + bar.max.y) / 2.0;
    match found {
        FirstContact::Separate { .. } => {}
        FirstContact::Contact { time, .. } => scene.marker(PagePoint::new(x(time[1]), middle), &CONTACT),
        FirstContact::Grazing { time, .. } => scene.marker(PagePoint::new(x(time[1]), middle), &GRAZING),
    }
    let style = TextStyle::new(text_size::NOTE, GREY);
    scene.text(PagePoint::new(bar.min.x, bar.min.y - 12.0), Anchor::Start, &style, "time of the step");
    let mut free_from = f64::NEG_INFINITY;
    for time in times.iter().copied().chain([1.0]) {
        // numbers that would run into each other are left out
        if x(time) < free_from {
            continue;
        }
        free_from = x(time) + 56.0;
        let foot = PagePoint::new(x(time), bar.max.y + 6.0);
        scene.segment(PagePoint::new(foot.x, bar.max.y), foot, &rule);
        let anchor = match time {
            0.0 => Anchor::Start,
            1.0 => Anchor::End,
            _ => Anchor::Middle,
        };
        scene.text(foot.moved(0.0, 14.0), anchor, &style, &short(time));
    }
}

fn draw_legend(scene: &mut Scene, top: f64, names: [&str; 2], found: &FirstContact) {
    let body = |color: Color| Sample::Area(Paint::fill(color, 0.3).with_outline(Stroke::new(color, weight::MEDIUM)));
    let mut entries =
        vec![LegendEntry::new(body(BODY_COLORS[0]), names[0]), LegendEntry::new(body(BODY_COLORS[1]), names[1])];
    if !found.free().is_empty() {
        entries.push(LegendEntry::new(Sample::Line(Stroke::new(INK, weight::MEDIUM)), "direction that separates"));
    }
    for (index, (name, color)) in FRAMES.into_iter().enumerate() {
        if found.free().iter().any(|free| frame(&free.direction) == index) {
            entries.push(LegendEntry::new(Sample::Area(Paint::fill(color, 0.45)), name));
        }
    }
    match found {
        FirstContact::Separate { .. } => {}
        FirstContact::Contact { .. } => entries.push(LegendEntry::new(Sample::Point(CONTACT), "contact")),
        FirstContact::Grazing { .. } => entries.push(LegendEntry::new(Sample::Point(GRAZING), "undecided")),
    }
    scene.legend(PagePoint::new(MARGIN, top), WIDTH - 2.0 * MARGIN, &entries);
}

/// The index of a direction's frame among all.
fn frame(direction: &SeparatingDirection) -> usize {
    match direction {
        SeparatingDirection::Space(_) => 0,
        SeparatingDirection::First(_) => 1,
        SeparatingDirection::Second(_) => 2,
        SeparatingDirection::Edges(_) => 3,
    }
}

fn described(found: &FirstContact) -> String {
    let intervals = match found.free().len() {
        0 => String::new(),
        1 => ": one direction proves it".to_owned(),
        count => format!(": {count} directions prove it, one after the other"),
    };
    match found {
        FirstContact::Separate { .. } => format!("Disjoint during the whole step{intervals}"),
        FirstContact::Contact { time: [_, 0.0], .. } => "The bodies meet at the start".to_owned(),
        FirstContact::Contact { time, .. } => {
            format!("The bodies meet at the time {}, and not before{intervals}", short(time[1]))
        }
        FirstContact::Grazing { time, .. } => {
            format!("Disjoint until the time {}, undecided after it{intervals}", short(time[0]))
        }
    }
}

/// A time with three decimals.
fn short(time: f64) -> String {
    decimals(time)
}
