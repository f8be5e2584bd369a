//! Runs experiments: every case is counted, in parallel, and then some are timed, one after the other.
//!
//! Files in the run's directory:
//! - `counts.jsonl`: operation counts and values; the same for the same seed and profile, whatever the threads and the
//!   machine;
//! - `times.jsonl`: raw times, one row a repetition; `environment.json`: where they were measured;
//! - `*.partial` while the run lasts: a killed run continues from them if seed, profile, experiments and program are
//!   the same.
//!
//! The order of rows is that of the catalog, then real inputs before families, then sizes, variants and instances.

mod cases;
mod counting;
mod journal;
mod options;
mod timing;

pub use self::options::{Progress, RunOptions};
pub use cases::{cases, own_size, timed_groups};

use crate::definition::Experiment;
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
    /// The machine on which the times were measured.
    pub environment: Environment,
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
}

/// Runs `experiments` and returns the records; see the module's documentation for the files.
pub fn run(
    experiments: &[&'static Experiment],
    options: &RunOptions,
    progress: &dyn Progress,
) -> Result<Records, RunError> {
    let pool = rayon::ThreadPoolBuilder::new()
        .num_threads(options.threads)
        .build()
        .map_err(|source| RunError::Threads { threads: options.threads, source })?;
    let environment = Environment::current();
    let in_directory = |source| RunError::Records { directory: options.directory.clone().unwrap_or_default(), source };
    let store = Store { directory: options.directory.as_deref(), header: header(experiments, options, &environment) };
    store.create_directory().map_err(in_directory)?;

    let (count_journal, kept_counts) = store.journal("counts").map_err(in_directory)?;
    let counts = pool
        .install(|| counting::run(experiments, options, kept_counts, count_journal.as_ref(), progress))
        .map_err(in_directory)?;
    let (time_journal, kept_times) = store.journal("times").map_err(in_directory)?;
    let times = if options.times {
        timing::run(experiments, options, &counts, &environment, kept_times, time_journal.as_ref(), progress)
            .map_err(in_directory)?
    } else {
        Vec::new()
    };

    let records = Records { counts, times, environment };
    store.finish(&records, [count_journal, time_journal]).map_err(in_directory)?;
    Ok(records)
}

/// Names a run: rows left behind under the same header can be kept.
fn header(experiments: &[&'static Experiment], options: &RunOptions, environment: &Environment) -> String {
    let ids: Vec<_> = experiments.iter().map(|experiment| experiment.id).collect();
    serde_json::json!({
        "run": {
            "profile": options.profile.to_string(),
            "seed": format!("{:016x}", options.seed),
            "experiments": ids,
            "own inputs": options.own_inputs,
            "environment": environment.id(),
        }
    })
    .to_string()
}

/// The run's directory, if it has one.
struct Store<'a> {
    directory: Option<&'a Path>,
    header: String,
}

impl Store<'_> {
    fn create_directory(&self) -> io::Result<()> {
        self.directory.map_or(Ok(()), std::fs::create_dir_all)
    }

    fn journal<Row: serde::de::DeserializeOwned>(
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
    fn finish(&self, records: &Records, journals: [Option<journal::Journal>; 2]) -> io::Result<()> {
        let Some(directory) = self.directory else {
            return Ok(());
        };
        let environment = serde_json::json!({ "id": records.environment.id(), "environment": records.environment });
        let environment = format!("{}\n", serde_json::to_string_pretty(&environment)?);
        journal::write_atomically(&directory.join("environment.json"), &environment)?;
        journal::write_atomically(&directory.join("counts.jsonl"), &journal::json_lines(&records.counts)?)?;
        journal::write_atomically(&directory.join("times.jsonl"), &journal::json_lines(&records.times)?)?;
        journals.into_iter().flatten().try_for_each(journal::Journal::remove)
    }
}

#[cfg(test)]
mod tests;
