//! Minimum-area enclosing zonogons of country outlines.

use crate::figure::{Figure, FigureError, FigureInput};
use crate::min_area::Polygon;
use crate::scene::page::{Frame, PageBox, PagePoint, WorldBox};
use crate::scene::text::{Anchor, TextStyle};
use crate::scene::{LegendEntry, Panel, Sample, Scene};
use crate::style::{Dash, ENCLOSING, GREY, INPUT, Marker, OPTIMAL_CENTER, Paint, REFLECTED, Stroke, text_size};
use experiments::data::{Outline, outlines};

/// The country outlines.
pub const FIGURE: Figure = Figure {
    id: "country-outlines",
    title: "Minimum-area enclosing zonogons of ten country outlines",
    caption: "Under each name: the area of the zonogon as a multiple of that of the convex hull (1 for a centrally \
              symmetric hull, 2 for a triangle). Computed in degrees of longitude and latitude; each map is drawn with \
              the longitudes shortened by the cosine of its middle latitude. The shortening changes neither the \
              optimum nor the ratio, for both are the same after every affine map.",
    claims: &["theorem-4.5"],
    experiments: &["area-ratio"],
    deterministic: true,
    draw,
};

const COLUMNS: usize = 5;
const CELL: [f64; 2] = [166.0, 222.0];
const MARGIN: f64 = 6.0;
const LAND: Paint = Paint::fill(INPUT, 0.3).with_outline(Stroke::new(INPUT, 0.5));
const HULL: Stroke = Stroke::new(REFLECTED, 1.1).dashed(Dash::Dashed);
const ZONOGON: Paint = Paint::fill(ENCLOSING, 0.08).with_outline(Stroke::new(ENCLOSING, 2.0));
const SMALL_CENTER: Marker = Marker { radius: 5.0, ..OPTIMAL_CENTER };

fn draw(_: &FigureInput<'_>) -> Result<String, FigureError> {
    let rows = outlines().len().div_ceil(COLUMNS);
    let width = 2.0 * MARGIN + CELL[0] * COLUMNS as f64;
    let legend_top = MARGIN + CELL[1] * rows as f64;
    let mut scene = Scene::new(width, legend_top + 30.0, FIGURE.title, FIGURE.caption);
    for (number, outline) in outlines().iter().enumerate() {
        let left = MARGIN + CELL[0] * (number % COLUMNS) as f64;
        let top = MARGIN + CELL[1] * (number / COLUMNS) as f64;
        draw_outline(&mut scene, outline, PageBox::new(left, top, CELL[0], CELL[1]));
    }
    let entries = [
        LegendEntry::new(Sample::Area(LAND), "outline"),
        LegendEntry::new(Sample::Line(HULL), "convex hull"),
        LegendEntry::new(Sample::Area(ZONOGON), "zonogon of least area"),
        LegendEntry::new(Sample::Point(SMALL_CENTER), "its centre"),
    ];
    scene.legend(PagePoint::new(MARGIN, legend_top), width - 2.0 * MARGIN, &entries);
    Ok(scene.finish())
}

fn draw_outline(scene: &mut Scene, outline: &Outline, cell: PageBox) {
    let polygon = Polygon::of_figure(&outline.points);
    let best = polygon.optimum();
    let corners = best.body.vertices();
    let world = WorldBox::around(corners.iter().chain(polygon.vertices()));
    let middle_latitude = (world.min[1] + world.max[1]) / 2.0;
    let shortening = libm::cos(middle_latitude.to_radians());
    let picture = PageBox::new(cell.min.x + 10.0, cell.min.y + 52.0, cell.width() - 20.0, cell.height() - 64.0);
    let mut panel = Panel::new(scene, Frame::fit_stretched(&world, picture, shortening));
    panel.polygon(&corners, &ZONOGON);
    panel.polygon(&outline.points, &LAND);
    panel.polygon(polygon.vertices(), &Paint::outline(HULL));
    panel.marker(best.body.center(), &SMALL_CENTER);

    let middle = cell.center().x;
    scene.heading(PagePoint::new(middle, cell.min.y + 18.0), &country_name(outline.name));
    let note = format!("{:.3} × hull", best.value / polygon.area());
    let style = TextStyle::new(text_size::NOTE, GREY);
    scene.text(PagePoint::new(middle, cell.min.y + 37.0), Anchor::Middle, &style, &note);
}

/// The words of a file's name, each with a capital.
fn country_name(name: &str) -> String {
    let words: Vec<String> = name
        .split('_')
        .map(|word| {
            let mut letters = word.chars();
            letters.next().map_or_else(String::new, |first| first.to_uppercase().chain(letters).collect())
        })
        .collect();
    words.join(" ")
}
