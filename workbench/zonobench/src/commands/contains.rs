//! `zonobench contains`: on which side of a zonotope's boundary each point of a file lies.

use std::fmt::Write as _;
use std::path::PathBuf;

use clap::Args;

use super::Ending;
use super::asked::{About, Asked, body_formats, check_taken, floats, how_to_verify, record};
use super::asking::PointOptions;
use super::placing::{Placing, describe, told};
use super::table::{Table, in_full, with_six_digits};
use super::usage::question_name;
use super::usage::{check_inputs, check_names, read_telling};
use crate::input::{COORDINATE_LIMIT, Format, OptionNames, Placed, Reading, Wanted};
use crate::output::{Existing, Outputs, Results};
use batch::Verdict;

/// Options of `contains`.
#[derive(Debug, Args)]
pub struct Options {
    /// The zonotope, of one to four dimensions: JSON, or a table or an array of NumPy (csv, json, npy); `-` is standard
    /// input.
    ///
    /// JSON holds `center` and `generators`, or a list of generators, or an answer with a zonotope. Rows of tables and
    /// arrays are generators.
    body: PathBuf,
    /// The points: a table, GeoJSON, JSON, an array of NumPy or a mesh, as the extension tells; `-` is standard input.
    points: PathBuf,
    #[command(flatten)]
    reading: PointOptions,
    /// The format of the zonotope, where the extension does not tell it.
    #[arg(long, value_name = "FORMAT", value_parser = body_formats())]
    body_format: Option<Format>,
    /// The number of lines of the zonotope's table to leave out at its start.
    #[arg(long, value_name = "N")]
    body_skip: Option<u64>,
    /// The first line of the zonotope's table, behind those that are left out, holds data.
    #[arg(long)]
    body_no_header: bool,
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
    let skip = told(options.body_skip, options.body_no_header);
    let file = options.placing.read(&options.body, options.body_format, skip, OptionNames::BESIDE_POINTS)?;
    check_taken(&options.body, &file.placed, 1..=COORDINATE_LIMIT)?;
    let reading = read_telling(&source, Wanted::Any)?;
    reading.check_dimension(&options.points, file.placed.dimension())?;

    let name = format!("{} and {}", question_name(&options.body), question_name(&options.points));
    let request = record(About::Contains, &[&file], Some((&options.reading, &reading)), None);
    let asked = Asked::of(About::Contains.question(&name, &[file.placed.question()], Some(&reading), None))?;
    let verdict = asked.verdict();

    let statuses: Vec<&str> =
        asked.result()["status"].as_array().into_iter().flatten().filter_map(|status| status.as_str()).collect();
    let mut lines = String::new();
    for (number, (status, gauge)) in reading.numbers().zip(statuses.iter().zip(floats(&asked.result()["gauge"]))) {
        // a gauge that no multiple of the body reaches has the name that it has in the answer
        let gauge = if gauge == f64::INFINITY { "Infinity".to_owned() } else { in_full(gauge) };
        writeln!(lines, "{number}\t{status}\t{gauge}").expect("writing to a string does not fail");
    }
    let [question, answer] = asked.lines(request);
    let mut results = Results::default();
    results.add(options.question.as_ref(), || Ok(question));
    results.add(options.json.as_ref(), || Ok(answer));
    let printed = outputs.print(&lines);
    let summary = summary(options, &file.placed, &reading, &statuses, &verdict);
    outputs.finish_on_standard_error(results, &summary)?;
    printed?;
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
        Verdict::Right(proved) => format!("checked: {}", with_six_digits(proved)),
        Verdict::Unchecked(reason) => format!("not checked: {reason}"),
        Verdict::Wrong(reason) => format!("WRONG: {reason}"),
    };
    table.row("certificate", certificate);
    table.row(
        "verify",
        how_to_verify(&[&options.body, &options.points], options.question.as_ref(), options.json.as_ref()),
    );
    table.text()
}
