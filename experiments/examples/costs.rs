//! The expected costs by which shards of a run are made even, as `experiments/src/sharing/costs.rs` has them.
//!
//! `cargo run --release -p experiments --example costs` counts the quick profile of every experiment on one thread and
//! prints for each how long an element of an input took, over all variants.

use std::time::Instant;

use experiments::catalog::EXPERIMENTS;
use experiments::definition::Profile;
use experiments::runner::{self, RunOptions};

fn main() -> Result<(), runner::RunError> {
    let options = RunOptions {
        profile: Profile::Quick,
        seed: 2003,
        threads: 1,
        directory: None,
        times: false,
        own_inputs: String::new(),
        shard: None,
    };
    for experiment in EXPERIMENTS {
        let start = Instant::now();
        let records = runner::run(&[experiment], &options, &())?;
        let elapsed = start.elapsed().as_nanos();
        let elements: u128 = records.counts.iter().map(|row| row.key.n as u128).sum();
        println!("    (\"{}\", {}),", experiment.id, elapsed / elements.max(1));
    }
    Ok(())
}
