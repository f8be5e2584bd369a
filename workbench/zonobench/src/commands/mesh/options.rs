//! The options of the command `mesh`.

use std::path::PathBuf;

use clap::Args;
use clap::builder::PossibleValuesParser;
use zonotope::bvh::Method;

use crate::commands::placing::{Shift, Turn};
use crate::input::Format;

/// Options of `mesh`.
#[derive(Debug, Args)]
pub struct Options {
    /// The first mesh: OBJ, PLY, STL or OFF; `-` is standard input.
    ///
    /// Faces of more than three corners are cut into triangles.
    pub(super) a: PathBuf,
    /// The second mesh; none with `--level`.
    #[arg(required_unless_present = "level", conflicts_with = "level")]
    pub(super) b: Option<PathBuf>,
    /// The format of both files, where their extensions do not tell it.
    #[arg(long)]
    pub(super) format: Option<Format>,
    /// Turn the first mesh about an axis through the origin: z,30 or 1,1,0,30.
    #[arg(long, value_name = "AXIS,DEGREES", allow_hyphen_values = true)]
    pub(super) turn: Option<Turn>,
    /// Move the first mesh, after any turn.
    #[arg(long = "move", value_name = "X,Y,Z", allow_hyphen_values = true)]
    pub(super) shift: Option<Shift>,
    /// Turn the second mesh.
    #[arg(long, conflicts_with = "level", value_name = "AXIS,DEGREES", allow_hyphen_values = true)]
    pub(super) turn_b: Option<Turn>,
    /// Move the second mesh, after any turn.
    #[arg(long = "move-b", conflicts_with = "level", value_name = "X,Y,Z", allow_hyphen_values = true)]
    pub(super) shift_b: Option<Shift>,
    /// List all pairs of triangles that meet.
    #[arg(long, conflicts_with = "level")]
    pub(super) pairs: bool,
    /// The bounding volume of the hierarchies.
    ///
    /// Whether meshes meet does not depend on it.
    #[arg(long, value_name = "NAME", value_parser = PossibleValuesParser::new(Method::ALL.map(Method::id)))]
    pub(super) volume: Option<String>,
    /// Find the volumes of a level of the first mesh's hierarchy instead; 0 is one volume around all of it.
    #[arg(long, value_name = "LEVEL")]
    pub(super) level: Option<u64>,
    /// Write the volumes of the level as one file of meshes, Wavefront OBJ.
    #[arg(long, value_name = "FILE")]
    pub(super) obj: Option<PathBuf>,
    /// Write the answer, in the format of `solve`.
    #[arg(long, value_name = "FILE")]
    pub(super) json: Option<PathBuf>,
    /// Write the question in the format of `solve`: `verify` checks the answer against it.
    #[arg(long, value_name = "FILE")]
    pub(super) question: Option<PathBuf>,
    /// Replace files that exist.
    #[arg(long)]
    pub(super) force: bool,
}
