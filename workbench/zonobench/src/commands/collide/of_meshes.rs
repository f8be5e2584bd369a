//! Two meshes of triangles in motion.

use std::path::Path;

use anyhow::bail;
use batch::placement::Placement;
use serde_json::{Value, json};

use super::options::Options;
use crate::commands::asked::{About, Asked};
use crate::commands::mesh::Read;
use crate::commands::placing::Placing;
use crate::commands::usage::{Usage, question_name};
use crate::input::{Format, OptionNames};

/// Whether both files are meshes; a mesh beside a zonotope is refused.
pub(super) fn are_meshes(options: &Options) -> anyhow::Result<bool> {
    let formats = [options.format, options.placing_of_b.format(options.format)];
    let is_mesh = |file: &Path, format: Option<Format>| {
        format.or_else(|| Format::of_extension(file)).is_some_and(Format::is_mesh)
    };
    let [a, b] = [&options.a, &options.b].map(|file| file.display());
    match [is_mesh(&options.a, formats[0]), is_mesh(&options.b, formats[1])] {
        [true, true] => Ok(true),
        [false, false] => Ok(false),
        [true, false] => bail!("{a} is a mesh and {b} is none: both are zonotopes, or both are meshes"),
        [false, true] => bail!("{b} is a mesh and {a} is none: both are zonotopes, or both are meshes"),
    }
}

/// Meshes that were asked about.
pub(super) struct AskedMeshes {
    pub(super) asked: Asked,
    pub(super) request: Value,
    pub(super) motion: Value,
    pub(super) meshes: [Posed; 2],
}

/// A mesh with the pose that put its vertices where they are.
pub(super) struct Posed {
    pub(super) mesh: Read,
    pub(super) pose: Option<Placement>,
}

/// Reads both meshes and asks about them.
pub(super) fn asked(options: &Options) -> anyhow::Result<AskedMeshes> {
    let placing_of_b = options.placing_of_b.placing();
    if let Some(option) = options.placing.layout_given().or(placing_of_b.layout_given()) {
        return Err(Usage::not_applicable(option, "meshes have no generators").into());
    }
    if let Some(option) = options.start.given().or(options.placing_of_b.skip(None).map(|_| "--skip-b")) {
        return Err(Usage::not_applicable(option, "only tables have lines that are left out, or a header").into());
    }
    let read = |file: &Path, placing: &Placing, names: OptionNames| -> anyhow::Result<Posed> {
        let pose = placing.after(None, 3, file, names)?;
        Ok(Posed { mesh: Read::in_doubles(file, options.format, pose.as_ref())?, pose })
    };
    let a = read(&options.a, &options.placing, OptionNames::OF_FIRST)?;
    let b = read(&options.b, &placing_of_b, OptionNames::OF_SECOND)?;
    let motion = options.step.motion()?;
    let mut request = json!({"command": "collide", "a": record(&a), "b": record(&b)});
    let name = format!("{} and {}", question_name(&options.a), question_name(&options.b));
    let mut question = About::Collide.question(&name, &[&a, &b].map(|posed| posed.mesh.question.clone()), None, None);
    options.step.add(&motion, [&mut request, &mut question["input"]]);
    Ok(AskedMeshes { asked: Asked::of(question)?, request, motion, meshes: [a, b] })
}

/// The record of a request on a mesh: how the file is read and placed, and its SHA-256.
fn record(Posed { mesh, pose }: &Posed) -> Value {
    let mut record = json!({});
    if let Some(format) = mesh.format {
        record["format"] = format.to_string().into();
    }
    if let Some(pose) = pose {
        record["pose"] = pose.to_json();
    }
    record["sha256"] = mesh.sha256.clone().into();
    record
}
