//! `draw motion`: a body in the volume around its placements, or two bodies and the proof that they do not meet.

use std::path::Path;

use anyhow::{Context, anyhow, bail};
use batch::json::{MAX_VALUES, read};
use batch::read_motion;
use figures::moving;
use serde_json::{Value, json};
use zonotope::Zonotope;
use zonotope::motion::Motion;
use zonotope::motion::continuous::by_control_points::DEFAULT_RESOLUTION;
use zonotope::motion::continuous::first_contact_within;

use super::options::{Options, in_space};
use crate::commands::asked::BodyFile;
use crate::commands::placing::{in_words, rounded_in_words};
use crate::commands::usage::question_name;
use crate::input::{OptionNames, RoundedBody};

/// The picture, and what is to be said of the bodies' poses.
pub(super) fn picture(options: &Options, name: &str) -> anyhow::Result<(String, String)> {
    let (format, skip) = (options.reading.format, options.reading.told_skip());
    let of_a = options.placing.read(&options.file, format, skip, OptionNames::OF_FIRST)?;
    let (a, mut more) = body(&options.file, of_a)?;
    let motions = options.step.motion()?;
    let of_a = motion(&motions["a"], "the motion")?;
    let Some(file) = &options.other else {
        let volume = a.swept(&of_a).with_context(|| name.to_owned())?;
        return Ok((moving::swept(name, &a, &of_a, &volume).with_context(|| name.to_owned())?, more));
    };
    let placing = options.placing_of_b.placing();
    let of_second = (options.placing_of_b.format(format), options.placing_of_b.skip(skip));
    let read = placing.read(file, of_second.0, of_second.1, OptionNames::OF_SECOND)?;
    let (b, of_pose) = body(file, read)?;
    more.push_str(&of_pose);
    let of_b = motion(&motions["b"], "the motion of the second body")?;
    let (bodies, moves) = ([&a, &b], [&of_a, &of_b]);
    let resolution = options.step.resolution.unwrap_or(DEFAULT_RESOLUTION);
    let found = first_contact_within(bodies, moves, resolution);
    let names = [name, &question_name(file)];
    let drawn = moving::first_contact(names, bodies, moves, &found);
    Ok((drawn.with_context(|| format!("{} and {}", names[0], names[1]))?, more))
}

/// The body of a file where it is put, and what is to be said of its pose.
fn body(file: &Path, read: BodyFile) -> anyhow::Result<(Zonotope<3>, String)> {
    let RoundedBody { body, off } = read.placed.rounded(file)?;
    let mut more = read.placed.pose.as_ref().map(|pose| format!("pose: {}\n", in_words(pose))).unwrap_or_default();
    if off > 0.0 {
        more.push_str(&format!("{}\n", rounded_in_words(off)));
    }
    let Some((center, generators)) = in_space(&body) else {
        bail!("{}: has {} coordinates; motions are those of a zonotope with three", file.display(), body.center.len());
    };
    Ok((Zonotope::new(center, generators)?, more))
}

/// A motion as a question has it; a body without one rests.
fn motion(stated: &Value, name: &str) -> anyhow::Result<Motion> {
    if stated.is_null() {
        return Ok(Motion::rest());
    }
    let holder = read(json!({ "motion": stated }).to_string().as_bytes(), MAX_VALUES);
    let holder = holder.map_err(|error| anyhow!("{name}: {error}"))?;
    read_motion(&holder).map_err(|refusal| anyhow!("{name}: {}", refusal.message))
}
