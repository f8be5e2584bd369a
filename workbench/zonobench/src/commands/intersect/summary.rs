//! The summary for a person of an intersection.

use super::meeting::{Meeting, Proof};
use super::options::Options;
use crate::commands::asked::how_to_verify;
use crate::commands::placing::{describe, smaller_reach};
use crate::commands::table::{Table, at_least, figure, position, tuple, with_six_digits};
use crate::input::Body;
use batch::Verdict;

/// The number of terms of a point that are written out; further ones are counted.
const WRITTEN_TERM_LIMIT: usize = 6;

/// The answer with its proof in a few lines.
pub(super) fn summary(options: &Options, meeting: &Meeting, verdict: &Verdict) -> String {
    let mut table = Table::default();
    describe(&mut table, ["a", "pose of a"], &meeting.placed[0], &options.a);
    describe(&mut table, ["b", "pose of b"], &meeting.placed[1], &options.b);
    table.row("dimension", meeting.dimension().to_string());
    let answer = match meeting.status.as_str() {
        "inside" => "a and b overlap: their interiors meet",
        "boundary" => "a and b touch: they have a point in common, but not in the interiors",
        _ => "a and b are disjoint",
    };
    table.row("answer", answer.to_owned());
    match &meeting.proof {
        Proof::Gap(gap) => {
            table.row(
                "gap",
                format!("{}, between two parallel planes; the bodies are at least so far apart", at_least(gap.width)),
            );
            table.row("direction", format!("{}, the unit normal of the planes, rounded", tuple(&gap.direction)));
            table.row(
                "proof",
                format!(
                    "the centres are {} apart in this direction, a and b reach {} together",
                    figure(gap.centers),
                    figure(gap.reach)
                ),
            );
        }
        Proof::Common { coefficients, point } => {
            let split = meeting.bodies[0].generators.len();
            table.row("common point", format!("{}, rounded", position(point, smaller_reach(&meeting.placed))));
            table.row("in a", combination("a", 1.0, &meeting.bodies[0], &coefficients[..split]));
            table.row("in b", combination("b", -1.0, &meeting.bodies[1], &coefficients[split..]));
        }
    }
    if let Some(value) = meeting.gauge {
        let of_rounded = if meeting.is_exact { "" } else { ", of the bodies under their poses as doubles hold them" };
        table.row("gauge", format!("{}{of_rounded}", gauge(meeting, value)));
    }
    table.row(
        "certificate",
        match verdict {
            Verdict::Right(proved) => format!("checked: {}", with_six_digits(proved)),
            Verdict::Unchecked(reason) => format!("not all was checked: {reason}"),
            Verdict::Wrong(reason) => format!("WRONG: {reason}"),
        },
    );
    table.row("method", meeting.asked.answer["method"].as_str().unwrap_or_default().to_owned());
    table.row("verify", how_to_verify(&[&options.a, &options.b], options.question.as_ref(), options.json.as_ref()));
    table.text()
}

/// centre + Σ ± δ_i generator_i, the longest terms first to be left out.
fn combination(name: &str, sign: f64, body: &Body, coefficients: &[f64]) -> String {
    let mut text = format!("centre of {name}");
    for (index, delta) in (1..).zip(coefficients).take(WRITTEN_TERM_LIMIT) {
        let delta = sign * delta;
        let written =
            if delta < 0.0 { format!(" − {}", figure(-delta)) } else { format!(" + {}", figure(delta + 0.0)) };
        text.push_str(&format!("{written} {name}{index}"));
    }
    let left_out = body.generators.len().saturating_sub(WRITTEN_TERM_LIMIT);
    if left_out > 0 {
        text.push_str(&format!(" + … ({left_out} more terms)"));
    }
    text
}

fn gauge(meeting: &Meeting, gauge: f64) -> String {
    let meaning = if gauge == f64::INFINITY {
        "no growth about the centres makes them meet".to_owned()
    } else if gauge == 0.0 {
        "the centres coincide".to_owned()
    } else if meeting.status == "inside" {
        let free = meeting.distance() * (1.0 / gauge - 1.0);
        format!(
            "taken so many times about their centres they would only touch; so would b moved away by {}",
            figure(free)
        )
    } else {
        "taken so many times about their centres they touch".to_owned()
    };
    let value = if gauge == f64::INFINITY { "infinite".to_owned() } else { figure(gauge) };
    format!("{value}: {meaning}")
}
