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
mod put_together;
mod share;
mod store;
mod timing;

pub use self::options::{Progress, RunOptions};
pub use cases::{cases, own_size, timed_groups};
pub use put_together::put_together;
pub use store::{Records, RunError};

use self::store::Store;
use crate::definition::Experiment;
use crate::environment::Environment;

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

    let share = share::Share::of(experiments, options);
    let (count_journal, kept_counts) = store.journal("counts").map_err(in_directory)?;
    let counts = pool
        .install(|| counting::run(experiments, options, &share, kept_counts, count_journal.as_ref(), progress))
        .map_err(in_directory)?;
    let (time_journal, kept_times) = store.journal("times").map_err(in_directory)?;
    let times = if options.times {
        let kept = (kept_times, time_journal.as_ref());
        timing::run(experiments, options, &share, &counts, &environment, kept, progress).map_err(in_directory)?
    } else {
        Vec::new()
    };

    let records = Records { counts, times, environment, elsewhere: Vec::new() };
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
            "shard": options.shard.map(|shard| shard.to_string()),
        }
    })
    .to_string()
}

#[cfg(test)]
mod tests;
