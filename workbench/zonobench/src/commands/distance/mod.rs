//! `zonobench distance`: how far apart two zonotopes are, or how deep they overlap.

mod options;
mod summary;

pub use self::options::Options;
use std::path::PathBuf;

use serde_json::Value;

use super::Ending;
use super::asked::{About, Asked, check_dimensions, floats, record};
use super::intersect::drawing::draw_with_points;
use super::intersect::meeting::{Gap, Meeting, Proof};
use super::usage::question_name;
use super::usage::{check_inputs, check_names};
use crate::input::{OptionNames, Placed};
use crate::output::{Existing, Outputs, Results};
use batch::Verdict;

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
    let names = [&options.a, &options.b];
    let formats = [options.format, options.placing_of_b.format(options.format)];
    let skips = [options.start.told(), options.placing_of_b.skip(options.start.told())];
    let files = [
        placings[0].read(names[0], formats[0], skips[0], OptionNames::OF_FIRST)?,
        placings[1].read(names[1], formats[1], skips[1], OptionNames::OF_SECOND)?,
    ];
    let request = record(About::Distance, &files.each_ref(), None, None);
    let bodies = files.map(|file| file.placed);
    check_dimensions(names, &bodies, 1..=3)?;
    let name = format!("{} and {}", question_name(&options.a), question_name(&options.b));
    let questions = bodies.each_ref().map(Placed::question);
    let asked = Asked::of(About::Distance.question(&name, &questions, None, None))?;
    let verdict = asked.verdict();

    let [question, answer] = asked.lines(request);
    let mut results = Results::default();
    results.add(options.svg.as_ref(), || picture(&name, names, &bodies, &asked));
    results.add(options.question.as_ref(), || Ok(question));
    results.add(options.json.as_ref(), || Ok(answer));
    outputs.finish(results, &summary::summary(options, &bodies, &asked, &verdict))?;
    Ok(if matches!(verdict, Verdict::Wrong(_)) { Ending::Bad } else { Ending::Good })
}

/// Both bodies with the segment between their nearest points.
fn picture(name: &str, files: [&PathBuf; 2], bodies: &[Placed; 2], asked: &Asked) -> anyhow::Result<Vec<u8>> {
    let points = ["a", "b"].map(|body| floats(&asked.result()["nearest"][body]));
    let mut meeting = Meeting::of(name, files, bodies.clone())?;
    if let Proof::Gap(_) = meeting.proof {
        let between: Vec<Value> = points[1].iter().zip(&points[0]).map(|(b, a)| (b - a).into()).collect();
        // a gap that is too narrow for doubles is drawn along the direction that separates
        if between.iter().any(|c| c.as_f64() != Some(0.0)) {
            meeting.proof = Proof::Gap(Gap::of(&meeting.exact, &between)?);
        }
    }
    Ok(draw_with_points(name, &meeting, &points).into_bytes())
}
