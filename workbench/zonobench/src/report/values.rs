//! The other numbers of an experiment: ratios, sizes of results.

use std::collections::{BTreeMap, BTreeSet};

use experiments::definition::Experiment;
use experiments::record::{CountOutcome, CountRow};

use super::html::{Escaped, grouped, table};

/// For every input and method the values at the largest size: the middle one of the instances. Empty without values.
pub(super) fn value_table(experiment: &Experiment, rows: &[CountRow]) -> String {
    let mut largest: BTreeMap<(&str, &str), usize> = BTreeMap::new();
    let mut order: Vec<(&str, &str)> = Vec::new();
    let rows: Vec<&CountRow> =
        rows.iter().filter(|row| row.key.experiment == experiment.id && row.fault().is_none()).collect();
    for row in &rows {
        let place = (row.key.family.as_str(), row.key.variant.as_str());
        let size = largest.entry(place).or_insert_with(|| {
            order.push(place);
            0
        });
        *size = row.key.n.max(*size);
    }
    let names: BTreeSet<&str> = rows.iter().flat_map(|row| values(row).keys()).map(String::as_str).collect();
    if names.is_empty() {
        return String::new();
    }
    let cells = |&(family, variant): &(&str, &str)| {
        let n = largest[&(family, variant)];
        let at_largest =
            rows.iter().filter(|row| row.key.family == family && row.key.variant == variant && row.key.n == n);
        let middle = |name: &&str| middle(at_largest.clone().filter_map(|row| row.value(name)).collect());
        let mut cells =
            vec![Escaped(&family.replace('_', " ")).to_string(), grouped(n as u64), title(experiment, variant)];
        cells.extend(names.iter().map(middle));
        cells
    };
    let mut header = vec!["input", "n", "method"];
    let titles: Vec<String> = names.iter().map(|name| Escaped(&name.replace('_', " ")).to_string()).collect();
    header.extend(titles.iter().map(String::as_str));
    table("values", &header, &order.iter().map(cells).collect::<Vec<_>>())
}

fn values(row: &CountRow) -> &BTreeMap<String, f64> {
    static NONE: BTreeMap<String, f64> = BTreeMap::new();
    match &row.outcome {
        CountOutcome::Measured { values, .. } => values,
        CountOutcome::Failed { .. } => &NONE,
    }
}

fn title(experiment: &Experiment, variant: &str) -> String {
    let found = experiment.variants.iter().find(|candidate| candidate.id == variant);
    Escaped(found.map_or(variant, |variant| variant.title)).to_string()
}

/// The middle value (the upper one of an even number), in six significant digits.
fn middle(mut values: Vec<f64>) -> String {
    values.sort_by(f64::total_cmp);
    match values.get(values.len() / 2) {
        None => "–".to_owned(),
        Some(value) if value.fract() == 0.0 && value.abs() < 1e15 => format!("{value}"),
        Some(value) if (1e-3..1e6).contains(&value.abs()) => format!("{value:.5}"),
        Some(value) => format!("{value:.3e}"),
    }
}
