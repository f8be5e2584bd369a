//! Points from data files (CSV, GeoJSON, JSON, NPY) and meshes (OBJ, PLY, STL, OFF), zonotopes of any dimension (CSV,
//! JSON and NPY).
//!
//! A file is read into at most [`MAX_FILE_BYTES`] of memory and yields at most [`MAX_POINTS`] points; both limits are
//! checked before the memory is taken. Every complaint is one line that names the file and the place
//! ([`InputError`]). Texts are UTF-8 or UTF-16 with a byte order mark, whatever ends their lines; blank lines are
//! skipped. What a reading leaves out, or takes in a way that is not plain, it tells ([`Reading::in_words`]).

mod body;
mod bytes;
mod columns;
mod document;
mod encoding;
mod error;
mod format;
mod frame;
mod geojson;
mod mesh;
mod names;
mod npy;
mod number;
mod parsed;
mod points;
mod reading;
mod signature;
mod table;

pub use self::points::{COORDINATE_LIMIT, MAX_POINTS};
use std::path::{Path, PathBuf};

pub use body::{
    Body, BodySource, ExactBody, Layout, OptionNames, Origin, Placed, PoseDocument, RoundedBody, body_of_answer,
};
pub use bytes::MAX_FILE_BYTES;
pub use columns::{Column, Columns};
pub use error::{InputError, Place, Problem, on_one_line};
pub use format::Format;
pub use points::{Points, Wanted};
pub use reading::Reading;

use self::number::in_json;
use self::reading::Skipping;
use crate::digest::sha256;

/// A data file, and how to find the points in it.
#[derive(Debug, Clone)]
pub struct PointSource {
    /// The file; `-` is standard input.
    pub file: PathBuf,
    /// Its format; told from the extension if absent.
    pub format: Option<Format>,
    /// The columns that hold the coordinates; guessed if absent.
    pub columns: Option<Columns>,
    /// The number of lines of a table that are left out at its start; none, and a header is told from its cells, if
    /// absent.
    pub skip: Option<u64>,
    /// Whether points with a missing or non-finite coordinate are left out; absent where there is no such choice.
    pub skip_nan: Option<bool>,
}

impl PointSource {
    /// A file of which the name alone tells how it is read.
    pub fn of_file(file: PathBuf) -> Self {
        Self { file, format: None, columns: None, skip: None, skip_nan: None }
    }

    /// The format that was chosen, or that the name tells.
    pub fn known_format(&self) -> Option<Format> {
        self.format.or_else(|| Format::of_extension(&self.file))
    }

    /// Reads the points, in the order of the file; at least one.
    pub fn read(&self, wanted: Wanted) -> Result<Reading, InputError> {
        let file = &self.file;
        let format = Format::of_file(file, self.format)?;
        let content = bytes::read_limited(file)?;
        signature::check(format, &content, "--format").map_err(|problem| problem.at(file, Place::File))?;
        let mut skipping = Skipping::new(self.skip_nan == Some(true));
        let columns = self.columns.as_ref();
        let mut reading = match format {
            Format::Csv | Format::Xyz => {
                let (has_options, is_cloud) = (self.skip_nan.is_some(), format == Format::Xyz);
                let shape = table::Shape { columns, skip: self.skip, wanted, has_options, is_cloud };
                table::points(file, &content, &shape, &mut skipping)
            }
            Format::Geojson => geojson::points(file, &content, columns, &mut skipping),
            Format::Json => document::points(file, &content, columns, wanted, &mut skipping),
            Format::Npy => npy::points(file, &content, columns, wanted, &mut skipping),
            mesh => mesh::points(file, &content, mesh, &mut skipping),
        }
        .map_err(|error| self.with_advice(error))?;
        reading.left_out.extend(skipping.in_words());
        reading.skipped = skipping.into_places();
        if matches!(format, Format::Json | Format::Geojson) {
            reading.losses = json_losses(&content, 1);
        }
        if reading.points.is_empty() {
            return Err(Problem::Empty.at(file, Place::File));
        }
        if wanted == Wanted::Planar {
            reading.check_dimension(file, 2)?;
        }
        reading.format.get_or_insert(format);
        reading.sha256 = sha256(&content);
        Ok(reading)
    }

    /// The SHA-256 of a file; none of one that cannot be read, or can be read only once.
    pub fn file_sha256(file: &Path) -> Option<String> {
        let is_file = file != Path::new("-");
        is_file.then(|| bytes::read_limited(file).ok()).flatten().map(|content| sha256(&content))
    }

    /// A complaint about a missing number names the option that leaves such points out, if there is one.
    fn with_advice(&self, error: InputError) -> InputError {
        let is_offered = self.skip_nan == Some(false) && error.problem.is_missing();
        let problem = if is_offered { Problem::Missing(Box::new(error.problem)) } else { error.problem };
        InputError { problem, ..error }
    }
}

/// The numbers of a JSON document that doubles do not hold as it spells them, in words; the document begins on this
/// line of its file.
pub fn json_losses(text: &[u8], line: u64) -> Option<String> {
    in_json::losses(text, line).in_words()
}
