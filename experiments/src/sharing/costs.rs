//! The expected costs of experiments, by which shards are made even.

/// Nanoseconds that an element of an input took in the quick profile on one thread, over all variants, for each
/// experiment: printed by `cargo run --release -p experiments --example costs`. They shape shards and nothing else.
const RATES: [(&str, u64); 0] = [];

/// The expected nanoseconds of an experiment for each element of an input; those of a middling one where it is unknown.
pub fn nanoseconds_an_element(experiment: &str) -> u64 {
    RATES.iter().find(|(id, _)| *id == experiment).map_or(UNKNOWN, |&(_, rate)| rate)
}

/// The rate of an experiment that is not in the table.
const UNKNOWN: u64 = 100_000;
