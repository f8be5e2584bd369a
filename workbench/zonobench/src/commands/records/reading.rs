//! The records in the folder of a run.

use std::fs;
use std::path::{Path, PathBuf};

use experiments::environment::Environment;
use experiments::record::{CountRow, TimeRow};
use serde::Deserialize;
use serde::de::DeserializeOwned;
use thiserror::Error;

use crate::report::MANIFEST;

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
    /// The folder has no records, or there is no such folder.
    #[error("{}: is no folder that `reproduce` wrote", .0.display())]
    NoRun(PathBuf),
    /// A line is no record.
    #[error("{}: line {line}: is no record", .file.display())]
    NoRecord {
        /// The file.
        file: PathBuf,
        /// The line, counted from 1.
        line: usize,
        /// Its fault.
        source: serde_json::Error,
    },
}

/// The record of a run of `reproduce`.
pub(in crate::commands) struct RunRecords {
    pub(in crate::commands) counts: Vec<CountRow>,
    pub(in crate::commands) times: Vec<TimeRow>,
    /// The description of the run; an interrupted one does not say.
    pub(in crate::commands) run: Option<Run>,
    /// The machine and the program, where the folder tells them.
    pub(in crate::commands) environment: Option<Environment>,
}

/// The description of a run, as its manifest has it.
#[derive(Debug, Deserialize)]
pub(in crate::commands) struct Run {
    pub(in crate::commands) seed: u64,
    pub(in crate::commands) profile: String,
}

/// The file of the environment.
#[derive(Deserialize)]
struct Named {
    environment: Environment,
}

impl RunRecords {
    /// The files that hold the records of a run in its folder.
    pub(in crate::commands) fn files(run: &Path) -> [PathBuf; 2] {
        ["counts", "times"].map(|name| run.join(format!("records/{name}.jsonl")))
    }

    /// The records of a run in its folder.
    pub(in crate::commands) fn read(run_folder: &Path) -> Result<Self, RecordsError> {
        let [counts, times] = Self::files(run_folder);
        if !counts.is_file() && !times.is_file() {
            return Err(RecordsError::NoRun(run_folder.to_path_buf()));
        }
        let manifest = fs::read_to_string(run_folder.join(MANIFEST)).ok();
        let run = manifest.and_then(|manifest| serde_json::from_str(&manifest).ok());
        let environment = fs::read_to_string(run_folder.join("records/environment.json")).ok();
        let environment = environment.and_then(|text| serde_json::from_str::<Named>(&text).ok());
        let environment = environment.map(|named| named.environment);
        Ok(Self { counts: rows(&counts)?, times: rows(&times)?, run, environment })
    }
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
