//! `zonobench reduce`: a zonotope of few generators around a zonotope.

mod drawing;

use std::path::PathBuf;

use clap::Args;
use clap::builder::PossibleValuesParser;
use serde_json::{Value, json};

use super::Ending;
use super::asked::{Asked, float, floats, how_to_verify};
use super::placing::{Placing, describe, rounded_in_words};
use super::table::{Table, counted, figure};
use super::usage::{check_inputs, check_names};
use super::verify::question_name;
use crate::input::{Body, Format, Placed, RoundedBody};
use crate::output::{Existing, Outputs};
use batch::Verdict;
use batch::json::{rows_to_json, vector_to_json};
use zonotope::Zonotope;
use zonotope::reduction::Method;

/// Options of `reduce`.
#[derive(Debug, Args)]
pub struct Options {
    /// The zonotope: JSON with `generators` and perhaps a `center`, or a table whose rows are generators; `-` is
    /// standard input.
    file: PathBuf,
    /// The most generators of the answer: at least as many as there are coordinates.
    #[arg(long, value_name = "K")]
    count: u64,
    /// The rule: the best of all, or one of them.
    #[arg(long, default_value = Method::Clusters.id(), value_parser = rules())]
    rule: String,
    /// The format, where the extension does not tell it.
    #[arg(long)]
    format: Option<Format>,
    #[command(flatten)]
    placing: Placing,
    /// Write a picture of both bodies.
    #[arg(long, value_name = "FILE")]
    svg: Option<PathBuf>,
    /// Write the answer with its certificate, in the format of `solve`: other commands read the body from it.
    #[arg(long, value_name = "FILE")]
    json: Option<PathBuf>,
    /// Write the question in the format of `solve`: `verify` checks the answer against it.
    #[arg(long, value_name = "FILE")]
    question: Option<PathBuf>,
    /// Replace files that exist.
    #[arg(long)]
    force: bool,
}

fn rules() -> PossibleValuesParser {
    PossibleValuesParser::new(Method::ALL.map(Method::id))
}

/// Reads, reduces, checks, and prints a summary.
pub fn run(options: &Options) -> anyhow::Result<Ending> {
    let inputs = options.placing.inputs(&options.file);
    check_inputs(&inputs)?;
    check_names(&[
        ("SVG", options.svg.as_ref()),
        ("JSON", options.json.as_ref()),
        ("JSON", options.question.as_ref()),
    ])?;
    let outputs = options.svg.iter().chain(&options.json).chain(&options.question);
    let outputs = Outputs::checked(outputs, &inputs, Existing::from_force(options.force))?;
    let placed = options.placing.read(&options.file, options.format)?;
    let RoundedBody { body, off } = placed.rounded(&options.file)?;
    let name = question_name(&options.file);
    let input = json!({
        "center": vector_to_json(&body.center),
        "generators": rows_to_json(&body.generators),
        "count": options.count,
        "rule": options.rule,
    });
    let asked = Asked::of(json!({"id": name, "kind": "reduce", "input": input}))?;
    let verdict = asked.verdict();
    let rows = asked.result()["generators"].as_array().into_iter().flatten();
    let reduced: Vec<Vec<f64>> = rows.map(floats).collect();
    if let Some(file) = &options.svg {
        outputs.write(file, drawing::draw(&name, &body, &reduced).as_bytes())?;
    }
    asked.write(options.question.as_ref(), options.json.as_ref(), outputs)?;
    outputs.tell(&summary(options, &placed, (&body, off), &reduced, &asked, &verdict))?;
    Ok(if matches!(verdict, Verdict::Wrong(_)) { Ending::Bad } else { Ending::Good })
}

/// The total length of generators, of a body that was reduced: those of more than six dimensions are refused.
fn total_length(dimension: usize, generators: &[Vec<f64>]) -> f64 {
    match dimension {
        1 => total_length_in::<1>(generators),
        2 => total_length_in::<2>(generators),
        3 => total_length_in::<3>(generators),
        4 => total_length_in::<4>(generators),
        5 => total_length_in::<5>(generators),
        _ => total_length_in::<6>(generators),
    }
}

fn total_length_in<const D: usize>(generators: &[Vec<f64>]) -> f64 {
    let fixed = |g: &Vec<f64>| -> [f64; D] { std::array::from_fn(|axis| g.get(axis).copied().unwrap_or_default()) };
    let body = Zonotope::new([0.0; D], generators.iter().map(fixed).collect::<Vec<[f64; D]>>());
    body.map_or(f64::INFINITY, |body| body.total_length())
}

fn summary(
    options: &Options,
    placed: &Placed,
    (body, off): (&Body, f64),
    reduced: &[Vec<f64>],
    asked: &Asked,
    verdict: &Verdict,
) -> String {
    let mut table = Table::default();
    describe(&mut table, ["body", "pose"], placed, &options.file);
    if off > 0.0 {
        table.row("rounded", rounded_in_words(off));
    }
    table.row("answer", format!("{}, around the same centre", counted(reduced.len(), "generator", "generators")));
    table.row("rule", options.rule.clone());
    let distance: &Value = &asked.result()["hausdorff"];
    table.row(
        "distance",
        format!(
            "between {} and {}: no point of the answer is farther than that from the body",
            figure(float(&distance["lower"])),
            figure(float(&distance["upper"]))
        ),
    );
    let lengths = [reduced, &body.generators].map(|generators| figure(total_length(body.center.len(), generators)));
    table.row("total length", format!("{}, of the body {}", lengths[0], lengths[1]));
    table.row(
        "certificate",
        match verdict {
            Verdict::Right(proved) | Verdict::Unchecked(proved) => format!("checked: {proved}"),
            Verdict::Wrong(reason) => format!("WRONG: {reason}"),
        },
    );
    table.row("verify", how_to_verify(options.question.as_ref(), options.json.as_ref()));
    table.text()
}
