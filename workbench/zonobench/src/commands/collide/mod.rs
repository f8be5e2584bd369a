//! `zonobench collide`: whether two zonotopes or two meshes in motion meet, and when first.

mod of_meshes;
mod options;
mod step;
mod summary;

use serde_json::Value;

use self::of_meshes::AskedMeshes;
pub use self::options::Options;
pub(super) use self::step::Step;

use super::Ending;
use super::asked::{About, Asked, check_dimensions, record, zonotope_of};
use super::usage::{check_inputs, check_names, question_name};
use crate::input::OptionNames;
use crate::output::{Existing, Outputs, Results};
use batch::Verdict;

/// Reads, solves, checks, and prints when the bodies meet first with the proof. A body whose image under its pose no
/// doubles hold is asked about with the nearest ones, and the summary says how far off these are.
pub fn run(options: &Options) -> anyhow::Result<Ending> {
    let placings = [&options.placing, &options.placing_of_b.placing()];
    let bodies = [placings[0].inputs(&options.a), placings[1].inputs(&options.b)].concat();
    let inputs = [bodies, options.step.inputs()].concat();
    options.step.check()?;
    check_inputs(&inputs)?;
    check_names(&[("JSON", options.json.as_ref()), ("JSON", options.question.as_ref())])?;
    let outputs = options.json.iter().chain(&options.question);
    let outputs = Outputs::checked(outputs, &inputs, Existing::from_force(options.force))?;
    let names = [&options.a, &options.b];
    if of_meshes::are_meshes(options)? {
        let AskedMeshes { asked, request, motion, meshes } = of_meshes::asked(options)?;
        let summary = |verdict: &Verdict| summary::of_meshes(options, &meshes, &motion, &asked, verdict);
        return finished(options, &outputs, &asked, &request, summary);
    }
    let formats = [options.format, options.placing_of_b.format(options.format)];
    let skips = [options.start.told(), options.placing_of_b.skip(options.start.told())];
    let files = [
        placings[0].read(names[0], formats[0], skips[0], OptionNames::OF_FIRST)?,
        placings[1].read(names[1], formats[1], skips[1], OptionNames::OF_SECOND)?,
    ];
    let mut request = record(About::Collide, &files.each_ref(), None, None);
    let bodies = files.map(|file| file.placed);
    check_dimensions(names, &bodies, 3..=3)?;
    let motion = options.step.motion()?;
    let name = format!("{} and {}", question_name(&options.a), question_name(&options.b));
    let rounded = [bodies[0].rounded(names[0])?, bodies[1].rounded(names[1])?];
    let questions = [0, 1].map(|i| match rounded[i].off {
        0.0 => bodies[i].question(),
        _ => zonotope_of(&rounded[i].body),
    });
    let mut question = About::Collide.question(&name, &questions, None, None);
    options.step.add(&motion, [&mut request, &mut question["input"]]);
    let asked = Asked::of(question)?;
    let summary = |verdict: &Verdict| summary::summary(options, (&bodies, &rounded), &motion, &asked, verdict);
    finished(options, &outputs, &asked, &request, summary)
}

/// Checks an answer, writes what is asked for, and prints the summary.
fn finished(
    options: &Options,
    outputs: &Outputs,
    asked: &Asked,
    request: &Value,
    summary: impl FnOnce(&Verdict) -> String,
) -> anyhow::Result<Ending> {
    let verdict = asked.verdict();
    let [question, answer] = asked.lines(request.clone());
    let mut results = Results::default();
    results.add(options.question.as_ref(), || Ok(question));
    results.add(options.json.as_ref(), || Ok(answer));
    outputs.finish(results, &summary(&verdict))?;
    Ok(if matches!(verdict, Verdict::Wrong(_)) { Ending::Bad } else { Ending::Good })
}
