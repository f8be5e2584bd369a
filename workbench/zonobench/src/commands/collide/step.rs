//! The motions of two bodies during a step of time, as files or options state them.

use std::path::{Path, PathBuf};
use std::str::FromStr;

use anyhow::bail;
use clap::Args;
use serde_json::{Value, json};

use crate::commands::asked::value_of;
use crate::commands::usage::{Usage, tell};
use crate::input::PoseDocument;
use batch::json::vector_to_json;

/// The motions of both bodies, of which one that has none rests.
#[derive(Debug, Clone, Default, PartialEq, Args)]
pub(super) struct Step {
    /// Move the first body as a file says: JSON with an axis and an angle, or with pieces.
    ///
    /// The file has `axis_point`, `axis`, `angle` in radians and `translation`, for a turn at constant rate, or a list
    /// `pieces`, each with `until`, two quaternions `from` and `to`, `axis_point` and `translation`.
    #[arg(long, value_name = "FILE", conflicts_with_all = ["axis", "axis_point", "angle", "translation"])]
    motion: Option<PathBuf>,
    /// Move the second body as a file says, as --motion does the first.
    #[arg(long, value_name = "FILE")]
    motion_b: Option<PathBuf>,
    /// Turn the first body at constant rate about an axis of this direction.
    #[arg(long, value_name = "X,Y,Z", allow_hyphen_values = true, requires = "angle")]
    axis: Option<Triple>,
    /// Lead the axis through this point: the origin if absent.
    #[arg(long, value_name = "X,Y,Z", allow_hyphen_values = true, requires = "axis")]
    axis_point: Option<Triple>,
    /// Turn by this angle in radians, of any number of turns.
    #[arg(long, value_name = "RADIANS", allow_hyphen_values = true, requires = "axis")]
    angle: Option<f64>,
    /// Move the first body along this vector while it turns, if it does.
    #[arg(long, value_name = "X,Y,Z", allow_hyphen_values = true)]
    translation: Option<Triple>,
    /// Tell the time of a contact as finely as this part of the step [default: 2^-30].
    #[arg(long, value_name = "PART")]
    pub(super) resolution: Option<f64>,
}

/// Three finite numbers.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Triple([f64; 3]);

impl FromStr for Triple {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let number = |cell: &str| cell.trim().parse().ok().filter(|number: &f64| number.is_finite());
        let numbers: Option<Vec<f64>> = text.split(',').map(number).collect();
        let numbers = numbers.and_then(|numbers| <[f64; 3]>::try_from(numbers).ok());
        numbers.map(Self).ok_or_else(|| "three finite numbers with commas between are expected".to_owned())
    }
}

impl Step {
    /// The files that are read.
    pub(super) fn inputs(&self) -> Vec<&Path> {
        [&self.motion, &self.motion_b].into_iter().flatten().map(PathBuf::as_path).collect()
    }

    /// Refuses a step in which nothing is said to move.
    pub(super) fn check(&self) -> Result<(), Usage> {
        let is_moving = !self.inputs().is_empty() || self.axis.is_some() || self.translation.is_some();
        if is_moving { Ok(()) } else { Err(Usage::not_applicable("--motion", "no motion of either body is given")) }
    }

    /// The motions as a question has them.
    pub(super) fn motion(&self) -> anyhow::Result<Value> {
        let mut motions = json!({});
        if let Some(file) = &self.motion {
            motions["a"] = read(file)?;
        } else if let Some(own) = self.own() {
            motions["a"] = own;
        }
        if let Some(file) = &self.motion_b {
            motions["b"] = read(file)?;
        }
        Ok(motions)
    }

    /// The motion of the first body that options state.
    fn own(&self) -> Option<Value> {
        let vector = |triple: Option<Triple>| vector_to_json(&triple.map_or([0.0; 3], |triple| triple.0));
        let translation = vector(self.translation);
        match self.axis.zip(self.angle) {
            Some((axis, angle)) => Some(json!({
                "axis_point": vector(self.axis_point), "axis": vector(Some(axis)), "angle": angle,
                "translation": translation,
            })),
            None => self.translation.map(|_| {
                let still = json!([1.0, 0.0, 0.0, 0.0]);
                let piece = json!({
                    "until": 1.0, "from": still, "to": still, "axis_point": [0.0, 0.0, 0.0], "translation": translation,
                });
                json!({"pieces": [piece]})
            }),
        }
    }
}

/// The motion of a file: an object as it stands in a question, alone or under `motion`.
fn read(file: &Path) -> anyhow::Result<Value> {
    let PoseDocument::Object(object) = PoseDocument::read(file, tell)? else {
        bail!("{}: a motion is an object of JSON with `axis` and `angle`, or with `pieces`", file.display());
    };
    Ok(value_of(object.field("motion").unwrap_or(&object)))
}
