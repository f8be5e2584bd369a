//! `zonobench reproduce`.
use super::Ending;
use clap::Args;
/// Options of `reproduce`.
#[derive(Debug, Args)]
pub struct Options {}
/// Runs.
pub fn run(_options: &Options) -> anyhow::Result<Ending> {
    anyhow::bail!("not there yet")
}
