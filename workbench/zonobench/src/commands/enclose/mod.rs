//! `zonobench enclose`: the smallest zonotope around the points of a file, by area in the plane or by total length.

mod by_length;
mod comparison;
mod drawing;
mod options;
mod solid;
mod summary;

pub use self::options::Options;

use anyhow::{anyhow, bail};
use serde_json::json;
use zonotope::enclosing::min_area_zonogon::Method;

use super::Ending;
use super::asking::Objective;
use super::usage::question_name;
use super::usage::{Usage, check_inputs, check_names};
use crate::enclosure::{Enclosure, exact_to_json};
use crate::input::{Points, Reading};
use crate::output::{Existing, Outputs, Results};
use crate::progress::Progress;

/// Reads, solves, checks, and prints a summary.
pub fn run(options: &Options) -> anyhow::Result<Ending> {
    if let Some(objective) = options.asking.stated_objective(&options.file)? {
        check_usage(options, objective)?;
    }
    let inputs = options.asking.inputs(&options.file);
    check_inputs(&inputs)?;
    check_names(&[("SVG", options.svg.as_ref()), ("JSON", options.json.as_ref()), ("OBJ", options.obj.as_ref())])?;
    let outputs = [&options.svg, &options.json, &options.obj].into_iter().flatten();
    let outputs = Outputs::checked(outputs, &inputs, Existing::from_force(options.force))?;
    let progress = Progress::of(3, "reading");
    let (reading, objective) = options.asking.read(&options.file)?;
    check_usage(options, objective)?;
    match objective {
        Objective::Area => by_area(options, &reading, progress, outputs),
        Objective::Length | Objective::Volume => by_length::run(options, &reading, objective, progress, outputs),
    }
}

/// Refuses options that make no sense for the objective.
fn check_usage(options: &Options, objective: Objective) -> Result<(), Usage> {
    match objective {
        Objective::Area if options.obj.is_some() => {
            Err(Usage::not_applicable("--obj", "only a zonotope of space is written as a mesh"))
        }
        Objective::Length | Objective::Volume if options.exact => {
            Err(Usage::not_applicable("--exact", "only the least area is computed in exact numbers"))
        }
        Objective::Length | Objective::Volume if options.seed.is_some() => {
            Err(Usage::not_applicable("--seed", "the least length is found without random numbers"))
        }
        _ => Ok(()),
    }
}

fn by_area(options: &Options, reading: &Reading, progress: Progress, outputs: Outputs) -> anyhow::Result<Ending> {
    let Points::Plane(points) = &reading.points else {
        bail!("{}: the least area is that of points with two coordinates", options.file.display());
    };
    progress.next("solving");
    let enclosure = Enclosure::of(points, Method::default(), options.seed.unwrap_or(0))
        .map_err(|error| anyhow!("{}: {error}", options.file.display()))?;
    progress.next("checking");
    let proof = enclosure.check(points).proof();
    drop(progress);

    let exact = options.exact.then(|| enclosure.exact());
    let mut results = Results::default();
    results.add(options.svg.as_ref(), || Ok(drawing::draw(&options.file, points, &enclosure).into_bytes()));
    results.add(options.json.as_ref(), || {
        let mut result = enclosure.result();
        if let Some(exact) = &exact {
            result["exact"] = exact_to_json(exact);
        }
        let answer = json!({
            "id": question_name(&options.file),
            "kind": "min_area",
            "method": enclosure.method.id(),
            "request": options.asking.record(reading, Objective::Area)?,
            "result": result,
        });
        Ok(format!("{answer}\n").into_bytes())
    });
    outputs.finish(results, &summary::summary(options, reading, &enclosure, proof.as_ref(), exact.as_ref()))?;
    Ok(if proof.is_ok() { Ending::Good } else { Ending::Bad })
}
