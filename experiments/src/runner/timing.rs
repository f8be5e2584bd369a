//! The timing pass: one case at a time, the repetitions of the cases on one input interleaved.
//!
//! Every case of a group runs once without a record; repetition r then starts with the r-th case and goes around, so
//! that drift of the machine falls on all of them alike. Journals hold whole groups only.

use super::journal::Journal;
use super::options::{Progress, RunOptions, guarded};
use super::share::Share;
use super::timed_groups;
use crate::definition::{Case, Experiment, TimedWork, Timing};
use crate::environment::Environment;
use crate::record::{CountOutcome, CountRow, TimeOutcome, TimeRow};
use crate::stopwatch::Stopwatch;
use std::collections::BTreeMap;
use std::io;

pub(super) fn run(
    experiments: &[&'static Experiment],
    options: &RunOptions,
    share: &Share,
    counts: &[CountRow],
    environment: &Environment,
    (kept, journal): (Vec<TimeRow>, Option<&Journal>),
    progress: &dyn Progress,
) -> io::Result<Vec<TimeRow>> {
    let counts: BTreeMap<&str, &CountRow> = counts.iter().map(|row| (row.key.case.as_str(), row)).collect();
    let mut kept_rows: BTreeMap<(String, u32), TimeRow> =
        kept.into_iter().map(|row| ((row.key.case.clone(), row.repetition), row)).collect();
    let groups: Vec<(Timing, Vec<Case>)> = experiments
        .iter()
        .filter_map(|experiment| Some((experiment.timing?, *experiment)))
        .flat_map(|(timing, experiment)| {
            timed_groups(experiment, options.profile, options.seed).into_iter().map(move |group| (timing, group))
        })
        .filter(|(_, group)| group.iter().all(|case| share.has(case)))
        .collect();
    let keys = |(timing, group): &(Timing, Vec<Case>)| -> Vec<(String, u32)> {
        let repetitions = timing.repetitions.get(options.profile);
        group.iter().flat_map(|case| (0..repetitions).map(|repetition| (case.id(), repetition))).collect()
    };
    let is_done = |rows: &BTreeMap<_, _>, group| keys(group).iter().all(|key| rows.contains_key(key));
    let done = groups.iter().filter(|group| is_done(&kept_rows, group)).count();
    progress.phase("timing", groups.len(), done);

    let environment = environment.id();
    let mut rows = Vec::new();
    for group in &groups {
        if is_done(&kept_rows, group) {
            rows.extend(keys(group).iter().filter_map(|key| kept_rows.remove(key)));
            continue;
        }
        let (timing, cases) = group;
        let new = time_group(timing, cases, timing.repetitions.get(options.profile), &counts, &environment);
        if let Some(journal) = journal {
            journal.append(&new)?;
        }
        rows.extend(new);
        progress.step(&cases[0].id());
    }
    Ok(rows)
}

fn time_group(
    timing: &Timing,
    cases: &[Case],
    repetitions: u32,
    counts: &BTreeMap<&str, &CountRow>,
    environment: &str,
) -> Vec<TimeRow> {
    let mut works: Vec<Result<TimedWork, String>> = cases
        .iter()
        .map(|case| {
            let mut work = guarded(|| (timing.prepare)(case))?;
            guarded(|| work(&mut Stopwatch::default()))?;
            Ok(work)
        })
        .collect();
    let mut rows = Vec::new();
    for repetition in 0..repetitions {
        for turn in 0..cases.len() {
            let index = (turn + repetition as usize) % cases.len();
            let case = &cases[index];
            let outcome = match &mut works[index] {
                Err(error) => TimeOutcome::Failed { error: error.clone() },
                Ok(work) => time_once(work, counts.get(case.id().as_str()).copied()),
            };
            rows.push(TimeRow { key: case.into(), repetition, environment: environment.to_owned(), outcome });
        }
    }
    let position = |row: &TimeRow| cases.iter().position(|case| case.id() == row.key.case);
    rows.sort_by_key(|row| (position(row), row.repetition));
    rows
}

fn time_once(work: &mut TimedWork, counted: Option<&CountRow>) -> TimeOutcome {
    let mut stopwatch = Stopwatch::default();
    let digest = match guarded(|| work(&mut stopwatch)) {
        Ok(digest) => digest,
        Err(error) => return TimeOutcome::Failed { error },
    };
    let laps_ns = stopwatch.into_laps_ns();
    match reason_to_void(digest, counted) {
        Some(reason) => TimeOutcome::Void { laps_ns, reason },
        None => TimeOutcome::Valid { laps_ns },
    }
}

fn reason_to_void(digest: u64, counted: Option<&CountRow>) -> Option<String> {
    let Some(row) = counted else {
        return Some("the case was not counted, so nothing checked its answer".to_owned());
    };
    if let Some(fault) = row.fault() {
        return Some(fault.to_owned());
    }
    match &row.outcome {
        CountOutcome::Measured { digest: expected, .. } if *expected != format!("{digest:016x}") => {
            Some(format!("the answer {digest:016x} is not that of the counted run, {expected}"))
        }
        _ => None,
    }
}
