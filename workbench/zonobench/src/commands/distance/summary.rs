//! The summary for a person of a distance.

use super::options::Options;
use crate::commands::asked::{Asked, float, floats, how_to_verify};
use crate::commands::placing::{describe, smaller_reach};
use crate::commands::table::{Table, at_least, at_most, figure, position, tuple, with_six_digits};
use crate::input::Placed;
use batch::Verdict;

/// The distance or the depth, with where it is, in a few lines.
pub(super) fn summary(options: &Options, bodies: &[Placed; 2], asked: &Asked, verdict: &Verdict) -> String {
    let result = asked.result();
    let mut table = Table::default();
    describe(&mut table, ["a", "pose of a"], &bodies[0], &options.a);
    describe(&mut table, ["b", "pose of b"], &bodies[1], &options.b);
    let answer = match result["status"].as_str().unwrap_or_default() {
        "inside" => "a and b overlap: their interiors meet",
        "boundary" => "a and b touch: they have a point in common, but not in the interiors",
        _ => "a and b are disjoint",
    };
    table.row("answer", answer.to_owned());
    let distance = float(&result["distance"]);
    table.row("distance", figure(distance));
    let size = smaller_reach(bodies);
    let point = |body: &str| position(&floats(&result["nearest"][body]), size);
    let feature = |body: &str| result["features"][body].as_str().unwrap_or_default().to_owned();
    if result["status"] == "outside" {
        table.row("nearest in a", format!("{}, on a face: {}", point("a"), feature("a")));
        table.row("nearest in b", format!("{}, on a face: {}", point("b"), feature("b")));
    } else {
        table.row("common point", format!("{}, rounded", point("a")));
    }
    if result["status"] == "boundary" {
        table.row("they touch", format!("a: {}, b: {}", feature("a"), feature("b")));
    }
    if result["status"] == "inside" {
        let depth = &result["penetration"];
        let (lower, upper) = (float(&depth["lower"]), float(&depth["upper"]));
        table.row(
            "depth",
            format!("between {} and {}: so far b is to be moved at least", at_least(lower), at_most(upper)),
        );
        table.row("direction", format!("{}, of any length", tuple(&floats(&depth["direction"]))));
    }
    table.row(
        "certificate",
        match verdict {
            Verdict::Right(proved) => format!("checked: {}", with_six_digits(proved)),
            Verdict::Unchecked(reason) => format!("not all was checked: {reason}"),
            Verdict::Wrong(reason) => format!("WRONG: {reason}"),
        },
    );
    table.row("method", asked.answer["method"].as_str().unwrap_or_default().to_owned());
    table.row("verify", how_to_verify(&[&options.a, &options.b], options.question.as_ref(), options.json.as_ref()));
    table.text()
}
