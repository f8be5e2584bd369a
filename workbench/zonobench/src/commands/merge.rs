//! `zonobench merge`: the shards of a run, or of a batch of questions, put together.

use std::path::PathBuf;

use anyhow::bail;
use clap::Args;

use super::{Ending, Usage, reproduce, shards, solve};

/// Options of `merge`.
#[derive(Debug, Args)]
pub struct Options {
    /// The folders that hold the shards.
    #[arg(required = true, value_name = "FOLDER")]
    folders: Vec<PathBuf>,
    /// The folder for the report, or the file for the answers; `out/reproduce` and standard output if absent.
    #[arg(long, value_name = "PATH")]
    out: Option<PathBuf>,
    /// Write into the folder although it holds something, or replace the file.
    #[arg(long)]
    force: bool,
}

/// Reads the shards and writes what one run would have written.
pub fn run(options: &Options) -> anyhow::Result<Ending> {
    if options.folders.iter().any(|folder| folder.as_os_str() == "-") {
        return Err(Usage::not_applicable("-", "shards are files, so folders are named").into());
    }
    let parts = shards::read(&options.folders)?;
    let out = options.out.as_deref();
    match parts.first().map(|part| part.heading.kind().to_owned()).as_deref() {
        Some(reproduce::KIND) => reproduce::merge(parts, out.unwrap_or("out/reproduce".as_ref()), options.force),
        Some(solve::KIND) => solve::merge(&parts, out, options.force),
        other => bail!("{}: shards of this kind are not known", other.unwrap_or_default()),
    }
}
