//! The part of a run that a shard does: inputs as a whole, with all variants and with their times.

use super::cases::{cases, timed_groups};
use super::options::RunOptions;
use crate::definition::{Case, Experiment};
use crate::sharing::nanoseconds_an_element;
use std::collections::{BTreeMap, BTreeSet};

/// An instance of an experiment. Its variants belong together: times are taken in turns, and a time is held to the
/// answer that was counted.
type Input = (&'static str, &'static str, usize, u32);

fn input_of(case: &Case) -> Input {
    (case.experiment, case.family, case.n, case.instance)
}

/// The inputs that a run is about.
pub(super) struct Share(Option<BTreeSet<Input>>);

impl Share {
    /// All inputs, or those of the shard.
    pub(super) fn of(experiments: &[&'static Experiment], options: &RunOptions) -> Self {
        let Some(shard) = options.shard else {
            return Self(None);
        };
        let costs = costs(experiments, options);
        let hand = shard.hand(&costs.values().copied().collect::<Vec<_>>());
        Self(Some(costs.into_keys().zip(hand).filter_map(|(input, mine)| mine.then_some(input)).collect()))
    }

    /// Whether the run has the case.
    pub(super) fn has(&self, case: &Case) -> bool {
        self.0.as_ref().is_none_or(|inputs| inputs.contains(&input_of(case)))
    }
}

/// The expected nanoseconds of each input. An instance that is timed is worked on once more for every repetition, and
/// once without a record.
fn costs(experiments: &[&'static Experiment], options: &RunOptions) -> BTreeMap<Input, u64> {
    let mut costs = BTreeMap::new();
    for &experiment in experiments {
        let rate = nanoseconds_an_element(experiment.id);
        let mut add = |case: &Case, times: u64| {
            *costs.entry(input_of(case)).or_insert(0) += rate.saturating_mul(case.n as u64).saturating_mul(times);
        };
        cases(experiment, options.profile, options.seed).iter().for_each(|case| add(case, 1));
        if let Some(timing) = experiment.timing.filter(|_| options.times) {
            let repetitions = u64::from(timing.repetitions.get(options.profile));
            let timed = timed_groups(experiment, options.profile, options.seed);
            timed.iter().flatten().for_each(|case| add(case, 1 + repetitions));
        }
    }
    costs
}
