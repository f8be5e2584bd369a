//! `zonobench distance`: how far apart two zonotopes are, or how deep they overlap.

mod summary;

use std::path::PathBuf;

use clap::Args;
use serde_json::{Value, json};

use super::Ending;
use super::asked::{Asked, check_dimensions, floats};
use super::intersect::drawing::draw_with_points;
use super::intersect::meeting::{Gap, Meeting, Proof};
use super::placing::{Placing, PlacingOfSecond};
use super::usage::{check_inputs, check_names};
use super::verify::question_name;
use crate::input::{Format, Placed};
use crate::output::{Existing, Outputs};
use batch::Verdict;

/// Options of `distance`.
#[derive(Debug, Args)]
pub struct Options {
    /// The first zonotope, of one to three dimensions: JSON with `generators` and perhaps a `center`, or a table whose
    /// rows are generators; `-` is standard input.
    a: PathBuf,
    /// The second zonotope.
    b: PathBuf,
    /// The format of both files, where their extensions do not tell it.
    #[arg(long)]
    format: Option<Format>,
    #[command(flatten)]
    placing: Placing,
    #[command(flatten)]
    placing_of_b: PlacingOfSecond,
    /// Write a picture of both bodies with their nearest points.
    #[arg(long, value_name = "FILE")]
    svg: Option<PathBuf>,
    /// Write the answer with its certificate, in the format of `solve`.
    #[arg(long, value_name = "FILE")]
    json: Option<PathBuf>,
    /// Write the question in the format of `solve`: `verify` checks the answer against it.
    #[arg(long, value_name = "FILE")]
    question: Option<PathBuf>,
    /// Replace files that exist.
    #[arg(long)]
    force: bool,
}

/// Reads, solves, checks, and prints the distance with its proof.
pub fn run(options: &Options) -> anyhow::Result<Ending> {
    let placings = [&options.placing, &options.placing_of_b.placing()];
    let inputs = [placings[0].inputs(&options.a), placings[1].inputs(&options.b)].concat();
    check_inputs(&inputs)?;
    check_names(&[
        ("SVG", options.svg.as_ref()),
        ("JSON", options.json.as_ref()),
        ("JSON", options.question.as_ref()),
    ])?;
    let outputs = options.svg.iter().chain(&options.json).chain(&options.question);
    let outputs = Outputs::checked(outputs, &inputs, Existing::from_force(options.force))?;
    let files = [&options.a, &options.b];
    let bodies = [placings[0].read(files[0], options.format)?, placings[1].read(files[1], options.format)?];
    check_dimensions(files, &bodies)?;
    let name = format!("{} and {}", question_name(&options.a), question_name(&options.b));
    let [a, b] = bodies.each_ref().map(Placed::question);
    let asked = Asked::of(json!({"id": name, "kind": "distance", "input": {"a": a, "b": b}}))?;
    let verdict = asked.verdict();

    if let Some(file) = &options.svg {
        let points = ["a", "b"].map(|body| floats(&asked.result()["nearest"][body]));
        let mut meeting = Meeting::of(&name, files, bodies.clone())?;
        if let Proof::Gap(_) = meeting.proof {
            let between: Vec<Value> = points[1].iter().zip(&points[0]).map(|(b, a)| (b - a).into()).collect();
            // a gap that is too narrow for doubles is drawn along the direction that separates
            if between.iter().any(|c| c.as_f64() != Some(0.0)) {
                meeting.proof = Proof::Gap(Gap::of(&meeting.exact, &between)?);
            }
        }
        outputs.write(file, draw_with_points(&name, &meeting, &points).as_bytes())?;
    }
    asked.write(options.question.as_ref(), options.json.as_ref(), outputs)?;
    outputs.tell(&summary::summary(options, &bodies, &asked, &verdict))?;
    Ok(if matches!(verdict, Verdict::Wrong(_)) { Ending::Bad } else { Ending::Good })
}
