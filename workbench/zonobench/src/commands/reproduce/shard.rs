//! Runs in parts: the records of a shard as a file, and the outcome of all of them.

use std::fs;
use std::path::Path;

use anyhow::{Context, anyhow};
use experiments::environment::Environment;
use experiments::record::{CountRow, TimeRow};
use experiments::runner::{self, Records};
use experiments::sharing::Shard;
use serde::{Deserialize, Serialize};

use super::folder::Folder;
use super::options::Options;
use super::outcome;
use super::plan::{Plan, Request};
use crate::commands::shards::{Heading, Part, Place};
use crate::commands::{Ending, tell};
use crate::progress::RunProgress;

/// The kind of shards that have the records of a run.
pub(in crate::commands) const KIND: &str = "reproduce";

/// A line of a shard.
#[derive(Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
enum Line {
    /// The machine and the program that counted and timed.
    Environment(Environment),
    Count(CountRow),
    Time(TimeRow),
}

/// Counts and times the cases of a shard and writes its file, unless that is there.
pub(super) fn run(options: &Options, plan: &Plan, shard: Shard) -> anyhow::Result<Ending> {
    let place = Place::new(&options.out, KIND, shard);
    let heading = Heading::new(KIND, shard, plan.work());
    let is_there = !options.force && place.is_written(&heading)?;
    let scratch = place.scratch();
    if is_there {
        // A shard that was killed after its file was written leaves its folder behind.
        if scratch.exists() && Folder::claim(&scratch, false).is_ok() {
            removed(&scratch)?;
        }
        tell(&format!("{}: is there already", place.file().display()));
        return Ok(Ending::Good);
    }
    let folder = Folder::claim(&scratch, false)?;
    place.begin(&heading, options.force)?;
    let run = options.run_options(plan, &folder);
    let records = runner::run(&plan.selection.experiments, &run, &RunProgress::default())?;
    let counts = records.counts.into_iter().map(Line::Count);
    let times = records.times.into_iter().map(Line::Time);
    let lines = [Line::Environment(records.environment)].into_iter().chain(counts).chain(times);
    let lines = lines.map(|line| serde_json::to_string(&line)).collect::<Result<Vec<_>, _>>()?;
    place.write(&heading, &lines)?;
    removed(&scratch)?;
    drop(folder);
    tell(&format!("{}: {} lines", place.file().display(), lines.len()));
    Ok(Ending::Good)
}

fn removed(folder: &Path) -> anyhow::Result<()> {
    fs::remove_dir_all(folder).with_context(|| format!("{}: cannot be removed", folder.display()))
}

/// Puts the shards of a run together and writes the folder that one run writes.
pub(in crate::commands) fn merge(parts: Vec<Part>, out: &Path, force: bool) -> anyhow::Result<Ending> {
    let first = parts.first().map(|part| &part.heading).context("there are shards, since their reader found some")?;
    let request = Request::of_work(&first.work).ok_or_else(|| anyhow!("the shards name no run"))?;
    let plan = Plan::of(request)?;
    let here = Heading::new(KIND, first.shard()?, plan.work());
    first.check_same(&here).map_err(|difference| anyhow!("the shards are not of this program's run: {difference}"))?;
    let shards = parts.iter().map(records_of).collect::<anyhow::Result<Vec<_>>>()?;
    let folder = Folder::claim(out, force)?;
    let run = runner::RunOptions { directory: Some(folder.records()), ..plan.run_options() };
    let records = runner::put_together(&plan.selection.experiments, &run, shards)?;
    outcome::write(out, plan, folder, records)
}

fn records_of(part: &Part) -> anyhow::Result<Records> {
    let (mut counts, mut times, mut environment) = (Vec::new(), Vec::new(), None);
    for line in part.lines() {
        match serde_json::from_str(line).with_context(|| format!("{}: a line is no record", part.file.display()))? {
            Line::Environment(of_shard) => environment = Some(of_shard),
            Line::Count(row) => counts.push(row),
            Line::Time(row) => times.push(row),
        }
    }
    let environment = environment.with_context(|| format!("{}: names no machine", part.file.display()))?;
    Ok(Records { counts, times, environment, elsewhere: Vec::new() })
}
