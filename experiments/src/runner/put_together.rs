//! The records of a whole run from those of its shards.

use super::cases::{cases, timed_groups};
use super::options::RunOptions;
use super::store::{Records, RunError, Store};
use crate::definition::Experiment;
use crate::environment::Environment;
use crate::record::{CountRow, TimeRow};
use std::collections::BTreeMap;

/// The records of all shards of a run in the order of one run, written into the run's directory as one run writes them.
///
/// # Errors
/// [`RunError::Missing`] names the first case that no shard has counted, or timed as often as the run wants;
/// [`RunError::Records`] if files cannot be written.
pub fn put_together(
    experiments: &[&'static Experiment],
    options: &RunOptions,
    shards: impl IntoIterator<Item = Records>,
) -> Result<Records, RunError> {
    let mut counts: BTreeMap<String, CountRow> = BTreeMap::new();
    let mut times: BTreeMap<(String, u32), TimeRow> = BTreeMap::new();
    let mut elsewhere: BTreeMap<String, Environment> = BTreeMap::new();
    for shard in shards {
        counts.extend(shard.counts.into_iter().map(|row| (row.key.case.clone(), row)));
        times.extend(shard.times.into_iter().map(|row| ((row.key.case.clone(), row.repetition), row)));
        elsewhere.insert(shard.environment.id(), shard.environment);
    }
    let mut whole = Records {
        counts: Vec::with_capacity(counts.len()),
        times: Vec::with_capacity(times.len()),
        environment: Environment::current(),
        elsewhere: elsewhere.into_values().collect(),
    };
    let missing = |case: String| RunError::Missing { case };
    for &experiment in experiments {
        for case in cases(experiment, options.profile, options.seed) {
            let id = case.id();
            whole.counts.push(counts.remove(&id).ok_or_else(|| missing(id))?);
        }
        let Some(timing) = experiment.timing.filter(|_| options.times) else { continue };
        for case in timed_groups(experiment, options.profile, options.seed).iter().flatten() {
            for repetition in 0..timing.repetitions.get(options.profile) {
                let row = times.remove(&(case.id(), repetition));
                whole.times.push(row.ok_or_else(|| missing(format!("{}, repetition {repetition}", case.id())))?);
            }
        }
    }
    let in_directory = |source| RunError::Records { directory: options.directory.clone().unwrap_or_default(), source };
    let store = Store { directory: options.directory.as_deref(), header: String::new() };
    store.create_directory().and_then(|()| store.finish(&whole, [None, None])).map_err(in_directory)?;
    Ok(whole)
}
