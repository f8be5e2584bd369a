//! `zonobench reduce`: a zonotope of few generators around a zonotope.

mod drawing;

use std::path::PathBuf;

use clap::Args;
use clap::builder::PossibleValuesParser;
use serde_json::Value;

use super::Ending;
use super::asked::{About, Asked, body_formats, check_taken, float, floats, how_to_verify, record, zonotope_of};
use super::placing::{Placing, TableStart, describe, rounded_in_words};
use super::table::{Table, at_least, at_most, counted, figure, with_six_digits};
use super::usage::question_name;
use super::usage::{check_inputs, check_names};
use crate::input::{Body, Format, OptionNames, Placed, RoundedBody};
use crate::output::{Existing, Outputs, Results};
use batch::{MAX_DIMENSION, Verdict};
use zonotope::Zonotope;
use zonotope::reduction::Method;

/// Options of `reduce`.
#[derive(Debug, Args)]
pub struct Options {
    /// The zonotope: JSON, or a table or an array of NumPy (csv, json, npy); `-` is standard input.
    ///
    /// JSON holds `center` and `generators`, or a list of generators, or an answer with a zonotope. Rows of tables and
    /// arrays are generators.
    file: PathBuf,
    /// The most generators of the answer: at least as many as there are coordinates.
    #[arg(long, value_name = "K")]
    count: u64,
    /// The rule: the best of all, or one of them.
    #[arg(long, default_value = Method::Clusters.id(), value_parser = rules())]
    rule: String,
    /// The format, where the extension does not tell it.
    #[arg(long, value_parser = body_formats())]
    format: Option<Format>,
    #[command(flatten)]
    start: TableStart,
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
    let file = options.placing.read(&options.file, options.format, options.start.told(), OptionNames::OF_FIRST)?;
    let reduction = Some((options.count, options.rule.as_str()));
    let request = record(About::Reduce, &[&file], None, reduction);
    let placed = file.placed;
    check_taken(&options.file, &placed, 1..=MAX_DIMENSION)?;
    let RoundedBody { body, off } = placed.rounded(&options.file)?;
    let name = question_name(&options.file);
    let asked = Asked::of(About::Reduce.question(&name, &[zonotope_of(&body)], None, reduction))?;
    let verdict = asked.verdict();
    let rows = asked.result()["generators"].as_array().into_iter().flatten();
    let reduced: Vec<Vec<f64>> = rows.map(floats).collect();
    let [question, answer] = asked.lines(request);
    let mut results = Results::default();
    results.add(options.svg.as_ref(), || Ok(drawing::draw(&name, &body, &reduced).into_bytes()));
    results.add(options.question.as_ref(), || Ok(question));
    results.add(options.json.as_ref(), || Ok(answer));
    outputs.finish(results, &summary(options, &placed, (&body, off), &reduced, &asked, &verdict))?;
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
            at_least(float(&distance["lower"])),
            at_most(float(&distance["upper"]))
        ),
    );
    let lengths = [reduced, &body.generators].map(|generators| figure(total_length(body.center.len(), generators)));
    table.row("total length", format!("{}, of the body {}", lengths[0], lengths[1]));
    table.row(
        "certificate",
        match verdict {
            Verdict::Right(proved) => format!("checked: {}", with_six_digits(proved)),
            Verdict::Unchecked(reason) => format!("not all was checked: {reason}"),
            Verdict::Wrong(reason) => format!("WRONG: {reason}"),
        },
    );
    table.row("verify", how_to_verify(&[&options.file], options.question.as_ref(), options.json.as_ref()));
    table.text()
}
