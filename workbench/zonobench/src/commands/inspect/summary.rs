//! The summary for a person of a body.

use serde_json::Value;
use zonotope::numeric::Rational;
use zonotope::numeric::dyadic::Dyadic;

use super::measures::Measures;
use super::options::Options;
use crate::commands::asked::how_to_verify;
use crate::commands::placing::{in_words, rounded_in_words};
use crate::commands::table::{ROUNDED, Table, at_least, at_most, counted, figure, in_full, position};
use crate::input::Placed;
use batch::Verdict;

/// Exact numbers longer than this are rounded.
const EXACT_DIGIT_LIMIT: usize = 40;

/// The part of its width by which an interval may grow where it is rounded.
const HIDDEN_WIDTH: f64 = 1e-3;

/// Counts and sizes in a few lines.
pub(super) fn summary(
    options: &Options,
    (placed, off): (&Placed, f64),
    measures: &Measures,
    answer: &Value,
    verdict: &Verdict,
) -> String {
    let mut table = Table::default();
    let body = &placed.body;
    let dimension = body.center.len();
    table.row(
        "body",
        format!(
            "{} in {}{}",
            counted(body.generators.len(), "generator", "generators"),
            options.file.display(),
            if body.is_rounded { ROUNDED } else { "" }
        ),
    );
    let mut zones = counted(measures.directions, "direction", "directions");
    let parallel = body.generators.len() - measures.zeros - measures.directions;
    if parallel > 0 {
        zones.push_str(&format!(", {parallel} parallel to others"));
    }
    if measures.zeros > 0 {
        zones.push_str(&format!(", {} zero", measures.zeros));
    }
    table.row("generators", zones);
    let (center, is_exact) = placed.center();
    table.row("centre", format!("{}{}", position(&center, placed.reach()), if is_exact { "" } else { ", rounded" }));
    if let Some(pose) = &placed.pose {
        table.row("pose", in_words(pose));
    }
    if off > 0.0 {
        table.row("rounded", format!("lengths, areas, vertices, meshes: {}", rounded_in_words(off)));
    }
    let bounds = measures.bounds.iter().map(|&[low, high]| interval(low, high));
    table.row("bounding box", bounds.collect::<Vec<_>>().join(" × "));
    table.row("total length", format!("{}, the sum of the half-lengths", figure(measures.total_length)));

    let result = &answer["result"];
    if let Some(rank) = result["affine_dim"].as_u64() {
        let kind = match (rank, dimension as u64) {
            (rank, full) if rank == full => String::new(),
            (0, _) => ": a point".to_owned(),
            (1, _) => ": a segment".to_owned(),
            (2, _) => ": a flat zonogon".to_owned(),
            _ => ": flat".to_owned(),
        };
        table.row("dimension", format!("{rank} in {dimension}{kind}"));
        let number = |name: &str| result[name].as_u64().unwrap_or_default();
        table.row(
            "faces",
            format!("{} vertices, {} edges, {} facets", number("vertices"), number("edges"), number("facets")),
        );
        let sizes = result["facet_sizes"].as_object().into_iter().flatten();
        let sizes: Vec<String> = sizes.map(|(size, count)| format!("{count} with {size} vertices")).collect();
        if rank > 2 {
            table.row("facets", sizes.join(", "));
        }
        let name = ["length", "area", "volume"].get(dimension - 1).copied().unwrap_or("measure");
        table.row(name, measure(result["measure"].as_str().unwrap_or_default()));
    } else {
        let reason = answer["error"]["message"].as_str().unwrap_or_default();
        table.row("faces", format!("not counted: {reason}"));
    }
    if let Some(area) = measures.surface_area {
        table.row("surface", format!("{}, rounded", figure(area)));
    }
    table.row(
        "check",
        match verdict {
            Verdict::Right(proved) => proved.clone(),
            Verdict::Unchecked(_) if answer.get("error").is_some() => "no faces, nothing to check".to_owned(),
            Verdict::Unchecked(reason) => format!("not all was checked: {reason}"),
            Verdict::Wrong(reason) => format!("WRONG: {reason}"),
        },
    );
    table.row("verify", how_to_verify(&[&options.file], options.question.as_ref(), options.json.as_ref()));
    table.text()
}

/// An exact number, as it stands if it is short.
fn measure(exact: &str) -> String {
    let Ok(number) = exact.parse::<Rational>() else {
        return exact.to_owned();
    };
    let (numerator, denominator) = number.into_parts();
    let (numerator, denominator) = (Dyadic::new(numerator, 0), Dyadic::new(denominator.into(), 0));
    let shown = figure(numerator.ratio(&denominator));
    let is_exact = shown.parse().is_ok_and(|shown| &Dyadic::from_f64(shown) * &denominator == numerator);
    match (exact.len() <= EXACT_DIGIT_LIMIT, is_exact) {
        (true, true) => format!("{exact} = {shown}"),
        (true, false) => format!("{exact}, about {shown}"),
        (false, _) => format!("{shown}, rounded"),
    }
}

/// An interval, rounded outwards; in full where six digits would hide how wide it is.
fn interval(low: f64, high: f64) -> String {
    let shown = [at_least(low), at_most(high)];
    let [from, to] = shown.each_ref().map(|end| end.parse::<f64>().unwrap_or(f64::NAN));
    let is_close = (to - from) - (high - low) <= HIDDEN_WIDTH * (high - low);
    if is_close { format!("[{}, {}]", shown[0], shown[1]) } else { format!("[{}, {}]", in_full(low), in_full(high)) }
}
