//! `zonobench compare`: what two runs of `reproduce` recorded, side by side. Counts, values and answers are the same on
//! every machine, so a difference is a change of the program; times are told as ratios.

mod counts;
mod times;

use std::fmt::Write as _;
use std::io::{self, Write as _};
use std::path::PathBuf;

use clap::Args;

use self::counts::Comparison;
use super::Ending;
use super::records::RunRecords;
use super::table::{Table, counted};

/// Options of `compare`.
#[derive(Debug, Args)]
pub struct Options {
    /// The folder of a run: one that `reproduce --out` names.
    first: PathBuf,
    /// The folder of another run.
    second: PathBuf,
}

/// Reads the records of both runs, and tells where counts differ and how times compare. The ending is bad if counts,
/// values or answers of a case differ, or no case is in both runs.
pub fn run(options: &Options) -> anyhow::Result<Ending> {
    let [first, second] = [RunRecords::read(&options.first)?, RunRecords::read(&options.second)?];
    let comparison = Comparison::of(&first.counts, &second.counts);
    let mut text = summary(options, &comparison);
    text.push_str(&times::text(&first.times, &second.times));
    io::stdout().lock().write_all(text.as_bytes())?;
    Ok(if comparison.differences.is_empty() && comparison.common > 0 { Ending::Good } else { Ending::Bad })
}

/// What the counts of both runs say.
fn summary(options: &Options, comparison: &Comparison) -> String {
    let Comparison { common, alone, differences } = comparison;
    let mut table = Table::default();
    table.row("first", options.first.display().to_string());
    table.row("second", options.second.display().to_string());
    let [in_first, in_second] = alone;
    let cases = counted(*common, "case", "cases");
    table.row(
        "compared",
        format!("{cases} in both runs, {in_first} in the first alone, {in_second} in the second alone"),
    );
    let cases = counted(differences.len(), "case differs", "cases differ");
    table.row(
        "counts",
        match (differences.len(), common) {
            (0, 0) => "no case is in both runs".to_owned(),
            (0, _) => "the same, values and answers as well".to_owned(),
            _ => cases,
        },
    );
    let mut text = table.text();
    for difference in differences {
        writeln!(text, "{difference}").expect("writing to a string does not fail");
    }
    text
}
