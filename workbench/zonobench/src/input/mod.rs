//! Points of the plane from data files (CSV, GeoJSON and JSON), zonotopes of any dimension (CSV and JSON).
//!
//! A file is read into at most [`MAX_FILE_BYTES`] of memory and yields at most [`MAX_POINTS`] points; both limits are checked
//! before the memory is taken. Every complaint is one line that names the file and the place ([`InputError`]). A byte order
//! mark, Windows line endings and blank lines are skipped.

mod body;
mod bytes;
mod columns;
mod document;
mod error;
mod geojson;
mod table;

use std::fmt;
use std::path::{Path, PathBuf};

use clap::ValueEnum;

pub use body::{Body, BodySource};
pub use bytes::MAX_FILE_BYTES;
pub use columns::{Column, Columns};
pub use error::{InputError, Place, Problem};

/// The largest number of points that a file may hold.
pub const MAX_POINTS: usize = 10_000_000;

/// The file formats that hold points.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum Format {
    /// A table of comma-, semicolon- or tab-separated cells, with or without a header line.
    Csv,
    /// Any GeoJSON object; every position in it is a point (longitude, latitude), altitudes are left out.
    Geojson,
    /// A JSON list of rows `[x, y, …]` or `{"x": …, "y": …}`, or an object that holds such a list under `points`.
    Json,
}

impl Format {
    /// The format that a file's extension names.
    pub fn of_extension(file: &Path) -> Option<Self> {
        match file.extension()?.to_str()?.to_ascii_lowercase().as_str() {
            "csv" | "tsv" | "txt" => Some(Self::Csv),
            "geojson" => Some(Self::Geojson),
            "json" => Some(Self::Json),
            _ => None,
        }
    }
}

impl fmt::Display for Format {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Csv => "csv",
            Self::Geojson => "geojson",
            Self::Json => "json",
        })
    }
}

/// A data file, and how to find the points in it.
#[derive(Debug, Clone)]
pub struct PointSource {
    /// The file; `-` is standard input.
    pub file: PathBuf,
    /// Its format; told from the extension if absent.
    pub format: Option<Format>,
    /// The two columns that hold the coordinates; guessed if absent.
    pub columns: Option<Columns>,
}

impl PointSource {
    /// Reads the points, in the order of the file; at least one.
    pub fn read(&self) -> Result<Vec<[f64; 2]>, InputError> {
        let file = &self.file;
        let format = self
            .format
            .or_else(|| Format::of_extension(file))
            .ok_or_else(|| Problem::UnknownFormat.at(file, Place::File))?;
        let content = bytes::read_limited(file)?;
        let points = match format {
            Format::Csv => table::points(file, &content, self.columns.as_ref())?,
            Format::Geojson => geojson::points(file, &content)?,
            Format::Json => document::points(file, &content, self.columns.as_ref())?,
        };
        if points.is_empty() {
            return Err(Problem::Empty.at(file, Place::File));
        }
        Ok(points)
    }
}

/// Adds a point, or a generator, unless the limit is reached.
fn push_limited<T>(points: &mut Vec<T>, point: T) -> Result<(), Problem> {
    if points.len() >= MAX_POINTS {
        return Err(Problem::TooMany { what: "points", limit: MAX_POINTS });
    }
    points.push(point);
    Ok(())
}
