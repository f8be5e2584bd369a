//! The options of the command `intersect`.

use super::super::asked::body_formats;
use super::super::placing::{Placing, PlacingOfSecond, TableStart};
use crate::input::Format;
use clap::Args;
use std::path::PathBuf;

/// Options of `intersect`.
#[derive(Debug, Args)]
pub struct Options {
    /// The first zonotope: JSON, or a table or an array of NumPy (csv, json, npy); `-` is standard input.
    ///
    /// JSON holds `center` and `generators`, or a list of generators, or an answer with a zonotope. Rows of tables and
    /// arrays are generators.
    pub(super) a: PathBuf,
    /// The second zonotope.
    pub(super) b: PathBuf,
    /// The format of both files, where their extensions do not tell it; --format-b is that of the second.
    #[arg(long, value_parser = body_formats())]
    pub(super) format: Option<Format>,
    #[command(flatten)]
    pub(super) start: TableStart,
    #[command(flatten)]
    pub(super) placing: Placing,
    #[command(flatten)]
    pub(super) placing_of_b: PlacingOfSecond,
    /// Write a picture of both bodies with the separating plane or the common point.
    #[arg(long, value_name = "FILE")]
    pub(super) svg: Option<PathBuf>,
    /// Write the answer with its certificate, in the format of `solve`.
    #[arg(long, value_name = "FILE")]
    pub(super) json: Option<PathBuf>,
    /// Write the question in the format of `solve`: `verify` checks the answer against it.
    #[arg(long, value_name = "FILE")]
    pub(super) question: Option<PathBuf>,
    /// Replace files that exist.
    #[arg(long)]
    pub(super) force: bool,
}
