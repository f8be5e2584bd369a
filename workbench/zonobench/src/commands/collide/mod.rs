//! `zonobench collide`: whether two zonotopes in motion meet, and when first.

mod options;
mod step;
mod summary;

use serde_json::json;

pub use self::options::Options;
pub(super) use self::step::Step;

use super::Ending;
use super::asked::{About, Asked, check_dimensions, record, zonotope_of};
use super::usage::{check_inputs, check_names, question_name};
use crate::input::OptionNames;
use crate::output::{Existing, Outputs, Results};
use batch::Verdict;
use batch::json::to_json;

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
    let formats = [options.format, options.placing_of_b.format(options.format)];
    let files = [
        placings[0].read(names[0], formats[0], OptionNames::OF_FIRST)?,
        placings[1].read(names[1], formats[1], OptionNames::OF_SECOND)?,
    ];
    let mut request = record(About::Collide, &files.each_ref(), None, None);
    let bodies = files.map(|file| file.placed);
    check_dimensions(names, &bodies)?;
    let motion = options.step.motion()?;
    let name = format!("{} and {}", question_name(&options.a), question_name(&options.b));
    let rounded = [bodies[0].rounded(names[0])?, bodies[1].rounded(names[1])?];
    let questions = [0, 1].map(|i| match rounded[i].off {
        0.0 => bodies[i].question(),
        _ => zonotope_of(&rounded[i].body),
    });
    let mut question = About::Collide.question(&name, &questions, None, None);
    let resolution = options.step.resolution.map(to_json);
    for place in [&mut request, &mut question["input"]] {
        place["motion"] = motion.clone();
        if let Some(resolution) = &resolution {
            place["resolution"] = json!(resolution);
        }
    }
    let asked = Asked::of(question)?;
    let verdict = asked.verdict();

    let [question, answer] = asked.lines(request);
    let mut results = Results::default();
    results.add(options.question.as_ref(), || Ok(question));
    results.add(options.json.as_ref(), || Ok(answer));
    outputs.finish(results, &summary::summary(options, (&bodies, &rounded), &motion, &asked, &verdict))?;
    Ok(if matches!(verdict, Verdict::Wrong(_)) { Ending::Bad } else { Ending::Good })
}
