//! The only place that reads a clock.

use std::collections::BTreeMap;
use std::hint::black_box;
use std::time::Instant;

/// Collects the laps of one run.
#[derive(Debug, Default)]
pub struct Stopwatch {
    laps_ns: BTreeMap<String, u64>,
}

impl Stopwatch {
    /// Runs `work`, adds its wall time to the lap called `name`, and returns its result.
    pub fn lap<T>(&mut self, name: &str, work: impl FnOnce() -> T) -> T {
        let start = Instant::now();
        let result = black_box(work());
        let elapsed_ns = u64::try_from(start.elapsed().as_nanos()).unwrap_or(u64::MAX);
        *self.laps_ns.entry(name.to_owned()).or_default() += elapsed_ns;
        result
    }

    /// The laps by name, in nanoseconds.
    pub fn into_laps_ns(self) -> BTreeMap<String, u64> {
        self.laps_ns
    }
}
