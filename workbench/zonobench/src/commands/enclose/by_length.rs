//! The zonotope of least total length, along given directions or along any.

use anyhow::{Context, bail};
use serde_json::Value;

use super::options::Options;
use super::summary::verification;
use super::{comparison, solid};
use crate::commands::Ending;
use crate::commands::asking::Objective;
use crate::commands::mesh_files::mesh;
use crate::commands::table::{Table, counted, factor_at_most, figure, lower_bound, position, with_six_digits};
use crate::commands::usage::question_name;
use crate::input::{Body, Reading, body_of_answer};
use crate::output::{Outputs, Results};
use crate::progress::Progress;
use batch::Line;
use batch::json::{self, MAX_VALUES, Tree};
use batch::{Verdict, check};

/// Reads, solves, checks, and prints a summary.
pub(super) fn run(
    options: &Options,
    reading: &Reading,
    objective: Objective,
    progress: Progress,
    outputs: Outputs,
) -> anyhow::Result<Ending> {
    let file = &options.file;
    let name = question_name(file);
    let points = &reading.points;
    if options.obj.is_some() && points.dimension() != 3 {
        bail!("{}: only a zonotope of space is written as a mesh", file.display());
    }
    let question = options.asking.question_of_length(&name, points, objective)?;
    progress.next("solving");
    let mut answer = batch::answer_line(1, &Line::Content(question.to_string().into_bytes()), 0).content;
    if let Some(message) = answer["error"]["message"].as_str() {
        bail!("{}: {message}", file.display());
    }
    answer["request"] = options.asking.record(reading, objective)?;
    progress.next("checking");
    let tree = |value: &Value| json::read(value.to_string().as_bytes(), MAX_VALUES);
    let (question, answered) = (tree(&question)?, tree(&answer)?);
    let verdict = check(&question, &answered);
    drop(progress);

    let body = body_of_answer(file, &answered)?;
    let drawn = || {
        let none = "no zonotope along the directions contains the points, so none is drawn";
        body.as_ref().with_context(|| format!("{}: {none}", file.display()))
    };
    let mut results = Results::default();
    results.add(options.svg.as_ref(), || Ok(solid::draw(&name, reading, drawn()?).into_bytes()));
    results.add(options.obj.as_ref(), || Ok(mesh(&name, drawn()?, f64::MAX)?.to_obj().into_bytes()));
    results.add(options.json.as_ref(), || Ok(format!("{answer}\n").into_bytes()));
    outputs.finish(results, &summary(options, reading, &question, &answer, body.as_ref(), &verdict))?;
    Ok(if matches!(verdict, Verdict::Wrong(_)) { Ending::Bad } else { Ending::Good })
}

/// The answer in a few lines.
fn summary(
    options: &Options,
    reading: &Reading,
    question: &Tree,
    answer: &Value,
    body: Option<&Body>,
    verdict: &Verdict,
) -> String {
    let mut table = Table::default();
    let points = &reading.points;
    let coordinates = counted(points.dimension(), "coordinate", "coordinates");
    table.row("points", format!("{} in {}, with {coordinates}", points.len(), options.file.display()));
    if let Some(columns) = reading.in_words() {
        table.row("columns", columns);
    }
    let directions = question.field("input").and_then(|input| input.field("directions")).and_then(Tree::list);
    table.row("directions", directions.map_or("any".to_owned(), |directions| directions.len().to_string()));
    let result = &answer["result"];
    if let Some(body) = body {
        table.row("centre", position(&body.center, body.reach()));
        table.row("zonotope", counted(body.generators.len(), "generator", "generators"));
        let number = |name: &str| result[name].as_f64().unwrap_or(f64::INFINITY);
        let length = if directions.is_some() { number("value") } else { number("length") };
        let bound = number("lower_bound");
        table.row("length", format!("{}, the sum of the half-lengths", figure(length)));
        let of_all = if directions.is_some() { "along these directions" } else { "around the points" };
        table.row("lower bound", format!("{}, for every zonotope {of_all}", lower_bound(bound)));
        // A quotient is rounded to nearest, and this bounds from above.
        let ratio = if length == bound { 1.0 } else { (length / bound).next_up() };
        let is_short = result["within_epsilon"].as_bool() == Some(false);
        let is_asked = |name: &str| question.field("input").is_some_and(|input| input.field(name).is_some());
        let above = match is_short {
            false => "",
            true if is_asked("objective") => "; the volume is what was made small",
            true if is_asked("max_generators") => "; the shortest found with so few generators",
            true => "; above 1 + epsilon: the search ended before",
        };
        let is_checked = match verdict {
            Verdict::Right(_) => ": proven, none is shorter by more",
            _ => ", which the answer states",
        };
        table.row("ratio", format!("{}, of length to lower bound{is_checked}{above}", factor_at_most(ratio)));
        if let Some(volume) = result["volume"].as_f64() {
            let minimum = match volume {
                0.0 => "the least that there is: the zonotope is flat",
                _ => "a local minimum: another zonotope may have less",
            };
            table.row("volume", format!("{}, {minimum}", figure(volume)));
        }
        let is_least_length = directions.is_none() && !is_asked("objective");
        for (label, text) in comparison::rows(points, body, is_least_length) {
            table.row(label, text);
        }
    } else {
        table.row("outcome", "no zonotope along these directions contains the points".to_owned());
    }
    let certificate = match verdict {
        Verdict::Right(proved) => format!("checked, exactly: {}", with_six_digits(&without_ratio(proved))),
        Verdict::Unchecked(reason) => format!("not all was checked: {}", with_six_digits(reason)),
        Verdict::Wrong(reason) => format!("WRONG: {reason}"),
    };
    table.row("certificate", certificate);
    table.row("method", answer["method"].as_str().unwrap_or_default().to_owned());
    table.row("verify", verification(options));
    table.text()
}

/// The sentence of the verifier on a length, which says in its own digits how far above the least it is at most: the
/// summary has a row for that.
fn without_ratio(proved: &str) -> String {
    let is_on_length = |clause: &str| clause.starts_with("length ") || clause.starts_with("value ");
    let told = |clause| if is_on_length(clause) { "length and lower bound" } else { clause };
    proved.split("; ").map(told).collect::<Vec<_>>().join("; ")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_ratio_has_one_place() {
        for (proved, shown) in [
            (
                "contains all 5 points; length 2.5, proven to be at most 1.00106 times the least; volume 5.2, not \
                 proven to be the least",
                "contains all 5 points; length and lower bound; volume 5.2, not proven to be the least",
            ),
            (
                "contains all 3 points; value 2.0 is within 3.8e-15 of the proven bound",
                "contains all 3 points; length and lower bound",
            ),
        ] {
            assert_eq!(without_ratio(proved), shown);
        }
    }
}
