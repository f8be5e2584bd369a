//! `zonobench enclose`.
use super::Ending;
use clap::Args;
/// Options of `enclose`.
#[derive(Debug, Args)]
pub struct Options {}
/// Runs.
pub fn run(_options: &Options) -> anyhow::Result<Ending> {
    anyhow::bail!("not there yet")
}
