//! The summary for a person of a zonotope around all placements.

use serde_json::Value;

use super::options::Options;
use crate::commands::asked::{Asked, floats, how_to_verify};
use crate::commands::motion::turn_in_words;
use crate::commands::placing::{describe, rounded_in_words};
use crate::commands::table::{Table, counted, tuple, with_six_digits};
use crate::input::{Body, Placed};
use batch::Verdict;

/// More added generators than this are counted, not listed.
const LISTED_GENERATOR_LIMIT: usize = 6;

/// The answer in a few lines.
pub(super) fn summary(
    options: &Options,
    placed: &Placed,
    (body, off): (&Body, f64),
    motion: &Value,
    asked: &Asked,
    verdict: &Verdict,
) -> String {
    let result = asked.result();
    let generators: Vec<Vec<f64>> = result["generators"].as_array().into_iter().flatten().map(floats).collect();
    let mut table = Table::default();
    describe(&mut table, ["body", "pose"], placed, &options.file);
    if off > 0.0 {
        table.row("rounded", rounded_in_words(off));
    }
    table.row("motion", turn_in_words(motion));
    let count = counted(generators.len(), "generator", "generators");
    table.row("answer", format!("{count}, centre {}", tuple(&floats(&result["center"]))));
    table.row("added", added_in_words(&body.generators, generators));
    table.row(
        "certificate",
        match verdict {
            Verdict::Right(proved) => format!("checked: {}", with_six_digits(proved)),
            Verdict::Unchecked(reason) => format!("not all was checked: {reason}"),
            Verdict::Wrong(reason) => format!("WRONG: {reason}"),
        },
    );
    table.row("method", options.method.clone());
    table.row("verify", how_to_verify(&[&options.file], options.question.as_ref(), options.json.as_ref()));
    table.text()
}

/// The generators of the answer that the body does not have.
fn added_in_words(own: &[Vec<f64>], mut generators: Vec<Vec<f64>>) -> String {
    let mut kept: Vec<&Vec<f64>> = own.iter().collect();
    generators.retain(|generator| match kept.iter().position(|own| *own == generator) {
        Some(index) => {
            kept.swap_remove(index);
            false
        }
        None => true,
    });
    let count = counted(generators.len(), "generator", "generators");
    if generators.is_empty() || generators.len() > LISTED_GENERATOR_LIMIT {
        return count;
    }
    format!("{count}: {}", generators.iter().map(|generator| tuple(generator)).collect::<Vec<_>>().join(", "))
}
