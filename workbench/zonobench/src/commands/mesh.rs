//! `zonobench mesh`: whether two meshes of triangles meet, in which pairs, or how far apart they are.

use std::path::{Path, PathBuf};

use anyhow::{anyhow, bail};
use clap::Args;
use clap::builder::PossibleValuesParser;
use serde_json::{Value, json};
use zonotope::bvh::Method;

use super::Ending;
use super::asked::{Asked, float};
use super::placing::{Shift, Turn, put};
use super::table::{Table, at_least, at_most, counted};
use super::usage::{check_inputs, check_names, question_name};
use crate::input::{Format, OptionNames, PointSource, Points, Wanted};
use crate::output::{Existing, Outputs, Results};
use batch::Verdict;
use batch::json::vector_to_json;
use batch::placement::Placement;

/// Options of `mesh`.
#[derive(Debug, Args)]
pub struct Options {
    /// The first mesh: OBJ, PLY, STL or OFF; `-` is standard input. Faces of more than three corners are cut into
    /// triangles.
    a: PathBuf,
    /// The second mesh.
    b: PathBuf,
    /// The format of both files, where their extensions do not tell it.
    #[arg(long)]
    format: Option<Format>,
    /// Turn the first mesh about an axis through the origin: z,30 or 1,1,0,30.
    #[arg(long, value_name = "AXIS,DEGREES", allow_hyphen_values = true)]
    turn: Option<Turn>,
    /// Move the first mesh, after any turn.
    #[arg(long = "move", value_name = "X,Y,Z", allow_hyphen_values = true)]
    shift: Option<Shift>,
    /// Turn the second mesh.
    #[arg(long, value_name = "AXIS,DEGREES", allow_hyphen_values = true)]
    turn_b: Option<Turn>,
    /// Move the second mesh, after any turn.
    #[arg(long = "move-b", value_name = "X,Y,Z", allow_hyphen_values = true)]
    shift_b: Option<Shift>,
    /// List all pairs of triangles that meet.
    #[arg(long)]
    pairs: bool,
    /// The bounding volume of the hierarchies. The answer does not depend on it.
    #[arg(long, value_name = "NAME", value_parser = PossibleValuesParser::new(Method::ALL.map(Method::id)))]
    volume: Option<String>,
    /// Write the answer, in the format of `solve`.
    #[arg(long, value_name = "FILE")]
    json: Option<PathBuf>,
    /// Write the question in the format of `solve`: `verify` checks the answer against it.
    #[arg(long, value_name = "FILE")]
    question: Option<PathBuf>,
    /// Replace files that exist.
    #[arg(long)]
    force: bool,
}

/// A mesh that was read.
struct Read {
    question: Value,
    vertices: usize,
    triangles: usize,
}

/// Reads, solves, checks, and prints what was found.
pub fn run(options: &Options) -> anyhow::Result<Ending> {
    let inputs = [options.a.as_path(), options.b.as_path()];
    check_inputs(&inputs)?;
    check_names(&[("JSON", options.json.as_ref()), ("JSON", options.question.as_ref())])?;
    let outputs = options.json.iter().chain(&options.question);
    let outputs = Outputs::checked(outputs, &inputs, Existing::from_force(options.force))?;
    let of_a = put(3, options.turn.as_ref(), options.shift.as_ref(), OptionNames::OF_FIRST)?;
    let of_b = put(3, options.turn_b.as_ref(), options.shift_b.as_ref(), OptionNames::OF_SECOND)?;
    let [a, b] = [read(&options.a, options.format, of_a)?, read(&options.b, options.format, of_b)?];
    let mut input = json!({"a": a.question, "b": b.question});
    if options.pairs {
        input["pairs"] = true.into();
    }
    let name = format!("{} and {}", question_name(&options.a), question_name(&options.b));
    let mut question = json!({"id": name, "kind": "mesh", "input": input});
    if let Some(volume) = &options.volume {
        question["method"] = volume.as_str().into();
    }
    let asked = Asked::of(question)?;
    let verdict = asked.verdict();
    let [question, answer] = [&asked.question, &asked.answer].map(|content| format!("{content}\n").into_bytes());
    let mut results = Results::default();
    results.add(options.question.as_ref(), || Ok(question));
    results.add(options.json.as_ref(), || Ok(answer));
    outputs.finish(results, &summary(options, [&a, &b], &asked, &verdict))?;
    Ok(if matches!(verdict, Verdict::Wrong(_)) { Ending::Bad } else { Ending::Good })
}

fn read(file: &Path, format: Option<Format>, pose: Option<Placement>) -> anyhow::Result<Read> {
    let source = PointSource { format, ..PointSource::of_file(file.to_path_buf()) };
    let reading = source.read(Wanted::Any)?;
    let Points::Space(vertices) = &reading.points else {
        bail!("{}: holds no mesh of space", file.display());
    };
    // the corners of a face in the order in which it lists them, from the first one
    let fan = |face: &[usize]| (2..face.len()).map(|k| [face[0], face[k - 1], face[k]]).collect::<Vec<_>>();
    let triangles: Vec<[usize; 3]> = reading.faces.iter().flat_map(|face| fan(face)).collect();
    if triangles.is_empty() {
        return Err(anyhow!("{}: holds no faces, only points", file.display()));
    }
    let vertices: Vec<Value> = vertices.iter().map(|vertex| vector_to_json(vertex)).collect();
    let mut question = json!({"vertices": vertices, "triangles": triangles});
    if let Some(pose) = pose {
        question["pose"] = pose.to_json();
    }
    Ok(Read { question, vertices: vertices.len(), triangles: triangles.len() })
}

fn summary(options: &Options, meshes: [&Read; 2], asked: &Asked, verdict: &Verdict) -> String {
    let result = asked.result();
    let mut table = Table::default();
    for ((label, file), mesh) in ["a", "b"].into_iter().zip([&options.a, &options.b]).zip(meshes) {
        let triangles = counted(mesh.triangles, "triangle", "triangles");
        let vertices = counted(mesh.vertices, "vertex", "vertices");
        table.row(label, format!("{triangles}, {vertices} in {}", file.display()));
    }
    if result["intersects"] == true {
        let at = |index: usize| result["witness"][index].as_u64().map_or_else(String::new, |at| (at + 1).to_string());
        table.row("meshes", format!("meet: triangle {} of a and triangle {} of b have a common point", at(0), at(1)));
    } else {
        table.row("meshes", "are disjoint".to_owned());
    }
    if let Some(pairs) = result["pairs"].as_array() {
        table.row("pairs", format!("{} of triangles meet", counted(pairs.len(), "pair", "pairs")));
    }
    if let Some(distance) = result.get("distance") {
        let [lower, upper] = ["lower", "upper"].map(|bound| float(&distance[bound]));
        table.row("distance", format!("between {} and {}", at_least(lower), at_most(upper)));
    }
    table.row(
        "check",
        match verdict {
            Verdict::Right(proved) => format!("checked: {proved}"),
            Verdict::Unchecked(reason) => format!("not all was checked: {reason}"),
            Verdict::Wrong(reason) => format!("WRONG: {reason}"),
        },
    );
    table.row("volume", asked.answer["method"].as_str().unwrap_or_default().to_owned());
    let verify = match (&options.question, &options.json) {
        (Some(question), Some(answer)) => format!("zonobench verify {} {}", question.display(), answer.display()),
        _ => "--question Q --json A write question and answer; zonobench verify Q A checks them".to_owned(),
    };
    table.row("verify", verify);
    table.text()
}
