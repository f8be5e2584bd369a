//! The options of `reproduce`.

use std::path::PathBuf;

use clap::{Args, ValueEnum};
use experiments::definition::Profile;
use experiments::runner::RunOptions;
use experiments::sharing::Shard;

use super::folder::Folder;
use super::plan::{Plan, Request};
use crate::report::USUAL_SEED;

/// Options of `reproduce`.
#[derive(Debug, Args)]
pub struct Options {
    /// The profile: a few minutes, or everything up to the largest sizes.
    #[arg(long, value_enum, default_value_t = Extent::Quick)]
    pub(super) profile: Extent,
    /// The folder for the report and all that belongs to it.
    #[arg(long, value_name = "DIR", default_value = "out/reproduce")]
    pub(super) out: PathBuf,
    /// The seed of all random numbers.
    #[arg(long, default_value_t = USUAL_SEED)]
    pub(super) seed: u64,
    /// Threads for counting; all processors if absent.
    ///
    /// Times are taken on one.
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=1024))]
    pub(super) threads: Option<u16>,
    /// Run these experiments alone, or those that these figures show; `list` names them.
    ///
    /// Their figures are drawn and the claims checked that rest on nothing else.
    #[arg(long, value_name = "ID", num_args = 1..)]
    pub(super) only: Vec<String>,
    /// Run the experiments of a TOML file alone, as it changes them, and plot them.
    ///
    /// The file has families, sizes, variants and own files as inputs.
    #[arg(long, value_name = "FILE", conflicts_with = "only")]
    pub(super) config: Option<PathBuf>,
    /// Count and time the part I of N alone, from 0/N on; `merge` puts the parts together.
    ///
    /// The part is written into the folder as a file.
    /// A part that is there already is left as it is, and one that was interrupted is gone on with.
    #[arg(long, value_name = "I/N")]
    pub(super) shard: Option<Shard>,
    /// Write into the folder although it holds something.
    #[arg(long)]
    pub(super) force: bool,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(super) enum Extent {
    Quick,
    Full,
}

impl From<Extent> for Profile {
    fn from(extent: Extent) -> Self {
        match extent {
            Extent::Quick => Self::Quick,
            Extent::Full => Self::Full,
        }
    }
}

impl Options {
    /// The run, apart from who does it and where it is written.
    pub(super) fn request(&self) -> Request {
        let (profile, seed) = (self.profile.into(), self.seed);
        Request { profile, seed, only: self.only.clone(), config: self.config.clone() }
    }

    pub(super) fn run_options(&self, plan: &Plan, folder: &Folder) -> RunOptions {
        RunOptions {
            threads: self.threads.map_or(0, usize::from),
            directory: Some(folder.records()),
            shard: self.shard,
            ..plan.run_options()
        }
    }
}
