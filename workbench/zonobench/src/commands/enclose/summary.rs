//! The summary for a person of an answer.

use std::path::PathBuf;

use zonotope::enclosing::min_area_zonogon::exact::ExactZonogon;

use super::options::Options;
use crate::commands::table::{Table, counted, figure, lower_bound, position};
use crate::enclosure::Enclosure;
use crate::input::Reading;
use verifier::MinAreaProof;

/// The answer in a few lines.
pub(super) fn summary(
    options: &Options,
    reading: &Reading,
    enclosure: &Enclosure,
    proof: Result<&MinAreaProof, &String>,
    exact: Option<&ExactZonogon>,
) -> String {
    let found = &enclosure.found;
    let (hull_area, ratio) = enclosure.hull_area_and_ratio();
    let along = |axis: usize| found.body.generators().iter().map(|generator| generator[axis].abs()).sum::<f64>();
    let reach = along(0).max(along(1));
    let mut lines: Vec<(&str, String)> =
        vec![("points", format!("{} in {}", reading.points.len(), options.file.display()))];
    lines.extend(reading.in_words().map(|columns| ("columns", columns)));
    lines.extend([
        (
            "hull",
            format!("{}, area {}", counted(found.proof.hull().vertex_count(), "vertex", "vertices"), figure(hull_area)),
        ),
        ("centre", position(&found.body.center(), reach)),
        ("zonogon", counted(found.body.generators().len(), "generator", "generators")),
        (
            "area",
            format!(
                "{}{}",
                figure(found.value),
                ratio.map_or(String::new(), |ratio| format!(", {ratio:.6} times the hull's"))
            ),
        ),
        ("lower bound", lower_bound(found.lower_bound)),
    ]);
    match proof {
        Ok(proof) => {
            let gap = if found.proof.hull().has_area() {
                format!("at most {:.1e}: no enclosing zonogon is smaller by more", proof.gap.max(0.0))
            } else {
                "the points lie on a line, so the least area is 0; anything above it is outward rounding".to_owned()
            };
            lines.push(("relative gap", gap));
            lines
                .push(("certificate", "checked: exact containment of every point, exact area, exact bound".to_owned()));
        }
        Err(reason) => lines.push(("certificate", format!("WRONG: {reason}"))),
    }
    let uniqueness = match (found.proof.hull().has_area(), found.proof.face_dimension()) {
        (_, 0) => "unique: no other centre gives this area",
        (true, 1) => "not unique: the optimal centres form a segment",
        (true, _) => "not unique: the optimal centres form a polygon",
        (false, 1) => "not unique: every centre on the line of the points gives area 0",
        (false, _) => "not unique: every centre gives area 0",
    };
    lines.push(("optimum", uniqueness.to_owned()));
    if let Some(exact) = exact {
        lines.push(("exact centre", format!("({}, {})", exact.center[0], exact.center[1])));
        lines.push(("exact area", exact.area.to_string()));
    }
    lines.push(("method", enclosure.method.id().to_owned()));
    lines.push(("verify", verification(options)));

    let mut table = Table::default();
    for (label, value) in lines {
        table.row(label, value);
    }
    table.text()
}

/// The command that checks the written answer, or how to get one.
pub(super) fn verification(options: &Options) -> String {
    // Standard input can be read once, so that the points and the answer cannot both come from there.
    let is_checkable = |answer: &&PathBuf| **answer != options.file || answer.as_os_str() != "-";
    match options.json.as_ref().filter(is_checkable) {
        None => "--json FILE writes the answer; zonobench verify checks it against the points".to_owned(),
        Some(answer) => {
            // A name tells the format again and the answer records the rest; standard input has no name.
            let is_nameless = options.file.as_os_str() == "-";
            let format = options.asking.points.format.filter(|_| is_nameless);
            let words = format.map_or(String::new(), |format| format!(" --format {format}"));
            format!("zonobench verify {} {}{words}", options.file.display(), answer.display())
        }
    }
}
