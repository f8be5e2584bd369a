//! The cases of all experiments in a profile, a line of JSON each, with the number of times that are taken of it.
//!
//! `cargo run --release -p experiments --example cases_of_a_run -- [quick or full]`

use std::collections::BTreeMap;
use std::env;

use experiments::catalog::EXPERIMENTS;
use experiments::definition::Profile;
use experiments::record::CaseKey;
use experiments::runner::{cases, timed_groups};
use serde::Serialize;

/// The seed of a run that names none.
const USUAL_SEED: u64 = 2003;

/// A line of the output.
#[derive(Serialize)]
struct CaseOfRun {
    #[serde(flatten)]
    key: CaseKey,
    repetitions: u32,
}

fn main() {
    let profile = if env::args().any(|argument| argument == "full") { Profile::Full } else { Profile::Quick };
    for experiment in EXPERIMENTS {
        let repetitions: BTreeMap<String, u32> = experiment.timing.map_or_else(BTreeMap::new, |timing| {
            let timed = timed_groups(experiment, profile, USUAL_SEED);
            timed.iter().flatten().map(|case| (case.id(), timing.repetitions.get(profile))).collect()
        });
        for case in cases(experiment, profile, USUAL_SEED) {
            let repetitions = repetitions.get(&case.id()).copied().unwrap_or(0);
            let line = serde_json::to_string(&CaseOfRun { key: CaseKey::from(&case), repetitions });
            println!("{}", line.expect("a case has a name and numbers alone"));
        }
    }
}
