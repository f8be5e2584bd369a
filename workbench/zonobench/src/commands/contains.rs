//! `zonobench contains`: on which side of a zonotope's boundary each point of a file lies.

use std::fmt::Write as _;
use std::io::{self, Write};
use std::path::PathBuf;

use clap::Args;
use serde_json::json;

use super::Ending;
use super::asked::{Asked, floats, how_to_verify};
use super::asking::PointOptions;
use super::placing::{Placing, describe};
use super::table::{Table, figure};
use super::usage::{check_inputs, check_names};
use super::verify::question_name;
use crate::input::{Format, Placed, Reading, Wanted};
use crate::output::{Existing, Outputs};
use batch::Verdict;
use batch::json::vector_to_json;

/// Options of `contains`.
#[derive(Debug, Args)]
pub struct Options {
    /// The zonotope, of one to four dimensions: JSON with `generators` and perhaps a `center`, an answer that holds
    /// one, or a table whose rows are generators; `-` is standard input.
    body: PathBuf,
    /// The points: CSV, GeoJSON, JSON, NPY or a mesh, told from the extension; `-` is standard input.
    points: PathBuf,
    #[command(flatten)]
    reading: PointOptions,
    /// The format of the zonotope, where the extension does not tell it.
    #[arg(long, value_name = "FORMAT")]
    body_format: Option<Format>,
    #[command(flatten)]
    placing: Placing,
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

/// Reads, solves, checks, prints a line for each point on standard output, and the summary on standard error.
pub fn run(options: &Options) -> anyhow::Result<Ending> {
    let inputs = [&options.placing.inputs(&options.body)[..], &[&options.points]].concat();
    check_inputs(&inputs)?;
    let source = options.reading.source(&options.points)?;
    check_names(&[("JSON", options.json.as_ref()), ("JSON", options.question.as_ref())])?;
    let outputs = options.json.iter().chain(&options.question);
    let outputs = Outputs::checked(outputs, &inputs, Existing::from_force(options.force))?;
    let body = options.placing.read(&options.body, options.body_format)?;
    let reading = source.read(Wanted::Any)?;
    reading.check_dimension(&options.points, body.dimension())?;

    let name = format!("{} and {}", question_name(&options.body), question_name(&options.points));
    let mut input = body.question();
    input["points"] = reading.points.rows().map(vector_to_json).collect();
    let asked = Asked::of(json!({"id": name, "kind": "member_batch", "input": input}))?;
    let verdict = asked.verdict();
    asked.write(options.question.as_ref(), options.json.as_ref(), outputs)?;

    let statuses: Vec<&str> =
        asked.result()["status"].as_array().into_iter().flatten().filter_map(|status| status.as_str()).collect();
    let mut lines = String::new();
    for (number, (status, gauge)) in (1..).zip(statuses.iter().zip(floats(&asked.result()["gauge"]))) {
        writeln!(lines, "{number}\t{status}\t{}", figure(gauge)).expect("writing to a string does not fail");
    }
    outputs.print(&lines)?;
    io::stderr().lock().write_all(summary(options, &body, &reading, &statuses, &verdict).as_bytes())?;
    Ok(if matches!(verdict, Verdict::Wrong(_)) { Ending::Bad } else { Ending::Good })
}

fn summary(options: &Options, body: &Placed, reading: &Reading, statuses: &[&str], verdict: &Verdict) -> String {
    let mut table = Table::default();
    describe(&mut table, ["body", "pose"], body, &options.body);
    table.row("points", format!("{} in {}", reading.points.len(), options.points.display()));
    if let Some(columns) = reading.in_words() {
        table.row("columns", columns);
    }
    for status in ["inside", "boundary", "outside"] {
        table.row(status, statuses.iter().filter(|&&found| found == status).count().to_string());
    }
    let certificate = match verdict {
        Verdict::Right(proved) => format!("checked: {proved}"),
        Verdict::Unchecked(reason) => format!("not checked: {reason}"),
        Verdict::Wrong(reason) => format!("WRONG: {reason}"),
    };
    table.row("certificate", certificate);
    table.row("verify", how_to_verify(options.question.as_ref(), options.json.as_ref()));
    table.text()
}
