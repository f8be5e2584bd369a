//! `zonobench intersect`: whether two zonotopes have a point in common, with the proof.

pub(super) mod drawing;
pub(super) mod meeting;
mod summary;

use std::path::PathBuf;

use clap::Args;

use self::meeting::Meeting;
use super::Ending;
use super::asked::check_dimensions;
use super::placing::{Placing, PlacingOfSecond};
use super::usage::{check_inputs, check_names};
use super::verify::question_name;
use crate::input::Format;
use crate::output::{Existing, Outputs};
use batch::Verdict;

/// Options of `intersect`.
#[derive(Debug, Args)]
pub struct Options {
    /// The first zonotope: JSON with `generators` and perhaps a `center`, or a table whose rows are generators; `-` is
    /// standard input.
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
    /// Write a picture of both bodies with the separating plane or the common point.
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

/// Reads, solves, checks, and prints the answer with its proof.
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
    let meeting = Meeting::of(&name, files, bodies)?;
    let verdict = meeting.asked.verdict();

    if let Some(file) = &options.svg {
        outputs.write(file, drawing::draw(&name, &meeting).as_bytes())?;
    }
    meeting.asked.write(options.question.as_ref(), options.json.as_ref(), outputs)?;
    outputs.tell(&summary::summary(options, &meeting, &verdict))?;
    Ok(if matches!(verdict, Verdict::Right(_)) { Ending::Good } else { Ending::Bad })
}
