//! Counts, values and answers of two runs, case by case.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt;

use experiments::definition::Verdict;
use experiments::record::{CaseKey, CountOutcome, CountRow};

/// The common part of the cases of two runs.
#[derive(Debug)]
pub(super) struct Comparison<'a> {
    /// The number of cases that both runs have.
    pub(super) common: usize,
    /// The numbers of cases that one run has alone.
    pub(super) alone: [usize; 2],
    /// The number of common cases that have another seed in the second run: other instances, which nothing can be
    /// compared of.
    pub(super) reseeded: usize,
    /// The cases of the same seeds whose records differ, in the order of the first run.
    pub(super) differences: Vec<Difference<'a>>,
}

/// A case whose records differ.
#[derive(Debug)]
pub(super) struct Difference<'a> {
    key: &'a CaseKey,
    /// The quantities that differ, each with what the first and the second run recorded.
    quantities: Vec<[String; 3]>,
}

impl<'a> Comparison<'a> {
    /// Compares the cases of the same names.
    pub(super) fn of(first: &'a [CountRow], second: &'a [CountRow]) -> Self {
        let others: BTreeMap<&str, &CountRow> = second.iter().map(|row| (row.key.case.as_str(), row)).collect();
        let pairs: Vec<(&CountRow, &CountRow)> =
            first.iter().filter_map(|row| Some((row, *others.get(row.key.case.as_str())?))).collect();
        let common = pairs.len();
        let seeds = |row: &'a CountRow| [&row.key.instance_seed, &row.key.seed];
        let (pairs, others): (Vec<_>, Vec<_>) = pairs.into_iter().partition(|(a, b)| seeds(a) == seeds(b));
        let differing = pairs.into_iter().map(|(a, b)| Difference { key: &a.key, quantities: differing(a, b) });
        Self {
            common,
            reseeded: others.len(),
            alone: [first.len() - common, second.len() - common],
            differences: differing.filter(|difference| !difference.quantities.is_empty()).collect(),
        }
    }
}

/// The experiment and the instance, and what differs.
impl fmt::Display for Difference<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let CaseKey { experiment, family, variant, n, instance, .. } = self.key;
        write!(f, "  {experiment}: {variant} on {family}, n = {n}, instance {instance}: ")?;
        let quantities: Vec<String> =
            self.quantities.iter().map(|[name, first, second]| format!("{name} {first}, then {second}")).collect();
        f.write_str(&quantities.join("; "))
    }
}

/// Differences of two records of a case.
fn differing(first: &CountRow, second: &CountRow) -> Vec<[String; 3]> {
    let records = [first, second].map(|row| {
        let mut record = BTreeMap::new();
        match &row.outcome {
            CountOutcome::Failed { error } => {
                record.insert("outcome".to_owned(), format!("failed ({error})"));
            }
            CountOutcome::Measured { counts, values, digest, verdict } => {
                record.insert("outcome".to_owned(), outcome(verdict));
                record.insert("answer".to_owned(), digest.clone());
                record.extend(counts.iter().map(|(name, count)| (name.clone(), count.to_string())));
                record.extend(values.iter().map(|(name, value)| (name.clone(), format!("{value:?}"))));
            }
        }
        record
    });
    let [first, second] = &records;
    let names: BTreeSet<&String> = first.keys().chain(second.keys()).collect();
    let recorded = |record: &BTreeMap<String, String>, name| record.get(name).map_or("–".to_owned(), String::clone);
    let told = names.into_iter().map(|name| [name.clone(), recorded(first, name), recorded(second, name)]);
    told.filter(|[_, first, second]| first != second).collect()
}

fn outcome(verdict: &Verdict) -> String {
    match verdict {
        Verdict::Correct(_) => "right".to_owned(),
        Verdict::Wrong(reason) => format!("wrong ({reason})"),
        Verdict::Unchecked(_) => "unchecked".to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use experiments::definition::{Case, Measurement};
    use zonotope::tally::{Operation, OperationCounts, Tally};

    fn row(n: usize, turns: u64, ratio: f64) -> CountRow {
        let mut counts = OperationCounts::default();
        counts.add(Operation::Turn, turns);
        let measurement = Measurement::new(&counts, 1, Verdict::Correct("checked".to_owned()));
        CountRow::new(&Case::new(1, "toy", "disc", "m", n, 0), Ok(measurement.with_value("ratio", ratio)))
    }

    #[test]
    fn differences_name_the_case_and_the_quantity() {
        let first = [row(4, 10, 0.5), row(8, 20, 0.5), row(16, 40, 0.5)];
        let second = [row(16, 41, 0.25), row(8, 20, 0.5), row(32, 80, 0.5), row(64, 160, 0.5)];
        let comparison = Comparison::of(&first, &second);
        assert_eq!((comparison.common, comparison.alone), (2, [1, 2]));
        let told: Vec<String> = comparison.differences.iter().map(Difference::to_string).collect();
        assert_eq!(told, ["  toy: m on disc, n = 16, instance 0: ratio 0.5, then 0.25; turn 40, then 41"]);
        assert!(Comparison::of(&first, &first).differences.is_empty());
    }

    #[test]
    fn failures_are_differences_and_other_seeds_are_other_instances() {
        let case = Case::new(1, "toy", "disc", "m", 4, 0);
        let failed = [CountRow::new(&case, Err("no".to_owned()))];
        let told = Comparison::of(&[row(4, 10, 0.5)], &failed).differences[0].to_string();
        assert!(told.contains("outcome right, then failed (no)") && told.contains("ratio 0.5, then –"), "{told}");
        let reseeded = CountRow::new(&Case::new(2, "toy", "disc", "m", 4, 0), Err("no".to_owned()));
        let reseeded = [reseeded];
        let comparison = Comparison::of(&failed, &reseeded);
        assert_eq!((comparison.common, comparison.reseeded, comparison.differences.len()), (1, 1, 0));
    }
}
