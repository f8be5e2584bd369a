//! `zonobench list`.
use super::Ending;
use clap::Args;
/// Options of `list`.
#[derive(Debug, Args)]
pub struct Options {}
/// Runs.
pub fn run(_options: &Options) -> anyhow::Result<Ending> {
    anyhow::bail!("not there yet")
}
