//! The counting pass: all cases, in parallel, largest first; rows come back in the order of the cases.

use super::cases;
use super::journal::Journal;
use super::options::{Progress, RunOptions, guarded};
use super::share::Share;
use crate::definition::{Case, Experiment};
use crate::record::CountRow;
use rayon::prelude::*;
use std::collections::BTreeMap;
use std::io;

pub(super) fn run(
    experiments: &[&'static Experiment],
    options: &RunOptions,
    share: &Share,
    kept: Vec<CountRow>,
    journal: Option<&Journal>,
    progress: &dyn Progress,
) -> io::Result<Vec<CountRow>> {
    let mut rows: BTreeMap<String, CountRow> = kept.into_iter().map(|row| (row.key.case.clone(), row)).collect();
    let all: Vec<(&'static Experiment, Case)> = experiments
        .iter()
        .flat_map(|&experiment| {
            cases(experiment, options.profile, options.seed).into_iter().map(move |case| (experiment, case))
        })
        .filter(|(_, case)| share.has(case))
        .collect();
    let mut open: Vec<&(&'static Experiment, Case)> =
        all.iter().filter(|(_, case)| !rows.contains_key(&case.id())).collect();
    progress.phase("counting", all.len(), all.len() - open.len());

    // A large case that starts last would leave the other threads idle.
    open.sort_by_key(|(_, case)| std::cmp::Reverse(case.n));
    let new: Vec<CountRow> = open
        .par_iter()
        .with_max_len(1)
        .map(|(experiment, case)| {
            let row = CountRow::new(case, guarded(|| (experiment.measure)(case)));
            if let Some(journal) = journal {
                journal.append(std::slice::from_ref(&row))?;
            }
            progress.step(&row.key.case);
            Ok(row)
        })
        .collect::<io::Result<_>>()?;
    rows.extend(new.into_iter().map(|row| (row.key.case.clone(), row)));
    Ok(all.iter().filter_map(|(_, case)| rows.remove(&case.id())).collect())
}
