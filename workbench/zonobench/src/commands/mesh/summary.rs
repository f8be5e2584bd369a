//! The answer on the screen.

use std::path::Path;

use super::super::asked::{Asked, float};
use super::super::table::{Table, at_least, at_most, counted};
use super::options::Options;
use super::reading::Read;
use batch::Verdict;

pub(super) fn summary(options: &Options, meshes: [(&Path, &Read); 2], asked: &Asked, verdict: &Verdict) -> String {
    let result = asked.result();
    let mut table = Table::default();
    for (label, (file, mesh)) in ["a", "b"].into_iter().zip(meshes) {
        table.row(label, of_mesh(file, mesh));
    }
    if result["intersects"] == true {
        let at = |index: usize| result["witness"][index].as_u64().map_or_else(String::new, |at| (at + 1).to_string());
        table.row("meshes", format!("meet: triangle {} of a and triangle {} of b have a common point", at(0), at(1)));
    } else {
        table.row("meshes", "are disjoint".to_owned());
    }
    if let Some(pairs) = result["pairs"].as_array() {
        table.row("pairs", format!("{} of triangles meet", counted(pairs.len(), "pair", "pairs")));
    }
    if let Some(distance) = result.get("distance") {
        let [lower, upper] = ["lower", "upper"].map(|bound| float(&distance[bound]));
        table.row("distance", format!("between {} and {}", at_least(lower), at_most(upper)));
    }
    ending(&mut table, options, asked, verdict);
    table.text()
}

/// A mesh in words.
pub(super) fn of_mesh(file: &Path, mesh: &Read) -> String {
    let triangles = counted(mesh.triangles, "triangle", "triangles");
    format!("{triangles}, {} in {}", counted(mesh.vertices, "vertex", "vertices"), file.display())
}

/// The verdict, the volume, and how to check again.
pub(super) fn ending(table: &mut Table, options: &Options, asked: &Asked, verdict: &Verdict) {
    table.row(
        "check",
        match verdict {
            Verdict::Right(proved) => format!("checked: {proved}"),
            Verdict::Unchecked(reason) => format!("not all was checked: {reason}"),
            Verdict::Wrong(reason) => format!("WRONG: {reason}"),
        },
    );
    table.row("volume", asked.answer["method"].as_str().unwrap_or_default().to_owned());
    let verify = match (&options.question, &options.json) {
        (Some(question), Some(answer)) => format!("zonobench verify {} {}", question.display(), answer.display()),
        _ => "--question Q --json A write question and answer; zonobench verify Q A checks them".to_owned(),
    };
    table.row("verify", verify);
}
