//! The legend beside a plot: a sign, a line where the series has one, and text; in columns where it is long.

use super::sign::sign;
use super::{Curve, LEAST_HEIGHT, Naming, Plot, font, line, units};
use crate::figure::FigureError;
use crate::scene::text::{Line, TextStyle};
use crate::style::{GREY, INK, text_size};
use plotters::coord::Shift;
use plotters::element::{PathElement, Text};
use plotters::prelude::{DrawingArea, DrawingBackend};
use plotters::style::FontStyle;
use plotters::style::text_anchor::{HPos, Pos, VPos};

const TOP: f64 = 20.0;
pub(super) const LINE: f64 = 17.0;
/// Between two entries.
const GAP: f64 = 10.0;
/// From the left edge of a column to its text.
const TEXT_LEFT: f64 = 32.0;
const NAME: TextStyle = TextStyle::new(text_size::NOTE, INK).bold();
const NOTE: TextStyle = TextStyle::new(text_size::NOTE, GREY);
const MEMBER: TextStyle = TextStyle::new(text_size::NOTE, INK);
/// Groups that reach below this begin another column.
const COLUMN_LIMIT: f64 = 1.5 * LEAST_HEIGHT;

/// A legend with its places.
pub(super) struct Legend<'a> {
    rows: Vec<Row<'a>>,
    pub(super) width: f64,
    pub(super) height: f64,
}

/// A line of text, with the sign of a series before the first one about it.
struct Row<'a> {
    text: String,
    style: TextStyle,
    of: Option<&'a Curve>,
    at: [f64; 2],
}

/// The lines of an entry, the first with the sign of its series.
type Entry<'a> = Vec<(String, TextStyle, Option<&'a Curve>)>;

impl Plot {
    /// The legend of the plot.
    pub(super) fn legend(&self) -> Legend<'_> {
        let entries = match self.naming {
            Naming::Apart => self.curves.iter().map(with_notes_below).collect(),
            Naming::Grouped => self.curves.chunk_by(|a, b| a.name == b.name).map(below_their_name).collect(),
        };
        Legend::of(entries, self.naming)
    }
}

fn with_notes_below(curve: &Curve) -> Entry<'_> {
    let notes = curve.notes.iter().map(|note| (note.clone(), NOTE, None));
    std::iter::once((curve.name.clone(), NAME, Some(curve))).chain(notes).collect()
}

fn below_their_name(curves: &[Curve]) -> Entry<'_> {
    let name = curves.first().map(|curve| (curve.name.clone(), NAME, None));
    name.into_iter().chain(curves.iter().map(|curve| (curve.notes.join(": "), MEMBER, Some(curve)))).collect()
}

impl<'a> Legend<'a> {
    fn of(entries: Vec<Entry<'a>>, naming: Naming) -> Self {
        let mut legend = Self { rows: Vec::new(), width: 0.0, height: 0.0 };
        let (mut left, mut top) = (0.0, TOP);
        for entry in entries {
            let height = LINE * entry.len() as f64 + GAP;
            if naming == Naming::Grouped && top > TOP && top + height > COLUMN_LIMIT {
                (left, top) = (legend.width, TOP);
            }
            for (number, (text, style, of)) in (0..).zip(entry) {
                legend.width = legend.width.max(left + Line::parse(&text).width(&style) + TEXT_LEFT + 12.0);
                legend.rows.push(Row { text, style, of, at: [left, top + LINE * f64::from(number)] });
            }
            top += height;
            legend.height = legend.height.max(top);
        }
        legend
    }

    /// Draws the legend in its area.
    pub(super) fn draw<DB: DrawingBackend>(&self, area: &DrawingArea<DB, Shift>) -> Result<(), FigureError> {
        for Row { text, style, of, at: [left, top] } in &self.rows {
            if let Some(curve) = of {
                if !curve.fit.is_empty() {
                    let ends = [*left, left + 24.0].map(|x| units([x, *top]));
                    let stroke = line(curve.look.color, 2.0);
                    area.draw(&PathElement::new(ends.to_vec(), stroke)).map_err(FigureError::plot)?;
                }
                for layer in curve.look.layers() {
                    let sign = sign(units([left + 12.0, *top]), curve.look.shape, layer);
                    area.draw(&sign).map_err(FigureError::plot)?;
                }
            }
            let weight = if style.bold { FontStyle::Bold } else { FontStyle::Normal };
            let font = font(style.size, style.color, weight).pos(Pos::new(HPos::Left, VPos::Center));
            area.draw(&Text::new(text.as_str(), units([left + TEXT_LEFT, *top]), font)).map_err(FigureError::plot)?;
        }
        Ok(())
    }
}
