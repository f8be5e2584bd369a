//! A figure.

use experiments::runner::Records;
use thiserror::Error;

/// A figure: its names, what it illustrates, and how it is drawn.
#[derive(Clone, Copy, Debug)]
pub struct Figure {
    /// The name of the figure in the catalog, in file names and in links.
    pub id: &'static str,
    /// The title of the figure.
    pub title: &'static str,
    /// The caption: what there is to see, in full sentences.
    pub caption: &'static str,
    /// Ids of the claims that the figure illustrates.
    pub claims: &'static [&'static str],
    /// Ids of the experiments whose records the figure shows.
    pub experiments: &'static [&'static str],
    /// Whether the drawing is the same on every run and machine: it shows no times. Only such figures are committed.
    pub deterministic: bool,
    /// The drawing, as an SVG document.
    pub draw: fn(&FigureInput<'_>) -> Result<String, FigureError>,
}

impl Figure {
    /// Draws the figure.
    pub fn draw(&self, input: &FigureInput<'_>) -> Result<String, FigureError> {
        (self.draw)(input)
    }
}

/// The data that a figure may draw from besides its own instance.
#[derive(Clone, Copy, Debug, Default)]
pub struct FigureInput<'a> {
    /// The records of the experiments that were run.
    pub records: Option<&'a Records>,
}

/// The reason why a figure could not be drawn.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum FigureError {
    /// The experiment has no records in the input.
    #[error("no records of the experiment {0}")]
    NoRecords(&'static str),
    /// The plot has no series.
    #[error("the plot has no series")]
    NoSeries,
    /// A series has no points.
    #[error("the series {0} has no points")]
    EmptySeries(String),
    /// A point has no place on the axes: a coordinate is not finite, or not positive on a logarithmic axis.
    #[error("the point ({}, {}) has no place on the axes", .0[0], .0[1])]
    NoPlace([f64; 2]),
    /// The plotting library failed.
    #[error("the plot could not be drawn: {0}")]
    Plot(String),
}

impl FigureError {
    pub(crate) fn plot(error: impl std::fmt::Display) -> Self {
        Self::Plot(error.to_string())
    }
}
