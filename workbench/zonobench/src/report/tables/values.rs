//! The other numbers of an experiment: ratios, sizes of results.

use std::collections::{BTreeMap, BTreeSet};

use experiments::definition::{Experiment, Tabulated};
use experiments::record::{CaseKey, CountOutcome, CountRow, TimeOutcome, TimeRow};

use super::number::significant;
use super::totals::total_table;
use super::variant::variant_title;
use crate::report::html::{Escaped, grouped, table};

/// The values put together as the experiment says. Empty without values.
pub(in crate::report) fn value_table(experiment: &Experiment, rows: &[CountRow]) -> String {
    match experiment.table {
        Tabulated::MedianAtLargest => median_table(experiment, rows.iter()),
        Tabulated::Total => total_table(experiment, rows),
    }
}

/// The medians on one input alone.
pub(in crate::report) fn value_table_on(experiment: &Experiment, input: &str, rows: &[CountRow]) -> String {
    median_table(experiment, rows.iter().filter(|row| row.key.family == input))
}

/// For every input and method the values at the largest size: the median over the instances.
fn median_table<'a>(experiment: &Experiment, rows: impl Iterator<Item = &'a CountRow>) -> String {
    let rows = rows.filter(|row| row.fault().is_none());
    let rows = rows.map(|row| Row {
        key: &row.key,
        numbers: values(row).iter().map(|(name, value)| (name.as_str(), *value)).collect(),
    });
    at_largest(experiment, rows.collect(), significant)
}

/// For every input and method the laps at the largest size, in milliseconds: the middle one of the repetitions and
/// instances.
pub(in crate::report) fn time_table(experiment: &Experiment, rows: &[TimeRow]) -> String {
    let rows = rows.iter().filter_map(|row| match &row.outcome {
        TimeOutcome::Valid { laps_ns } => {
            let numbers = laps_ns.iter().map(|(name, &ns)| (name.as_str(), ns as f64 / 1e6)).collect();
            Some(Row { key: &row.key, numbers })
        }
        TimeOutcome::Void { .. } | TimeOutcome::Failed { .. } => None,
    });
    at_largest(experiment, rows.collect(), |milliseconds| format!("{milliseconds:.3} ms"))
}

/// The numbers of one record.
struct Row<'a> {
    key: &'a CaseKey,
    numbers: BTreeMap<&'a str, f64>,
}

fn at_largest(experiment: &Experiment, mut rows: Vec<Row<'_>>, written: fn(f64) -> String) -> String {
    rows.retain(|row| row.key.experiment == experiment.id);
    let mut places: Vec<(&str, &str, usize)> = Vec::new();
    for row in &rows {
        let CaseKey { family, variant, n, .. } = row.key;
        match places.iter_mut().find(|place| (place.0, place.1) == (family, variant)) {
            Some(place) => place.2 = place.2.max(*n),
            None => places.push((family, variant, *n)),
        }
    }
    let names: BTreeSet<&str> = rows.iter().flat_map(|row| row.numbers.keys().copied()).collect();
    if names.is_empty() {
        return String::new();
    }
    let cells = |&(family, variant, n): &(&str, &str, usize)| {
        let here: Vec<&Row<'_>> = rows
            .iter()
            .filter(|row| row.key.family == family && row.key.variant == variant && row.key.n == n)
            .collect();
        let mut cells =
            vec![Escaped(&family.replace('_', " ")).to_string(), grouped(n as u64), variant_title(experiment, variant)];
        for name in &names {
            let middle = middle(here.iter().filter_map(|row| row.numbers.get(name).copied()).collect());
            cells.push(middle.map_or("–".to_owned(), written));
        }
        cells
    };
    let mut header = vec!["input", "n", "method"];
    let titles: Vec<String> = names.iter().map(|name| Escaped(&name.replace('_', " ")).to_string()).collect();
    header.extend(titles.iter().map(String::as_str));
    table("values", &header, &places.iter().map(cells).collect::<Vec<_>>())
}

fn values(row: &CountRow) -> &BTreeMap<String, f64> {
    static NONE: BTreeMap<String, f64> = BTreeMap::new();
    match &row.outcome {
        CountOutcome::Measured { values, .. } => values,
        CountOutcome::Failed { .. } => &NONE,
    }
}

/// The middle number, the upper one of an even count.
fn middle(mut numbers: Vec<f64>) -> Option<f64> {
    numbers.sort_by(f64::total_cmp);
    numbers.get(numbers.len() / 2).copied()
}
