//! Plots with a logarithmic vertical axis: measured points, curves, and a legend beside the plot.
//!
//! Drawn by `plotters`, whose SVG backend rounds to whole units: the plot is drawn ten times as large as it is shown.
//! Logarithms come from `libm`, so the bytes are the same on every machine.

mod axis;
mod legend;
mod sign;

pub use self::axis::Scale;
pub use self::sign::Look;

pub(crate) use self::axis::power;
pub(crate) use self::sign::SHAPE_COUNT;

use self::axis::Axis;
use self::sign::sign;
use crate::figure::FigureError;
use crate::scene::page::decimals;
use crate::style::{Color, GREY, INK, PALE, PAPER, text_size};
use plotters::chart::{ChartBuilder, ChartContext};
use plotters::coord::cartesian::Cartesian2d;
use plotters::element::PathElement;
use plotters::prelude::{DrawingBackend, IntoDrawingArea, SVGBackend};
use plotters::style::{FontFamily, FontStyle, IntoFont, RGBColor, ShapeStyle};
use std::fmt::Write as _;

/// A measured series with a curve.
#[derive(Clone, Debug, PartialEq)]
pub struct Curve {
    /// The quantity that was measured.
    pub name: String,
    /// Further lines for the legend: on what, the fitted model, its constants, its interval.
    pub notes: Vec<String>,
    /// Size and value; the value is positive, the size as well on a logarithmic axis.
    pub points: Vec<[f64; 2]>,
    /// The corners of the curve: samples of the fitted model, or the points where they are joined; none without either.
    pub fit: Vec<[f64; 2]>,
    /// The colour and the sign of the points.
    pub look: Look,
}

/// A plot.
#[derive(Clone, Debug, PartialEq)]
pub struct Plot {
    /// Its title, for readers who hear the picture as well.
    pub title: String,
    /// The content to see.
    pub description: String,
    /// The quantity of the horizontal axis.
    pub x_name: String,
    /// The layout of sizes.
    pub x_scale: Scale,
    /// The quantity of the vertical axis.
    pub y_name: String,
    /// The series, in the order of the legend.
    pub curves: Vec<Curve>,
    /// The way in which the legend names the series.
    pub naming: Naming,
}

/// The way in which a legend names the series of a plot.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Naming {
    /// Each series has its name, with its notes below.
    Apart,
    /// Series of one name that follow each other stand below it, a line each, which is made of their notes.
    Grouped,
}

/// Units of drawing per unit of page.
const FINENESS: i32 = 10;
const PLOT_WIDTH: f64 = 560.0;
const LEAST_HEIGHT: f64 = 430.0;

impl Plot {
    /// The plot as an SVG document.
    pub fn draw(&self) -> Result<String, FigureError> {
        let all = || self.curves.iter().flat_map(|curve| curve.points.iter().chain(&curve.fit));
        if let Some(curve) = self.curves.iter().find(|curve| curve.points.is_empty()) {
            return Err(FigureError::EmptySeries(curve.name.clone()));
        }
        let has_place = |scale, c: f64| c.is_finite() && (c > 0.0 || scale == Scale::Linear);
        if let Some(point) = all().find(|[x, y]| !(has_place(self.x_scale, *x) && has_place(Scale::Logarithmic, *y))) {
            return Err(FigureError::NoPlace(*point));
        }
        let x = Axis::around(self.x_scale, all().map(|point| point[0])).ok_or(FigureError::NoSeries)?;
        let y = Axis::around(Scale::Logarithmic, all().map(|point| point[1])).ok_or(FigureError::NoSeries)?;

        let legend = self.legend();
        let width = PLOT_WIDTH + legend.width;
        let height = LEAST_HEIGHT.max(legend.height);
        let size = (to_units(width).unsigned_abs(), to_units(height).unsigned_abs());
        let mut drawn = String::new();
        {
            let root = SVGBackend::with_string(&mut drawn, size).into_drawing_area();
            let (plot, beside) = root.split_horizontally(to_units(PLOT_WIDTH));
            let mut chart = ChartBuilder::on(&plot)
                .margin_top(to_units(14.0))
                .margin_right(to_units(16.0))
                .margin_left(to_units(8.0))
                .margin_bottom(to_units(4.0))
                .x_label_area_size(to_units(44.0))
                .y_label_area_size(to_units(70.0))
                .build_cartesian_2d(x, y)
                .map_err(FigureError::plot)?;
            self.draw_mesh(&mut chart)?;
            for is_singled_out in [false, true] {
                for curve in self.curves.iter().filter(|curve| curve.look.is_singled_out == is_singled_out) {
                    draw_curve(&mut chart, curve)?;
                }
            }
            legend.draw(&beside)?;
            root.present().map_err(FigureError::plot)?;
        }
        Ok(self.shown_at_natural_size(&drawn, [width, height]))
    }

    fn draw_mesh<DB: DrawingBackend>(
        &self,
        chart: &mut ChartContext<'_, DB, Cartesian2d<Axis, Axis>>,
    ) -> Result<(), FigureError> {
        chart
            .configure_mesh()
            .bold_line_style(line(PALE, 0.9))
            .light_line_style(line(PALE.mixed(PAPER, 150), 0.6))
            .axis_style(line(GREY, 1.2))
            .x_desc(self.x_name.as_str())
            .y_desc(self.y_name.as_str())
            .label_style(font(text_size::NOTE, GREY, FontStyle::Normal))
            .axis_desc_style(font(text_size::LABEL, INK, FontStyle::Normal))
            .set_all_tick_mark_size(to_units(4.0))
            .draw()
            .map_err(FigureError::plot)
    }

    /// Replaces the head of the drawn document by one that shows it at natural size with a title and a background.
    fn shown_at_natural_size(&self, drawn: &str, size: [f64; 2]) -> String {
        let body = drawn.split_once('>').map_or(drawn, |(_head, body)| body);
        let mut document = String::new();
        let escaped = |text: &str| text.replace('&', "&amp;").replace('<', "&lt;");
        let [width, height] = size.map(decimals);
        let [wide, high] = size.map(to_units);
        write!(
            document,
            "<svg height=\"{height}\" role=\"img\" viewBox=\"0 0 {wide} {high}\" width=\"{width}\" \
             xmlns=\"http://www.w3.org/2000/svg\">\n<title>{}</title>\n<desc>{}</desc>\n\
             <rect fill=\"#ffffff\" height=\"100%\" width=\"100%\"/>{body}",
            escaped(&self.title),
            escaped(&self.description),
        )
        .expect("writing to a string succeeds because memory is its only limit");
        document
    }
}

fn draw_curve<DB: DrawingBackend>(
    chart: &mut ChartContext<'_, DB, Cartesian2d<Axis, Axis>>,
    curve: &Curve,
) -> Result<(), FigureError> {
    if !curve.fit.is_empty() {
        let points: Vec<(f64, f64)> = curve.fit.iter().map(|&[x, y]| (x, y)).collect();
        chart
            .draw_series(std::iter::once(PathElement::new(points, line(curve.look.color, 1.6))))
            .map_err(FigureError::plot)?;
    }
    for layer in curve.look.layers() {
        let signs = curve.points.iter().map(|&[x, y]| sign((x, y), curve.look.shape, layer));
        chart.draw_series(signs).map_err(FigureError::plot)?;
    }
    Ok(())
}

fn to_units(length: f64) -> i32 {
    libm::round(length * f64::from(FINENESS)) as i32
}

fn units(place: [f64; 2]) -> (i32, i32) {
    (to_units(place[0]), to_units(place[1]))
}

fn rgb(color: Color) -> RGBColor {
    let [red, green, blue] = color.rgb;
    RGBColor(red, green, blue)
}

fn line(color: Color, width: f64) -> ShapeStyle {
    ShapeStyle::from(rgb(color)).stroke_width(to_units(width).unsigned_abs())
}

/// The backend divides sizes by 1.24 before it writes them.
fn font<'a>(size: f64, color: Color, style: FontStyle) -> plotters::style::TextStyle<'a> {
    (FontFamily::SansSerif, 1.24 * size * f64::from(FINENESS), style).into_font().color(&rgb(color))
}

#[cfg(test)]
mod tests;
