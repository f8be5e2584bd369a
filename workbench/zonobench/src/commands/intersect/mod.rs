//! `zonobench intersect`: whether two zonotopes have a point in common, with the proof.

pub(super) mod drawing;
pub(super) mod meeting;
mod options;
mod summary;

pub use self::options::Options;

use self::meeting::Meeting;
use super::Ending;
use super::asked::{About, check_dimensions, record};
use super::usage::question_name;
use super::usage::{check_inputs, check_names};
use crate::input::OptionNames;
use crate::output::{Existing, Outputs, Results};
use batch::MAX_DIMENSION;
use batch::Verdict;

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
    let names = [&options.a, &options.b];
    let formats = [options.format, options.placing_of_b.format(options.format)];
    let skips = [options.start.told(), options.placing_of_b.skip(options.start.told())];
    let files = [
        placings[0].read(names[0], formats[0], skips[0], OptionNames::OF_FIRST)?,
        placings[1].read(names[1], formats[1], skips[1], OptionNames::OF_SECOND)?,
    ];
    let request = record(About::Intersect, &files.each_ref(), None, None);
    let bodies = files.map(|file| file.placed);
    check_dimensions(names, &bodies, 1..=MAX_DIMENSION)?;
    let name = format!("{} and {}", question_name(&options.a), question_name(&options.b));
    let meeting = Meeting::of(&name, names, bodies)?;
    let verdict = meeting.asked.verdict();

    let [question, answer] = meeting.asked.lines(request);
    let mut results = Results::default();
    results.add(options.svg.as_ref(), || Ok(drawing::draw(&name, &meeting).into_bytes()));
    results.add(options.question.as_ref(), || Ok(question));
    results.add(options.json.as_ref(), || Ok(answer));
    outputs.finish(results, &summary::summary(options, &meeting, &verdict))?;
    Ok(if matches!(verdict, Verdict::Right(_)) { Ending::Good } else { Ending::Bad })
}
