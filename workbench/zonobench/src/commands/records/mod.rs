//! `zonobench records`: what a run of `reproduce` recorded, as a table for other programs.

pub(super) mod table;

use std::fs;
use std::path::{Path, PathBuf};

use clap::{Args, Subcommand};
use experiments::record::{CountRow, TimeRow};
use serde::de::DeserializeOwned;
use thiserror::Error;

use super::Ending;
use crate::output::{Existing, Outputs};

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

/// Why the records of a run are not read.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum RecordsError {
    /// A file of records cannot be read.
    #[error("{}: cannot be read", .file.display())]
    Unreadable {
        /// The file.
        file: PathBuf,
        /// The system's complaint.
        source: std::io::Error,
    },
    /// A line is no record.
    #[error("{}: line {line}: is no record", .file.display())]
    NoRecord {
        /// The file.
        file: PathBuf,
        /// The line, counted from 1.
        line: usize,
        /// What is wrong with it.
        source: serde_json::Error,
    },
}

/// Reads the records of a run and writes them.
pub fn run(options: &Options) -> anyhow::Result<Ending> {
    let What::Export(export) = &options.what;
    let [counts, times] = ["counts", "times"].map(|name| export.run.join(format!("records/{name}.jsonl")));
    let outputs = Outputs::checked([&export.csv], &[&counts, &times], Existing::from_force(export.force))?;
    let (counts, times) = (rows::<CountRow>(&counts)?, rows::<TimeRow>(&times)?);
    let table = table::csv(&counts, &times)?;
    outputs.write(&export.csv, &table)?;
    outputs.tell(&format!("{} runs counted, {} times, in {}\n", counts.len(), times.len(), export.csv.display()))?;
    Ok(Ending::Good)
}

fn rows<Row: DeserializeOwned>(file: &Path) -> Result<Vec<Row>, RecordsError> {
    let unreadable = |source| RecordsError::Unreadable { file: file.to_path_buf(), source };
    let text = fs::read_to_string(file).map_err(unreadable)?;
    let row = |(index, line): (usize, &str)| {
        let broken = |source| RecordsError::NoRecord { file: file.to_path_buf(), line: index + 1, source };
        serde_json::from_str(line).map_err(broken)
    };
    text.lines().enumerate().map(row).collect()
}
