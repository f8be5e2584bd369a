//! `zonobench reproduce`: every experiment, figure and claim, and the report of them.

mod config;
mod folder;
mod options;
mod outcome;
mod own_plots;
mod plan;
mod selection;
mod shard;

use experiments::runner;

pub use self::options::Options;

use self::folder::Folder;
use self::plan::Plan;
pub(super) use self::shard::{KIND, merge};
use super::Ending;
use crate::progress::RunProgress;

/// Runs everything and writes the folder; the manifest comes last, so a folder with a manifest is complete.
pub fn run(options: &Options) -> anyhow::Result<Ending> {
    let plan = Plan::of(options.request())?;
    if let Some(shard) = options.shard {
        return shard::run(options, &plan, shard);
    }
    let folder = Folder::claim(&options.out, options.force)?;
    let run = options.run_options(&plan, &folder);
    let records = runner::run(&plan.selection.experiments, &run, &RunProgress::default())?;
    outcome::write(&options.out, plan, folder, records)
}
