//! Options of `sweep`.

use std::path::PathBuf;

use clap::Args;
use clap::builder::PossibleValuesParser;
use zonotope::motion::space_time::Method;

use crate::commands::asked::body_formats;
use crate::commands::mesh_files::MeshFiles;
use crate::commands::motion::MotionOptions;
use crate::commands::placing::{Placing, TableStart};
use crate::input::Format;

/// Options of `sweep`.
#[derive(Debug, Args)]
pub struct Options {
    /// The zonotope of space: JSON, or a table or an array of NumPy (csv, json, npy); `-` is standard input.
    ///
    /// JSON holds `center` and `generators`, or a list of generators, or an answer with a zonotope. Rows of tables and
    /// arrays are generators.
    pub(super) file: PathBuf,
    #[command(flatten)]
    pub(super) motion: MotionOptions,
    /// The method that finds the zonotope.
    #[arg(long, default_value = Method::default().id(), value_parser = methods())]
    pub(super) method: String,
    /// The format, where the extension does not tell it.
    #[arg(long, value_parser = body_formats())]
    pub(super) format: Option<Format>,
    #[command(flatten)]
    pub(super) start: TableStart,
    #[command(flatten)]
    pub(super) placing: Placing,
    #[command(flatten)]
    pub(super) meshes: MeshFiles,
    /// Write the answer, in the format of `solve`: other commands read the body from it.
    #[arg(long, value_name = "FILE")]
    pub(super) json: Option<PathBuf>,
    /// Write the question in the format of `solve`: `verify` checks the answer against it.
    #[arg(long, value_name = "FILE")]
    pub(super) question: Option<PathBuf>,
    /// Replace files that exist.
    #[arg(long)]
    pub(super) force: bool,
}

fn methods() -> PossibleValuesParser {
    PossibleValuesParser::new(Method::ALL.map(Method::id))
}
