//! The summary for a person of a first contact.

use serde_json::Value;

use super::options::Options;
use crate::commands::asked::{Asked, float, floats, how_to_verify};
use crate::commands::motion::turn_in_words;
use crate::commands::placing::{describe, rounded_in_words};
use crate::commands::table::{Table, at_most, counted, in_full, tuple, with_six_digits};
use crate::input::{Placed, RoundedBody};
use batch::Verdict;

/// The answer with its proof in a few lines.
pub(super) fn summary(
    options: &Options,
    (bodies, rounded): (&[Placed; 2], &[RoundedBody; 2]),
    motion: &Value,
    asked: &Asked,
    verdict: &Verdict,
) -> String {
    let result = asked.result();
    let mut table = Table::default();
    describe(&mut table, ["a", "pose of a"], &bodies[0], &options.a);
    add_rounding(&mut table, "a, rounded", &rounded[0]);
    table.row("motion of a", in_words(&motion["a"]));
    describe(&mut table, ["b", "pose of b"], &bodies[1], &options.b);
    add_rounding(&mut table, "b, rounded", &rounded[1]);
    table.row("motion of b", in_words(&motion["b"]));
    let time = floats(&result["time"]);
    let status = result["status"].as_str().unwrap_or_default();
    table.row("answer", answer(status, &time));
    if let [from, to] = time[..] {
        table.row("time", format!("between {} and {} of the step", in_full(from), in_full(to)));
    }
    if status == "grazing" {
        let distance = float(&result["distance_at_most"]);
        table.row("distance", format!("at most {} at the later of these times", at_most(distance)));
    }
    table.row("proof", proof(&result["certificate"]));
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

/// The row on a body whose image was rounded.
fn add_rounding(table: &mut Table, name: &str, rounded: &RoundedBody) {
    if rounded.off > 0.0 {
        table.row(name, rounded_in_words(rounded.off));
    }
}

fn answer(status: &str, time: &[f64]) -> String {
    match status {
        "separate" => "a and b are disjoint during the whole step".to_owned(),
        "contact" if time == [0.0, 0.0] => "a and b meet at the start".to_owned(),
        "contact" => "a and b meet, and are disjoint before".to_owned(),
        _ => {
            "grazing: a and b are disjoint before, and from then on neither a meeting nor that there is none is proved"
                .to_owned()
        }
    }
}

/// The intervals without contact, by the frames of their directions.
fn proof(certificate: &Value) -> String {
    let intervals = certificate["intervals"].as_array().map_or(&[][..], Vec::as_slice);
    if intervals.is_empty() {
        return "no interval without contact".to_owned();
    }
    let frames = [
        ("space", "fixed in space"),
        ("a", "turning with a"),
        ("b", "turning with b"),
        ("edges", "normal to two edges"),
    ];
    let told = frames.iter().filter_map(|(frame, words)| {
        let count = intervals.iter().filter(|interval| interval["frame"] == *frame).count();
        (count > 0).then(|| format!("{count} {words}"))
    });
    let told: Vec<String> = told.collect();
    let count = counted(intervals.len() as u64, "interval of time", "intervals of time");
    format!("{count} with a direction that separates at every time: {}", told.join(", "))
}

/// A motion in words.
fn in_words(motion: &Value) -> String {
    if motion.is_null() {
        return "none: it rests".to_owned();
    }
    let moved = |motion: &Value| format!("translation {}", tuple(&floats(&motion["translation"])));
    match motion["pieces"].as_array() {
        Some(pieces) => {
            let count = counted(pieces.len() as u64, "piece", "pieces");
            match &pieces[..] {
                [piece] if piece["from"] == piece["to"] => moved(piece),
                _ => format!("{count} with quaternions that go linearly"),
            }
        }
        None => format!("{}, at constant rate", turn_in_words(motion)),
    }
}
