//! The options of the command `enclose`.

use super::super::asking::Asking;
use clap::Args;
use std::path::PathBuf;

/// Options of `enclose`.
#[derive(Debug, Args)]
pub struct Options {
    /// The points: a table, GeoJSON, JSON, an array of NumPy or a mesh, as the extension tells; `-` is standard input.
    pub(super) file: PathBuf,
    #[command(flatten)]
    pub(super) asking: Asking,
    /// Write a picture of the points and the zonotope.
    #[arg(long, value_name = "FILE")]
    pub(super) svg: Option<PathBuf>,
    /// Write a zonotope of space as a mesh, Wavefront OBJ.
    #[arg(long, value_name = "FILE")]
    pub(super) obj: Option<PathBuf>,
    /// Write the answer with its certificate, in the format of `solve`.
    #[arg(long, value_name = "FILE")]
    pub(super) json: Option<PathBuf>,
    /// Also give the optimum of least area in exact rational numbers.
    #[arg(long)]
    pub(super) exact: bool,
    /// Seed of the random numbers for the least area, 0 if absent: it decides the time, never the area.
    #[arg(long)]
    pub(super) seed: Option<u64>,
    /// Replace files that exist.
    #[arg(long)]
    pub(super) force: bool,
}
