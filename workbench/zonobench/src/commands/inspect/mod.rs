//! `zonobench inspect`: what kind of body a zonotope is.

mod drawing;
pub(super) mod export;
mod measures;
mod summary;
mod vertices;

use std::path::PathBuf;

use anyhow::bail;
use clap::Args;
use serde_json::json;
use zonotope::zonotope::faces::FaceLattice;

use self::measures::Measures;
use self::vertices::{VertexFormat, VerticesError};
use super::Ending;
use super::placing::Placing;
use super::usage::{check_inputs, check_names};
use super::verify::question_name;
use crate::input::{Format, RoundedBody};
use crate::output::{Existing, Outputs};
use batch::Line;
use batch::MAX_DIMENSION;
use batch::Verdict;
use batch::json::rows_to_json;

/// Options of `inspect`.
#[derive(Debug, Args)]
pub struct Options {
    /// The zonotope: JSON with `generators` and perhaps a `center`, or a table whose rows are generators; `-` is
    /// standard input.
    file: PathBuf,
    /// The format, where the extension does not tell it.
    #[arg(long)]
    format: Option<Format>,
    #[command(flatten)]
    placing: Placing,
    /// Write a picture of the body.
    #[arg(long, value_name = "FILE")]
    svg: Option<PathBuf>,
    /// Write the vertices of a planar body, counter-clockwise: a table (.csv, or standard output) or a polygon
    /// (.geojson).
    #[arg(long, value_name = "FILE")]
    vertices: Option<PathBuf>,
    /// Write a body of space as a mesh, Wavefront OBJ.
    #[arg(long, value_name = "FILE")]
    obj: Option<PathBuf>,
    /// Write a body of space as a mesh, PLY in text form.
    #[arg(long, value_name = "FILE")]
    ply: Option<PathBuf>,
    /// Write a body of space as a mesh of triangles, binary STL.
    #[arg(long, value_name = "FILE")]
    stl: Option<PathBuf>,
    /// Write the counts of faces, in the format of `solve`.
    #[arg(long, value_name = "FILE")]
    json: Option<PathBuf>,
    /// Write the question in the format of `solve`: `verify` checks the answer against it.
    #[arg(long, value_name = "FILE")]
    question: Option<PathBuf>,
    /// Replace files that exist.
    #[arg(long)]
    force: bool,
}

/// Reads, counts, measures, checks, and prints a summary.
pub fn run(options: &Options) -> anyhow::Result<Ending> {
    let inputs = options.placing.inputs(&options.file);
    check_inputs(&inputs)?;
    check_names(&[
        ("SVG", options.svg.as_ref()),
        ("JSON", options.json.as_ref()),
        ("JSON", options.question.as_ref()),
        ("OBJ", options.obj.as_ref()),
        ("PLY", options.ply.as_ref()),
        ("STL", options.stl.as_ref()),
    ])?;
    let meshes = [&options.obj, &options.ply, &options.stl];
    let outputs = [&options.svg, &options.json, &options.question, &options.vertices];
    let outputs = outputs.into_iter().chain(meshes).flatten();
    let outputs = Outputs::checked(outputs, &inputs, Existing::from_force(options.force))?;
    let corners = options.vertices.as_ref().map(|file| Ok::<_, VerticesError>((file, VertexFormat::of(file)?)));
    let corners = corners.transpose()?;
    let placed = options.placing.read(&options.file, options.format)?;
    let RoundedBody { body, off } = placed.rounded(&options.file)?;
    let measures = match body.center.len() {
        1 => Measures::of::<1>(&placed, &body),
        2 => Measures::of::<2>(&placed, &body),
        3 => Measures::of::<3>(&placed, &body),
        4 => Measures::of::<4>(&placed, &body),
        5 => Measures::of::<5>(&placed, &body),
        6 => Measures::of::<6>(&placed, &body),
        other => bail!("{}: {other} dimensions; 1 to {MAX_DIMENSION} are taken", options.file.display()),
    };

    let name = question_name(&options.file);
    let corners =
        corners.map(|(file, format)| Ok::<_, VerticesError>((file, format.text(&name, &body)?))).transpose()?;
    let wanted = meshes.iter().any(|file| file.is_some());
    let largest = if options.stl.is_some() { f64::from(f32::MAX) } else { f64::MAX };
    let lattice = wanted.then(|| export::mesh(&name, &body, largest)).transpose()?;
    let mut question =
        json!({"id": name, "kind": "combinatorics", "input": {"generators": rows_to_json(&placed.body.generators)}});
    if let Some(pose) = &placed.pose {
        question["input"]["pose"] = pose.to_json();
    }
    let answer = batch::answer_line(1, &Line::Content(question.to_string().into_bytes()), 0);
    if let Some(file) = &options.svg {
        outputs.write(file, drawing::draw(&name, &body).as_bytes())?;
    }
    if let Some((file, corners)) = corners {
        outputs.write(file, corners.as_bytes())?;
    }
    if let Some(lattice) = lattice {
        let formats: [fn(&FaceLattice) -> Vec<u8>; 3] =
            [|mesh| mesh.to_obj().into_bytes(), |mesh| mesh.to_ply().into_bytes(), FaceLattice::to_stl];
        for (file, content) in meshes.into_iter().zip(formats) {
            if let Some(file) = file {
                outputs.write(file, &content(&lattice))?;
            }
        }
    }
    for (file, content) in [(&options.question, &question), (&options.json, &answer.content)] {
        if let Some(file) = file {
            outputs.write(file, format!("{content}\n").as_bytes())?;
        }
    }
    let verdict = batch::verify(&question.to_string(), &answer.content.to_string());
    outputs.tell(&summary::summary(options, (&placed, off), &measures, &answer.content, &verdict))?;
    Ok(if matches!(verdict, Verdict::Wrong(_)) { Ending::Bad } else { Ending::Good })
}
