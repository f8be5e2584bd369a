//! The summary for a person of a zonotope around all placements.

use serde_json::Value;
use zonotope::Zonotope;
use zonotope::numeric::dyadic::Dyadic;

use super::options::Options;
use crate::commands::asked::how_to_verify;
use crate::commands::motion::turn_in_words;
use crate::commands::placing::{describe, rounded_in_words};
use crate::commands::table::{Table, counted, figure, tuple, with_six_digits};
use crate::input::{Body, Placed};
use batch::Verdict;

/// More added generators than this are counted, not listed.
const LISTED_GENERATOR_LIMIT: usize = 6;

/// More generators than this have too many triples for an exact volume.
const MEASURED_GENERATOR_LIMIT: usize = 1_000;

/// The answer in a few lines.
pub(super) fn summary(
    options: &Options,
    placed: &Placed,
    (body, off): (&Body, f64),
    motion: &Value,
    volume: &Body,
    verdict: &Verdict,
) -> String {
    let mut table = Table::default();
    describe(&mut table, ["body", "pose"], placed, &options.file);
    if off > 0.0 {
        table.row("rounded", rounded_in_words(off));
    }
    table.row("motion", turn_in_words(motion));
    let count = counted(volume.generators.len(), "generator", "generators");
    table.row("answer", format!("{count}, centre {}", tuple(&volume.center)));
    table.row("added", added_in_words(&body.generators, volume.generators.clone()));
    table.row("volume", volume_in_words(body, volume));
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

/// The volume of the answer beside that of the body.
fn volume_in_words(body: &Body, volume: &Body) -> String {
    if volume.generators.len() > MEASURED_GENERATOR_LIMIT {
        return format!("not measured: that is done up to {MEASURED_GENERATOR_LIMIT} generators");
    }
    let [of_answer, of_body] = [volume, body].map(exact_volume);
    let shown = figure(of_answer.to_f64());
    if of_body.is_zero() {
        return format!("{shown}, while the body is flat");
    }
    format!("{shown}, {} times that of the body", figure(of_answer.ratio(&of_body)))
}

/// The volume of a body of space, whose numbers were read as finite.
fn exact_volume(body: &Body) -> Dyadic {
    let in_space = |v: &Vec<f64>| -> [f64; 3] { std::array::from_fn(|axis| v[axis]) };
    let generators = body.generators.iter().map(in_space).collect();
    Zonotope::new([0.0; 3], generators).map_or(Dyadic::zero(), |body| body.exact_volume())
}
