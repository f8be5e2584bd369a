//! Legends: samples of the signs with their meaning, in rows.

use super::Scene;
use super::page::PagePoint;
use super::text::{Anchor, Line, TextStyle};
use crate::style::{INK, Marker, Paint, Stroke, text_size};

/// The part of a sign that a legend shows.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Sample {
    /// A short line.
    Line(Stroke),
    /// A small area.
    Area(Paint),
    /// A point.
    Point(Marker),
}

/// A sign and its meaning.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LegendEntry<'a> {
    /// The sign.
    pub sample: Sample,
    /// The thing that it stands for.
    pub meaning: &'a str,
}

impl<'a> LegendEntry<'a> {
    /// The entry with this sign and meaning.
    pub const fn new(sample: Sample, meaning: &'a str) -> Self {
        Self { sample, meaning }
    }
}

const SAMPLE_WIDTH: f64 = 24.0;
const SAMPLE_GAP: f64 = 7.0;
const ENTRY_GAP: f64 = 20.0;
/// Height of a row in text sizes.
const ROW: f64 = 1.68;

impl Scene {
    /// Writes a legend in rows no wider than `width`, each centred on it; the upper left corner is `place`.
    ///
    /// Returns the height used.
    pub fn legend(&mut self, place: PagePoint, width: f64, entries: &[LegendEntry<'_>]) -> f64 {
        self.legend_of_size(place, width, text_size::NOTE, entries)
    }

    /// As [`legend`](Self::legend), with text of another size.
    pub fn legend_of_size(&mut self, place: PagePoint, width: f64, size: f64, entries: &[LegendEntry<'_>]) -> f64 {
        let style = TextStyle::new(size, INK);
        let room = |entry: &LegendEntry<'_>| SAMPLE_WIDTH + SAMPLE_GAP + Line::parse(entry.meaning).width(&style);
        let mut rows: Vec<(f64, Vec<&LegendEntry<'_>>)> = Vec::new();
        for entry in entries {
            match rows.last_mut() {
                Some((used, row)) if *used + ENTRY_GAP + room(entry) <= width => {
                    *used += ENTRY_GAP + room(entry);
                    row.push(entry);
                }
                _ => rows.push((room(entry), vec![entry])),
            }
        }
        let row_height = ROW * size;
        let height = row_height * rows.len() as f64;
        for (number, (used, row)) in rows.into_iter().enumerate() {
            let mut x = place.x + (width - used) / 2.0;
            let y = place.y + row_height * (number as f64 + 0.5);
            for entry in row {
                self.sample_with_text(PagePoint::new(x, y), size, entry);
                x += room(entry) + ENTRY_GAP;
            }
        }
        height
    }

    /// Writes one entry with text of a size, the middle of its left edge at `left`.
    pub fn sample_with_text(&mut self, left: PagePoint, size: f64, entry: &LegendEntry<'_>) {
        self.sample(left, &entry.sample);
        let text = left.moved(SAMPLE_WIDTH + SAMPLE_GAP, 0.36 * size);
        self.text(text, Anchor::Start, &TextStyle::new(size, INK), entry.meaning);
    }

    fn sample(&mut self, left: PagePoint, sample: &Sample) {
        match sample {
            Sample::Line(stroke) => self.segment(left, left.moved(SAMPLE_WIDTH, 0.0), stroke),
            Sample::Area(paint) => {
                let corners = [
                    left.moved(2.0, -6.0),
                    left.moved(SAMPLE_WIDTH - 2.0, -6.0),
                    left.moved(SAMPLE_WIDTH - 2.0, 6.0),
                    left.moved(2.0, 6.0),
                ];
                self.polygon(&corners, paint);
            }
            Sample::Point(marker) => self.marker(left.moved(SAMPLE_WIDTH / 2.0, 0.0), marker),
        }
    }
}
