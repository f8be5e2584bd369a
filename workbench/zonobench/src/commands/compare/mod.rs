//! `zonobench compare`: what two runs of `reproduce` recorded, side by side. Counts, values and answers are the same on
//! every machine, so a difference is a change of the program; times are told as ratios, which are no verdicts: they
//! depend on what else the machines did. A line for an experiment sums its cases up, unless all of them are asked for.

mod counts;
mod machines;
mod times;

use std::fmt::Write as _;
use std::path::PathBuf;

use clap::Args;

use self::counts::Comparison;
use super::Ending;
use super::records::RunRecords;
use super::table::{Table, counted};
use crate::standard_output::StandardOutput;

/// Options of `compare`.
#[derive(Debug, Args)]
pub struct Options {
    /// The folder of a run: one that `reproduce --out` names.
    first: PathBuf,
    /// The folder of another run.
    second: PathBuf,
    /// Tell every case that differs, and the times of every method and case.
    #[arg(long)]
    all: bool,
}

/// Experiments with a line of their own, of those whose counts differ and of those whose times do.
const LINES: usize = 10;

/// Reads the records of both runs, and tells where counts differ and how times compare. The ending is bad if counts,
/// values or answers of a case differ, if it has other seeds, or if no case is in both runs.
pub fn run(options: &Options) -> anyhow::Result<Ending> {
    let [first, second] = [RunRecords::read(&options.first)?, RunRecords::read(&options.second)?];
    let comparison = Comparison::of(&first.counts, &second.counts);
    let mut text = summary(options, [&first, &second], &comparison);
    let (head, lines) = times::text(&first.times, &second.times, options.all);
    text.push_str(&head);
    add_lines(&mut text, &lines, options.all);
    StandardOutput::print(text.as_bytes())?;
    let is_same = comparison.differences.is_empty() && comparison.reseeded == 0;
    Ok(if is_same && comparison.common > 0 { Ending::Good } else { Ending::Bad })
}

/// The comparison of the counts of both runs.
fn summary(options: &Options, records: [&RunRecords; 2], comparison: &Comparison) -> String {
    let Comparison { common, reseeded, alone, differences, .. } = comparison;
    let runs = records.map(|records| records.run.as_ref());
    let mut table = Table::default();
    table.row("first", options.first.display().to_string());
    table.row("second", options.second.display().to_string());
    if let [Some(first), Some(second)] = runs {
        if first.seed != second.seed {
            table.row("seeds", format!("{} and {}: random inputs are not the same", first.seed, second.seed));
        }
        if first.profile != second.profile {
            let [first, second] = [&first.profile, &second.profile];
            table.row("profiles", format!("{first} and {second}: sizes and numbers of instances are not the same"));
        }
    }
    machines::add_to(&mut table, records.map(|records| records.environment.as_ref()));
    let [in_first, in_second] = alone;
    let cases = counted(*common, "case", "cases");
    table.row(
        "compared",
        format!("{cases} in both runs, {in_first} in the first alone, {in_second} in the second alone"),
    );
    let cases = counted(differences.len(), "case differs", "cases differ");
    let others = match reseeded {
        0 => String::new(),
        all if all == common => String::new(),
        some => format!("; {} not compared, of other seeds", counted(*some, "case is", "cases are")),
    };
    table.row(
        "counts",
        match (differences.len(), common) {
            (_, 0) => "no case is in both runs".to_owned(),
            (_, common) if reseeded == common => "not compared: all cases have other seeds".to_owned(),
            (0, _) => "the same, values and answers as well".to_owned(),
            _ => cases,
        } + &others,
    );
    let mut text = table.text();
    let lines: Vec<String> = if options.all {
        differences.iter().map(ToString::to_string).collect()
    } else {
        comparison.by_experiment().iter().map(ToString::to_string).collect()
    };
    add_lines(&mut text, &lines, options.all);
    text
}

/// Adds all lines, or the first ones and how many experiments have none.
fn add_lines(text: &mut String, lines: &[String], are_all: bool) {
    let shown = if are_all { lines.len() } else { LINES };
    for line in lines.iter().take(shown) {
        writeln!(text, "{line}").expect("writing to a string does not fail");
    }
    if let Some(more) = lines.len().checked_sub(shown).filter(|more| *more > 0) {
        let experiments = counted(more, "experiment", "experiments");
        writeln!(text, "  and {experiments} more; --all tells every case").expect("writing to a string does not fail");
    }
}
