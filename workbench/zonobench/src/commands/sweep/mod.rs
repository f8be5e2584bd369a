//! `zonobench sweep`: a zonotope around all placements of a zonotope that turns and translates.

mod options;
mod summary;

pub use self::options::Options;

use super::Ending;
use super::asked::{About, Asked, check_taken, floats, record, zonotope_of};
use super::usage::{Usage, check_inputs, check_names, question_name};
use crate::input::{Body, OptionNames, RoundedBody};
use crate::output::{Existing, Outputs, Results};
use batch::Verdict;

/// Reads, encloses, checks, and prints a summary.
pub fn run(options: &Options) -> anyhow::Result<Ending> {
    let mut inputs = options.placing.inputs(&options.file);
    inputs.extend(options.motion.input());
    if !options.motion.is_given() {
        return Err(Usage::not_applicable("--motion", "no motion of the body is given").into());
    }
    check_inputs(&inputs)?;
    check_names(&[("JSON", options.json.as_ref()), ("JSON", options.question.as_ref())])?;
    check_names(&options.meshes.named())?;
    let outputs = options.json.iter().chain(&options.question).chain(options.meshes.files());
    let outputs = Outputs::checked(outputs, &inputs, Existing::from_force(options.force))?;
    let file = options.placing.read(&options.file, options.format, options.start.told(), OptionNames::OF_FIRST)?;
    let mut request = record(About::Sweep, &[&file], None, None);
    let placed = file.placed;
    check_taken(&options.file, &placed, 3..=3)?;
    let RoundedBody { body, off } = placed.rounded(&options.file)?;
    let motion = options.motion.sweep()?;
    let name = question_name(&options.file);
    let mut question = About::Sweep.question(&name, &[zonotope_of(&body)], None, None);
    for (name, value) in motion.as_object().into_iter().flatten() {
        question["input"][name] = value.clone();
        request[name] = value.clone();
    }
    question["method"] = options.method.as_str().into();
    let asked = Asked::of(question)?;
    let verdict = asked.verdict();
    let [question, answer] = asked.lines(request);
    let volume = zonotope_in(&asked);
    let mut results = Results::default();
    options.meshes.add_to(&mut results, &name, &volume);
    results.add(options.question.as_ref(), || Ok(question));
    results.add(options.json.as_ref(), || Ok(answer));
    outputs.finish(results, &summary::summary(options, &placed, (&body, off), &motion, &volume, &verdict))?;
    Ok(if matches!(verdict, Verdict::Wrong(_)) { Ending::Bad } else { Ending::Good })
}

/// The zonotope that the answer holds.
fn zonotope_in(asked: &Asked) -> Body {
    let result = asked.result();
    let generators = result["generators"].as_array().into_iter().flatten().map(floats).collect();
    Body { center: floats(&result["center"]), generators, is_rounded: false }
}
