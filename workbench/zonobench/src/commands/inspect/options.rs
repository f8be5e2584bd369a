//! The options of the command `inspect`.

use super::super::asked::body_formats;
use super::super::mesh_files::MeshFiles;
use super::super::placing::{Placing, TableStart};
use crate::input::Format;
use clap::Args;
use std::path::PathBuf;

/// Options of `inspect`.
#[derive(Debug, Args)]
pub struct Options {
    /// The zonotope: JSON, or a table or an array of NumPy (csv, json, npy); `-` is standard input.
    ///
    /// JSON holds `center` and `generators`, or a list of generators, or an answer with a zonotope. Rows of tables and
    /// arrays are generators.
    pub(super) file: PathBuf,
    /// The format, where the extension does not tell it.
    #[arg(long, value_parser = body_formats())]
    pub(super) format: Option<Format>,
    #[command(flatten)]
    pub(super) start: TableStart,
    #[command(flatten)]
    pub(super) placing: Placing,
    /// Write a picture of the body.
    #[arg(long, value_name = "FILE")]
    pub(super) svg: Option<PathBuf>,
    /// Write the vertices of a planar body, counter-clockwise: a table (.csv) or a polygon (.geojson).
    ///
    /// On standard output it is a table. Vertices that round to one point of doubles are written once.
    #[arg(long, value_name = "FILE")]
    pub(super) vertices: Option<PathBuf>,
    #[command(flatten)]
    pub(super) meshes: MeshFiles,
    /// Write the counts of faces, in the format of `solve`.
    #[arg(long, value_name = "FILE")]
    pub(super) json: Option<PathBuf>,
    /// Write the question in the format of `solve`: `verify` checks the answer against it.
    #[arg(long, value_name = "FILE")]
    pub(super) question: Option<PathBuf>,
    /// Replace files that exist.
    #[arg(long)]
    pub(super) force: bool,
}
