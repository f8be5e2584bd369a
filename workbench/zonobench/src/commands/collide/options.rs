//! Options of `collide`.

use std::path::PathBuf;

use clap::builder::{PossibleValuesParser, TypedValueParser};
use clap::{Args, ValueEnum};

use super::step::Step;
use crate::commands::placing::{Placing, PlacingOfSecond, TableStart};
use crate::input::Format;

/// The formats of zonotopes and of meshes, as the values of an option.
fn formats() -> impl TypedValueParser<Value = Format> {
    let names = ["csv", "json", "npy", "obj", "ply", "stl", "off"];
    PossibleValuesParser::new(names).try_map(|name| Format::from_str(&name, false))
}

/// Options of `collide`.
#[derive(Debug, Args)]
pub struct Options {
    /// The first body: a zonotope of space (csv, json, npy), or a mesh (obj, ply, stl, off); `-` is standard input.
    ///
    /// JSON holds `center` and `generators`, or a list of generators, or an answer with a zonotope. Rows of tables and
    /// arrays are generators. Faces of meshes that have more than three corners are cut into triangles.
    pub(super) a: PathBuf,
    /// The second body: a zonotope beside a zonotope, a mesh beside a mesh.
    pub(super) b: PathBuf,
    /// The format of both files, where their extensions do not tell it; --format-b is that of the second.
    #[arg(long, value_parser = formats())]
    pub(super) format: Option<Format>,
    #[command(flatten)]
    pub(super) start: TableStart,
    #[command(flatten)]
    pub(super) step: Step,
    #[command(flatten)]
    pub(super) placing: Placing,
    #[command(flatten)]
    pub(super) placing_of_b: PlacingOfSecond,
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
