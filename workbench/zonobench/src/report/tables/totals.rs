//! The values of an experiment that counts rare events: their sums, which no median can hide.

use std::collections::{BTreeMap, BTreeSet};

use experiments::definition::Experiment;
use experiments::record::{CountOutcome, CountRow};

use super::number::significant;
use super::variant::variant_title;
use crate::report::html::{Escaped, grouped, table};

/// For every method the sums of the values over all cases. Cases with a wrong answer are included, because wrong
/// answers may be what is counted. The result is empty without values.
pub(in crate::report) fn overall_table(experiment: &Experiment, rows: &[CountRow]) -> String {
    tabulated(experiment, rows, false)
}

/// The same, then the sums input by input.
pub(super) fn total_table(experiment: &Experiment, rows: &[CountRow]) -> String {
    tabulated(experiment, rows, true)
}

fn tabulated(experiment: &Experiment, rows: &[CountRow], by_input: bool) -> String {
    let mut all: Vec<Total<'_>> = Vec::new();
    let mut by_family: Vec<Total<'_>> = Vec::new();
    for row in rows.iter().filter(|row| row.key.experiment == experiment.id) {
        let CountOutcome::Measured { values, .. } = &row.outcome else { continue };
        let (family, method) = (row.key.family.as_str(), row.key.variant.as_str());
        total_of(&mut all, None, method).add(row.key.n, values);
        if by_input {
            total_of(&mut by_family, Some(family), method).add(row.key.n, values);
        }
    }
    let names: BTreeSet<&str> = all.iter().flat_map(|total| total.sums.keys().copied()).collect();
    if names.is_empty() {
        return String::new();
    }
    let cells = |total: &Total<'_>| {
        let input = total.family.map_or("all".to_owned(), |family| Escaped(&family.replace('_', " ")).to_string());
        let [smallest, largest] = total.sizes.map(|n| grouped(n as u64));
        let mut cells = vec![input, format!("{smallest} … {largest}"), variant_title(experiment, total.method)];
        cells.extend(names.iter().map(|name| total.sums.get(name).map_or("–".to_owned(), |&sum| significant(sum))));
        cells
    };
    let titles: Vec<String> = names.iter().map(|name| Escaped(&name.replace('_', " ")).to_string()).collect();
    let header: Vec<&str> = ["input", "n", "method"].into_iter().chain(titles.iter().map(String::as_str)).collect();
    table("values", &header, &all.iter().chain(&by_family).map(cells).collect::<Vec<_>>())
}

/// The sums of one method, on one family or on all of them.
struct Total<'a> {
    family: Option<&'a str>,
    method: &'a str,
    /// The smallest and the largest size among the cases.
    sizes: [usize; 2],
    sums: BTreeMap<&'a str, f64>,
}

impl<'a> Total<'a> {
    fn add(&mut self, n: usize, values: &'a BTreeMap<String, f64>) {
        self.sizes = [self.sizes[0].min(n), self.sizes[1].max(n)];
        for (name, value) in values {
            *self.sums.entry(name).or_default() += value;
        }
    }
}

/// The total of a method and family, new at the end of the list where there is none yet.
fn total_of<'t, 'a>(totals: &'t mut Vec<Total<'a>>, family: Option<&'a str>, method: &'a str) -> &'t mut Total<'a> {
    let found = totals.iter().position(|total| (total.family, total.method) == (family, method));
    let place = found.unwrap_or_else(|| {
        totals.push(Total { family, method, sizes: [usize::MAX, 0], sums: BTreeMap::new() });
        totals.len() - 1
    });
    &mut totals[place]
}

#[cfg(test)]
mod tests {
    use super::*;
    use experiments::catalog;
    use experiments::definition::{Case, Measurement, Verdict};
    use zonotope::tally::OperationCounts;

    fn row(method: &'static str, family: &'static str, n: usize, instance: u32, wrong: f64) -> CountRow {
        let case = Case::new(1, "wrong-answers", family, method, n, instance);
        let verdict = Verdict::Wrong("a wrong answer is counted all the same".to_owned());
        let measurement = Measurement::new(&OperationCounts::default(), 0, verdict);
        CountRow::new(&case, Ok(measurement.with_value("asked", 10.0).with_value("wrong", wrong)))
    }

    /// Three of four cases have no wrong answer, so their median is 0; the seven of the fourth must show.
    #[test]
    fn rare_events_are_summed_over_sizes_instances_and_families() {
        let experiment = catalog::find("wrong-answers").expect("the experiment is in the catalog");
        let rows = [
            row("by_gjk", "random_bodies", 6, 0, 7.0),
            row("by_gjk", "random_bodies", 32, 0, 0.0),
            row("by_gjk", "random_bodies", 32, 1, 0.0),
            row("by_gjk", "flat_bodies", 32, 0, 0.0),
        ];
        let table = total_table(experiment, &rows);
        let cells = |input: &str| {
            let line = table.lines().find(|line| line.contains(&format!(">{input}</td>"))).expect("a row of the table");
            let cells = line.split("</td>").map(|cell| cell.rsplit('>').next().unwrap_or_default().to_owned());
            cells.collect::<Vec<_>>()
        };
        assert_eq!(cells("all")[1..5], ["6 … 32", "Our GJK in floating point", "40", "7"]);
        assert_eq!(cells("random bodies")[1..5], ["6 … 32", "Our GJK in floating point", "30", "7"]);
        assert_eq!(cells("flat bodies")[3..5], ["10", "0"]);
        let overall = overall_table(experiment, &rows);
        assert!(overall.contains(">40</td>") && !overall.contains("bodies</td>"), "{overall}");
        assert_eq!(total_table(catalog::find("hull-scaling").expect("it is in the catalog"), &rows), "");
    }
}
