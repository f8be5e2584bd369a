//! The summary for a person of a first contact.

use serde_json::Value;

use super::of_meshes::Posed;
use super::options::Options;
use crate::commands::asked::{Asked, float, floats, how_to_verify};
use crate::commands::motion::turn_in_words;
use crate::commands::placing::{describe, in_words as pose_in_words, rounded_in_words};
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
    let mut table = Table::default();
    describe(&mut table, ["a", "pose of a"], &bodies[0], &options.a);
    add_rounding(&mut table, "a, rounded", &rounded[0]);
    table.row("motion of a", in_words(&motion["a"]));
    describe(&mut table, ["b", "pose of b"], &bodies[1], &options.b);
    add_rounding(&mut table, "b, rounded", &rounded[1]);
    table.row("motion of b", in_words(&motion["b"]));
    add_answer(&mut table, options, asked, verdict);
    table.text()
}

/// The same of two meshes.
pub(super) fn of_meshes(
    options: &Options,
    meshes: &[Posed; 2],
    motion: &Value,
    asked: &Asked,
    verdict: &Verdict,
) -> String {
    let mut table = Table::default();
    for ((name, file), Posed { mesh, pose }) in [("a", &options.a), ("b", &options.b)].into_iter().zip(meshes) {
        let triangles = counted(mesh.triangles as u64, "triangle", "triangles");
        let vertices = counted(mesh.vertices as u64, "vertex", "vertices");
        table.row(name, format!("{triangles}, {vertices} in {}", file.display()));
        if let Some(pose) = pose {
            let taken = "each vertex is taken in the doubles nearest to its image";
            table.row(&format!("pose of {name}"), format!("{}; {taken}", pose_in_words(pose)));
        }
        table.row(&format!("motion of {name}"), in_words(&motion[name]));
    }
    add_answer(&mut table, options, asked, verdict);
    table.text()
}

/// The rows on the answer, its proof and its check.
fn add_answer(table: &mut Table, options: &Options, asked: &Asked, verdict: &Verdict) {
    let result = asked.result();
    let time = floats(&result["time"]);
    let status = result["status"].as_str().unwrap_or_default();
    table.row("answer", answer(status, &time));
    if let [from, to] = time[..] {
        table.row("time", format!("between {} and {} of the step", in_full(from), in_full(to)));
    }
    let at = |i: usize| result["triangles"][i].as_u64().map(|at| at + 1);
    if let [Some(i), Some(j)] = [at(0), at(1)] {
        let told = if status == "contact" { "meet at the later of these times" } else { "are those in doubt" };
        table.row("triangles", format!("{i} of a and {j} of b {told}"));
    }
    if result.get("distance_at_most").is_some() {
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
    let of = if certificate.get("order").is_some() { " parts of the meshes" } else { "" };
    let count = counted(intervals.len() as u64, "interval of time", "intervals of time");
    format!("{count} with a direction that separates{of} at every time: {}", told.join(", "))
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
