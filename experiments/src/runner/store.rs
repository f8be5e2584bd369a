//! The records of a run and the files that they are kept in.

use super::journal;
use crate::environment::Environment;
use crate::record::{CountRow, TimeRow};
use std::io;
use std::path::{Path, PathBuf};

/// Everything a run recorded, in a fixed order.
#[derive(Clone, Debug, PartialEq)]
pub struct Records {
    /// One row a case.
    pub counts: Vec<CountRow>,
    /// One row a timed repetition.
    pub times: Vec<TimeRow>,
    /// The machine on which the program ran and the times were measured.
    pub environment: Environment,
    /// The machines on which the times were measured, where shards were put together; empty otherwise.
    pub elsewhere: Vec<Environment>,
}

/// Why a run stopped. Cases that fail do not stop it: they become rows.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum RunError {
    /// A record file or its directory cannot be read or written.
    #[error("cannot keep records in {}: {source}", directory.display())]
    Records {
        /// The run's directory.
        directory: PathBuf,
        /// The cause.
        source: io::Error,
    },
    /// The threads cannot be started.
    #[error("cannot start {threads} threads: {source}")]
    Threads {
        /// The number asked for.
        threads: usize,
        /// The cause.
        source: rayon::ThreadPoolBuildError,
    },
    /// A case of the run is in no shard.
    #[error("no shard has the case {case}")]
    Missing {
        /// The case.
        case: String,
    },
}

/// The run's directory, if it has one.
pub(super) struct Store<'a> {
    pub(super) directory: Option<&'a Path>,
    pub(super) header: String,
}

impl Store<'_> {
    pub(super) fn create_directory(&self) -> io::Result<()> {
        self.directory.map_or(Ok(()), std::fs::create_dir_all)
    }

    pub(super) fn journal<Row: serde::de::DeserializeOwned>(
        &self,
        name: &str,
    ) -> io::Result<(Option<journal::Journal>, Vec<Row>)> {
        let Some(directory) = self.directory else {
            return Ok((None, Vec::new()));
        };
        let path = directory.join(format!("{name}.jsonl.partial"));
        let (journal, rows) = journal::Journal::open(path, &self.header)?;
        Ok((Some(journal), rows))
    }

    /// Writes the final files; only then the journals go.
    pub(super) fn finish(&self, records: &Records, journals: [Option<journal::Journal>; 2]) -> io::Result<()> {
        let Some(directory) = self.directory else {
            return Ok(());
        };
        let named =
            |environment: &Environment| serde_json::json!({ "id": environment.id(), "environment": environment });
        let mut environment = named(&records.environment);
        if !records.elsewhere.is_empty() {
            environment["times"] = records.elsewhere.iter().map(named).collect();
        }
        let environment = format!("{}\n", serde_json::to_string_pretty(&environment)?);
        journal::write_atomically(&directory.join("environment.json"), &environment)?;
        journal::write_atomically(&directory.join("counts.jsonl"), &journal::json_lines(&records.counts)?)?;
        journal::write_atomically(&directory.join("times.jsonl"), &journal::json_lines(&records.times)?)?;
        journals.into_iter().flatten().try_for_each(journal::Journal::remove)
    }
}
