//! The motion of a body during a step of time, as a file or options state it.

use std::f64::consts::TAU;
use std::path::{Path, PathBuf};
use std::str::FromStr;

use anyhow::bail;
use clap::Args;
use serde_json::{Value, json};

use super::asked::{SWEEP_FIELDS, float, floats, value_of};
use super::placing::radians_of;
use super::table::{figure, in_full, tuple};
use super::usage::tell;
use crate::input::PoseDocument;
use batch::json::vector_to_json;

/// The motion of a body, of two bodies the first one.
#[derive(Debug, Clone, Default, PartialEq, Args)]
pub(super) struct MotionOptions {
    /// Move the body, the first of two, as a file says: JSON with an axis and an angle, or with pieces.
    ///
    /// The file has `axis_point`, `axis`, `angle` in radians and `translation`, for a turn at constant rate, or a list
    /// `pieces`, each with `until`, two quaternions `from` and `to`, `axis_point` and `translation`.
    #[arg(long, value_name = "FILE", conflicts_with_all = ["axis", "axis_point", "angle", "degrees", "translation"])]
    motion: Option<PathBuf>,
    /// Turn the body, the first of two, about an axis of this direction.
    #[arg(long, value_name = "X,Y,Z", allow_hyphen_values = true, requires = "turned")]
    axis: Option<Triple>,
    /// Lead the axis through this point: the origin if absent.
    #[arg(long, value_name = "X,Y,Z", allow_hyphen_values = true, requires = "axis")]
    axis_point: Option<Triple>,
    /// Turn by this angle in radians, of any number of turns.
    #[arg(long, value_name = "RADIANS", allow_hyphen_values = true, requires = "axis", group = "turned",
        value_parser = finite)]
    angle: Option<f64>,
    /// Turn by this angle in degrees, which is taken in radians, rounded.
    #[arg(long, value_name = "DEGREES", allow_hyphen_values = true, requires = "axis", group = "turned",
        value_parser = finite)]
    degrees: Option<f64>,
    /// Move the body, the first of two, along this vector while it turns, if it does.
    #[arg(long, value_name = "X,Y,Z", allow_hyphen_values = true)]
    translation: Option<Triple>,
}

/// A finite number.
fn finite(text: &str) -> Result<f64, String> {
    let number = text.trim().parse().ok().filter(|number: &f64| number.is_finite());
    number.ok_or_else(|| "a finite number is expected".to_owned())
}

/// Three finite numbers.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Triple([f64; 3]);

impl FromStr for Triple {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let numbers: Option<Vec<f64>> = text.split(',').map(|cell| finite(cell).ok()).collect();
        let numbers = numbers.and_then(|numbers| <[f64; 3]>::try_from(numbers).ok());
        numbers.map(Self).ok_or_else(|| "three finite numbers with commas between are expected".to_owned())
    }
}

impl MotionOptions {
    /// The file that is read.
    pub(super) fn input(&self) -> Option<&Path> {
        self.motion.as_deref()
    }

    /// Whether a motion is given.
    pub(super) fn is_given(&self) -> bool {
        self.motion.is_some() || self.axis.is_some() || self.translation.is_some()
    }

    /// The motion as a question of two moving bodies has it.
    pub(super) fn motion(&self) -> anyhow::Result<Option<Value>> {
        if let Some(file) = &self.motion {
            return read_motion(file).map(Some);
        }
        Ok(self.turn().or_else(|| {
            self.translation.map(|translation| {
                let still = json!([1.0, 0.0, 0.0, 0.0]);
                let piece = json!({
                    "until": 1.0, "from": still, "to": still, "axis_point": [0.0, 0.0, 0.0],
                    "translation": vector_to_json(&translation.0),
                });
                json!({"pieces": [piece]})
            })
        }))
    }

    /// The motion as a sweep has it: a turn about one axis by an angle that is not negative, and a translation.
    pub(super) fn sweep(&self) -> anyhow::Result<Value> {
        let mut turn = match &self.motion {
            Some(file) => read_turn(file)?,
            None => self.turn().unwrap_or_else(|| {
                let translation = self.translation.map_or([0.0; 3], |translation| translation.0);
                json!({
                    "axis_point": [0.0, 0.0, 0.0], "axis": [0.0, 0.0, 1.0], "angle": 0.0,
                    "translation": vector_to_json(&translation),
                })
            }),
        };
        let angle = float(&turn["angle"]);
        if angle < 0.0 && turn["axis"].is_array() {
            // a turn by a negative angle is one about the opposite axis
            let opposite: Vec<f64> = floats(&turn["axis"]).iter().map(|x| -x).collect();
            turn["axis"] = vector_to_json(&opposite);
            turn["angle"] = json!(-angle);
        }
        Ok(turn)
    }

    /// The turn that options state.
    fn turn(&self) -> Option<Value> {
        let vector = |triple: Option<Triple>| vector_to_json(&triple.map_or([0.0; 3], |triple| triple.0));
        self.angle.and_then(of_several_turns).iter().for_each(|hint| tell(hint));
        let angle = self.angle.or(self.degrees.map(radians_of));
        self.axis.zip(angle).map(|(axis, angle)| {
            json!({
                "axis_point": vector(self.axis_point), "axis": vector(Some(axis)), "angle": angle,
                "translation": vector(self.translation),
            })
        })
    }
}

/// The motion of a file: an object as it stands in a question, alone or under `motion`.
pub(super) fn read_motion(file: &Path) -> anyhow::Result<Value> {
    let PoseDocument::Object(object) = PoseDocument::read(file, tell)? else {
        bail!(
            "{}: a motion is an object of JSON with `axis_point`, `axis`, `angle` and `translation`, or with `pieces`",
            file.display()
        );
    };
    let motion = value_of(object.field("motion").unwrap_or(&object));
    motion["angle"].as_f64().and_then(of_several_turns).iter().for_each(|hint| tell(hint));
    Ok(motion)
}

/// The hint for an angle of more than a full turn, which may be meant in degrees.
fn of_several_turns(angle: f64) -> Option<String> {
    (angle.abs() > TAU).then(|| {
        let (shown, turns, radians) = (in_full(angle), figure(angle.abs() / TAU), in_full(radians_of(angle)));
        format!("the angle {shown} is in radians, {turns} full turns; {shown} degrees are {radians} radians")
    })
}

/// The motion of a file that is a turn about one axis.
fn read_turn(file: &Path) -> anyhow::Result<Value> {
    let motion = read_motion(file)?;
    let Value::Object(fields) = &motion else {
        bail!("{}: a motion is an object of JSON with `axis_point`, `axis`, `angle` and `translation`", file.display());
    };
    if fields.contains_key("pieces") {
        bail!("{}: the motion has `pieces`, while `sweep` takes one axis and one angle", file.display());
    }
    if let Some(other) = fields.keys().find(|name| !SWEEP_FIELDS.contains(&name.as_str())) {
        bail!("{}: extra field `{other}` in the motion", file.display());
    }
    if let Some(absent) = SWEEP_FIELDS.into_iter().find(|name| !fields.contains_key(*name)) {
        bail!("{}: the motion has no field `{absent}`", file.display());
    }
    Ok(motion)
}

/// A turn in words.
pub(super) fn turn_in_words(turn: &Value) -> String {
    format!(
        "{} radians about the axis {} through {}, translation {}",
        figure(float(&turn["angle"])),
        tuple(&floats(&turn["axis"])),
        tuple(&floats(&turn["axis_point"])),
        tuple(&floats(&turn["translation"]))
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_angle_that_may_be_one_in_degrees_earns_a_hint() {
        let told = "the angle 90.0 is in radians, 14.3239 full turns; 90.0 degrees are 1.5707963267948966 radians";
        assert_eq!(of_several_turns(90.0).as_deref(), Some(told));
        assert!(of_several_turns(-7.0).is_some() && of_several_turns(6.25).is_none());
    }
}
