//! Points from data files (CSV, GeoJSON, JSON, NPY) and meshes (OBJ, PLY, STL, OFF), zonotopes of any dimension (CSV,
//! JSON and NPY).
//!
//! A file is read into at most [`MAX_FILE_BYTES`] of memory and yields at most [`MAX_POINTS`] points; both limits are
//! checked before the memory is taken. Every complaint is one line that names the file and the place
//! ([`InputError`]). A byte order mark, Windows line endings and blank lines are skipped.

mod body;
mod bytes;
mod columns;
mod document;
mod error;
mod geojson;
mod mesh;
mod npy;
mod points;
mod reading;
mod table;

use std::fmt;
use std::path::{Path, PathBuf};

use clap::ValueEnum;

pub use body::{Body, BodySource, Origin, body_of_answer};
pub use bytes::MAX_FILE_BYTES;
pub use columns::{Column, Columns};
pub use error::{InputError, Place, Problem, on_one_line};
pub use points::{Points, Wanted};
pub use reading::Reading;

use self::mesh::Mesh;
use crate::digest::sha256;

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
    /// An array of NumPy with a row for each point: floats or whole numbers in two dimensions.
    Npy,
    /// A mesh, Wavefront OBJ: the vertices that faces, lines or points use.
    Obj,
    /// A mesh or a cloud of points, PLY in text or binary.
    Ply,
    /// A mesh of triangles, STL in text or binary.
    Stl,
    /// A mesh, OFF in text.
    Off,
}

impl Format {
    /// The format that a file's extension names.
    pub fn of_extension(file: &Path) -> Option<Self> {
        match file.extension()?.to_str()?.to_ascii_lowercase().as_str() {
            "csv" | "tsv" | "txt" => Some(Self::Csv),
            "geojson" => Some(Self::Geojson),
            "json" => Some(Self::Json),
            "npy" => Some(Self::Npy),
            "obj" => Some(Self::Obj),
            "ply" => Some(Self::Ply),
            "stl" => Some(Self::Stl),
            "off" => Some(Self::Off),
            _ => None,
        }
    }

    /// Whether files of this format have columns of which some are chosen.
    pub fn has_columns(self) -> bool {
        matches!(self, Self::Csv | Self::Json | Self::Npy)
    }

    /// Whether files of this format hold meshes: points of space.
    pub fn is_mesh(self) -> bool {
        matches!(self, Self::Obj | Self::Ply | Self::Stl | Self::Off)
    }
}

impl fmt::Display for Format {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Csv => "csv",
            Self::Geojson => "geojson",
            Self::Json => "json",
            Self::Npy => "npy",
            Self::Obj => "obj",
            Self::Ply => "ply",
            Self::Stl => "stl",
            Self::Off => "off",
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
    /// The columns that hold the coordinates; guessed if absent.
    pub columns: Option<Columns>,
    /// How many lines of a table are left out at its start; none, and a header is told from its cells, if absent.
    pub skip: Option<u64>,
}

impl PointSource {
    /// The format that was chosen, or that the name tells.
    pub fn known_format(&self) -> Option<Format> {
        self.format.or_else(|| Format::of_extension(&self.file))
    }

    /// Reads the points, in the order of the file; at least one.
    pub fn read(&self, wanted: Wanted) -> Result<Reading, InputError> {
        let file = &self.file;
        let format = self.known_format().ok_or_else(|| Problem::UnknownFormat.at(file, Place::File))?;
        let content = bytes::read_limited(file)?;
        let text = bytes::text(&content);
        let mut reading = match format {
            Format::Csv => table::points(file, text, self.columns.as_ref(), self.skip, wanted)?,
            Format::Geojson => geojson::points(file, text)?,
            Format::Json => document::points(file, text, self.columns.as_ref(), wanted)?,
            Format::Npy => npy::points(file, &content, self.columns.as_ref(), wanted)?,
            mesh => {
                let Mesh { vertices, faces } = mesh::read(file, text, mesh)?;
                let left_out = mesh::left_out(text, &vertices, mesh);
                Reading { faces, ..Reading::without_columns(Points::Space(vertices), left_out) }
            }
        };
        if reading.points.is_empty() {
            return Err(Problem::Empty.at(file, Place::File));
        }
        if wanted == Wanted::Planar {
            reading.check_dimension(file, 2)?;
        }
        reading.format = Some(format);
        reading.sha256 = sha256(&content);
        Ok(reading)
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
