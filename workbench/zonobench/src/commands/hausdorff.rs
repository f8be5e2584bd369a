//! `zonobench hausdorff`: the Hausdorff distance of two zonotopes, and whether one contains the other.

use std::path::PathBuf;

use clap::Args;

use super::Ending;
use super::asked::{About, Asked, body_formats, check_dimensions, float, floats, how_to_verify, record, zonotope_of};
use super::placing::{Placing, PlacingOfSecond, TableStart, describe, rounded_in_words};
use super::table::{Table, at_least, at_most, figure, tuple, with_six_digits};
use super::usage::question_name;
use super::usage::{check_inputs, check_names};
use crate::input::{Format, OptionNames, Placed};
use crate::output::{Existing, Outputs, Results};
use batch::{MAX_DIMENSION, Verdict};

/// Options of `hausdorff`.
#[derive(Debug, Args)]
pub struct Options {
    /// The first zonotope: JSON, or a table or an array of NumPy (csv, json, npy); `-` is standard input.
    ///
    /// JSON holds `center` and `generators`, or a list of generators, or an answer with a zonotope. Rows of tables and
    /// arrays are generators.
    a: PathBuf,
    /// The second zonotope.
    b: PathBuf,
    /// The format of both files, where their extensions do not tell it; --format-b is that of the second.
    #[arg(long, value_parser = body_formats())]
    format: Option<Format>,
    #[command(flatten)]
    start: TableStart,
    #[command(flatten)]
    placing: Placing,
    #[command(flatten)]
    placing_of_b: PlacingOfSecond,
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

/// Reads, solves, checks, and prints the distance between two bounds.
pub fn run(options: &Options) -> anyhow::Result<Ending> {
    let placings = [&options.placing, &options.placing_of_b.placing()];
    let inputs = [placings[0].inputs(&options.a), placings[1].inputs(&options.b)].concat();
    check_inputs(&inputs)?;
    check_names(&[("JSON", options.json.as_ref()), ("JSON", options.question.as_ref())])?;
    let outputs = options.json.iter().chain(&options.question);
    let outputs = Outputs::checked(outputs, &inputs, Existing::from_force(options.force))?;
    let names = [&options.a, &options.b];
    let formats = [options.format, options.placing_of_b.format(options.format)];
    let skips = [options.start.told(), options.placing_of_b.skip(options.start.told())];
    let files = [
        placings[0].read(names[0], formats[0], skips[0], OptionNames::OF_FIRST)?,
        placings[1].read(names[1], formats[1], skips[1], OptionNames::OF_SECOND)?,
    ];
    let request = record(About::Hausdorff, &files.each_ref(), None, None);
    let bodies = files.map(|file| file.placed);
    check_dimensions(names, &bodies, 1..=MAX_DIMENSION)?;
    let rounded = [bodies[0].rounded(names[0])?, bodies[1].rounded(names[1])?];
    let name = format!("{} and {}", question_name(&options.a), question_name(&options.b));
    let questions = rounded.each_ref().map(|rounded| zonotope_of(&rounded.body));
    let asked = Asked::of(About::Hausdorff.question(&name, &questions, None, None))?;
    let verdict = asked.verdict();

    let [question, answer] = asked.lines(request);
    let mut results = Results::default();
    results.add(options.question.as_ref(), || Ok(question));
    results.add(options.json.as_ref(), || Ok(answer));
    outputs.finish(results, &summary(options, &bodies, rounded.map(|rounded| rounded.off), &asked, &verdict))?;
    Ok(if matches!(verdict, Verdict::Wrong(_)) { Ending::Bad } else { Ending::Good })
}

fn summary(options: &Options, bodies: &[Placed; 2], off: [f64; 2], asked: &Asked, verdict: &Verdict) -> String {
    let result = asked.result();
    let mut table = Table::default();
    describe(&mut table, ["a", "pose of a"], &bodies[0], &options.a);
    describe(&mut table, ["b", "pose of b"], &bodies[1], &options.b);
    for (label, off) in ["rounded a", "rounded b"].into_iter().zip(off).filter(|(_, off)| *off > 0.0) {
        table.row(label, rounded_in_words(off));
    }
    let [lower, upper] = ["lower", "upper"].map(|bound| float(&result[bound]));
    table.row(
        "distance",
        format!(
            "{}, between {} and {}: no point of one body is farther than that from the other",
            figure(float(&result["value"])),
            at_least(lower),
            at_most(upper)
        ),
    );
    if lower > 0.0 {
        table.row(
            "direction",
            format!("{}, in which the bodies reach most differently", tuple(&floats(&result["direction"]))),
        );
    }
    let subset = if result["a_subset_b"] == true { "b contains a" } else { "b does not contain a" };
    table.row("containment", subset.to_owned());
    table.row(
        "certificate",
        match verdict {
            Verdict::Right(proved) => format!("checked: {}", with_six_digits(proved)),
            Verdict::Unchecked(reason) => format!("not all was checked: {reason}"),
            Verdict::Wrong(reason) => format!("WRONG: {reason}"),
        },
    );
    table.row("method", asked.answer["method"].as_str().unwrap_or_default().to_owned());
    table.row("verify", how_to_verify(&[&options.a, &options.b], options.question.as_ref(), options.json.as_ref()));
    table.text()
}
