//! `zonobench mesh`: whether two meshes of triangles meet, in which pairs, or how far apart they are; or the volumes of
//! a level of one mesh's hierarchy.

mod faces;
mod level;
mod options;
mod reading;
mod summary;

pub use self::options::Options;
pub(super) use self::reading::Read;

use std::path::Path;

use anyhow::bail;
use serde_json::json;

use super::Ending;
use super::asked::Asked;
use super::placing::put;
use super::usage::{check_inputs, check_names, question_name};
use crate::input::OptionNames;
use crate::output::{Existing, Outputs, Results};
use batch::Verdict;

/// Reads, solves, checks, and prints what was found.
pub fn run(options: &Options) -> anyhow::Result<Ending> {
    match (&options.b, options.level) {
        (Some(b), _) => of_two(options, b),
        (None, Some(level)) => level::run(options, level),
        (None, None) => unreachable!("the command line has a second mesh or a level"),
    }
}

fn of_two(options: &Options, file_b: &Path) -> anyhow::Result<Ending> {
    // clap leaves out what an option requires where that conflicts with something else
    if options.obj.is_some() {
        bail!("--obj writes the volumes of a level, which --level tells");
    }
    let inputs = [options.a.as_path(), file_b];
    check_inputs(&inputs)?;
    check_names(&[("JSON", options.json.as_ref()), ("JSON", options.question.as_ref())])?;
    let outputs = options.json.iter().chain(&options.question);
    let outputs = Outputs::checked(outputs, &inputs, Existing::from_force(options.force))?;
    let of_a = put(3, options.turn.as_ref(), options.shift.as_ref(), OptionNames::OF_FIRST)?;
    let of_b = put(3, options.turn_b.as_ref(), options.shift_b.as_ref(), OptionNames::OF_SECOND)?;
    let [a, b] = [Read::of(&options.a, options.format, of_a)?, Read::of(file_b, options.format, of_b)?];
    let mut input = json!({"a": a.question, "b": b.question});
    if options.pairs {
        input["pairs"] = true.into();
    }
    let name = format!("{} and {}", question_name(&options.a), question_name(file_b));
    let mut question = json!({"id": name, "kind": "mesh", "input": input});
    if let Some(volume) = &options.volume {
        question["method"] = volume.as_str().into();
    }
    let asked = Asked::of(question)?;
    let verdict = asked.verdict();
    let [question, answer] = [&asked.question, &asked.answer].map(|content| format!("{content}\n").into_bytes());
    let mut results = Results::default();
    results.add(options.question.as_ref(), || Ok(question));
    results.add(options.json.as_ref(), || Ok(answer));
    outputs.finish(results, &summary::summary(options, [(&options.a, &a), (file_b, &b)], &asked, &verdict))?;
    Ok(if matches!(verdict, Verdict::Wrong(_)) { Ending::Bad } else { Ending::Good })
}
