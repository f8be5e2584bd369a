//! `zonobench records`: what a run of `reproduce` recorded, as a table for other programs.

mod reading;
pub(super) mod table;

use std::path::PathBuf;

use clap::{Args, Subcommand};

use super::Ending;
use super::usage::check_names;
use crate::output::{Existing, Outputs};

pub use self::reading::RecordsError;
pub(super) use self::reading::RunRecords;

/// Options of `records`.
#[derive(Debug, Args)]
pub struct Options {
    #[command(subcommand)]
    what: What,
}

#[derive(Debug, Subcommand)]
enum What {
    /// Write all numbers of a run as one table, a number a row.
    Export(Export),
}

#[derive(Debug, Args)]
struct Export {
    /// The folder of the run: the one that `reproduce --out` names.
    run: PathBuf,
    /// Write the table; `-` is standard output.
    #[arg(long, value_name = "FILE")]
    csv: PathBuf,
    /// Replace a file that exists.
    #[arg(long)]
    force: bool,
}

/// Reads the records of a run and writes them.
pub fn run(options: &Options) -> anyhow::Result<Ending> {
    let What::Export(export) = &options.what;
    check_names(&[("CSV", Some(&export.csv))])?;
    let files = RunRecords::files(&export.run);
    let inputs = files.each_ref().map(PathBuf::as_path);
    let outputs = Outputs::checked([&export.csv], &inputs, Existing::from_force(export.force))?;
    let RunRecords { counts, times, .. } = RunRecords::read(&export.run)?;
    let table = table::csv(&counts, &times)?;
    let told = format!("{} runs counted, {} times, in {}\n", counts.len(), times.len(), export.csv.display());
    outputs.finish_one(&export.csv, &table, &told)?;
    Ok(Ending::Good)
}
