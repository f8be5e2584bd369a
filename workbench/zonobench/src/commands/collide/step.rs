//! The motions of two bodies during a step of time, as files or options state them.

use std::path::{Path, PathBuf};

use batch::json::to_json;
use clap::Args;
use serde_json::{Value, json};

use crate::commands::motion::{MotionOptions, read_motion};
use crate::commands::usage::Usage;

/// The motions of both bodies, of which one that has none rests.
#[derive(Debug, Clone, Default, PartialEq, Args)]
pub(in crate::commands) struct Step {
    #[command(flatten)]
    of_a: MotionOptions,
    /// Move the second body as a file says, as --motion does the first.
    #[arg(long, value_name = "FILE")]
    motion_b: Option<PathBuf>,
    /// Tell the time of a contact as finely as this part of the step [default: 2^-30].
    #[arg(long, value_name = "PART")]
    pub(in crate::commands) resolution: Option<f64>,
}

impl Step {
    /// The files that are read.
    pub(in crate::commands) fn inputs(&self) -> Vec<&Path> {
        [self.of_a.input(), self.motion_b.as_deref()].into_iter().flatten().collect()
    }

    /// The name of an option that is given, if there is one.
    pub(in crate::commands) fn given(&self) -> Option<&'static str> {
        let of_a = self.of_a.is_given().then_some("--motion");
        of_a.or(self.given_of_b()).or(self.resolution.map(|_| "--resolution"))
    }

    /// The name of the option that moves the second body, if it is given.
    pub(in crate::commands) fn given_of_b(&self) -> Option<&'static str> {
        self.motion_b.as_ref().map(|_| "--motion-b")
    }

    /// Refuses a step in which nothing is said to move.
    pub(in crate::commands) fn check(&self) -> Result<(), Usage> {
        let is_moving = self.of_a.is_given() || self.motion_b.is_some();
        if is_moving { Ok(()) } else { Err(Usage::not_applicable("--motion", "no motion of either body is given")) }
    }

    /// The motions as a question has them.
    pub(in crate::commands) fn motion(&self) -> anyhow::Result<Value> {
        let mut motions = json!({});
        if let Some(motion) = self.of_a.motion()? {
            motions["a"] = motion;
        }
        if let Some(file) = &self.motion_b {
            motions["b"] = read_motion(file)?;
        }
        Ok(motions)
    }

    /// Adds the motions, and the resolution if there is one, to a request and to the input of a question.
    pub(super) fn add(&self, motion: &Value, places: [&mut Value; 2]) {
        for place in places {
            place["motion"] = motion.clone();
            if let Some(resolution) = self.resolution {
                place["resolution"] = to_json(resolution);
            }
        }
    }
}
