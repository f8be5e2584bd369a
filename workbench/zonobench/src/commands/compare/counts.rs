//! Counts, values and answers of two runs, case by case.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt;

use crate::commands::table::counted;
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
    /// The number of compared cases of each experiment.
    compared: BTreeMap<&'a str, usize>,
}

/// A case whose records differ.
#[derive(Debug)]
pub(super) struct Difference<'a> {
    key: &'a CaseKey,
    /// The quantities that differ, each with what the first and the second run recorded.
    quantities: Vec<[String; 3]>,
    /// The sums of all counts in the first and in the second run, where both were measured.
    operations: Option<[u64; 2]>,
}

impl Difference<'_> {
    /// The method and the instance.
    fn place(&self) -> String {
        let CaseKey { family, variant, n, instance, .. } = self.key;
        format!("{variant} on {family}, n = {n}, instance {instance}")
    }

    /// The method, the instance and what differs.
    fn in_words(&self) -> String {
        let quantities: Vec<String> =
            self.quantities.iter().map(|[name, first, second]| format!("{name} {first}, then {second}")).collect();
        format!("{}: {}", self.place(), quantities.join("; "))
    }
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
        let mut compared = BTreeMap::new();
        for (row, _) in &pairs {
            *compared.entry(row.key.experiment.as_str()).or_default() += 1;
        }
        let differing = pairs.into_iter().map(|(a, b)| {
            let operations = operations(a).zip(operations(b)).map(<[u64; 2]>::from);
            Difference { key: &a.key, quantities: differing(a, b), operations }
        });
        Self {
            common,
            reseeded: others.len(),
            alone: [first.len() - common, second.len() - common],
            differences: differing.filter(|difference| !difference.quantities.is_empty()).collect(),
            compared,
        }
    }

    /// The experiments with differences, that with the largest ratio first.
    pub(super) fn by_experiment(&self) -> Vec<OfExperiment<'_>> {
        let mut found: BTreeMap<&str, Vec<&Difference<'_>>> = BTreeMap::new();
        for difference in &self.differences {
            found.entry(&difference.key.experiment).or_default().push(difference);
        }
        let compared = |id| self.compared.get(id).copied().unwrap_or_default();
        let of_one = |(id, differences)| OfExperiment::of(id, compared(id), differences);
        let mut all: Vec<OfExperiment<'_>> = found.into_iter().map(of_one).collect();
        all.sort_by(|a, b| b.spread().total_cmp(&a.spread()));
        all
    }
}

/// The cases of an experiment whose records differ.
#[derive(Debug)]
pub(super) struct OfExperiment<'a> {
    id: &'a str,
    compared: usize,
    differing: usize,
    /// The numbers of cases that have more and fewer operations in the second run.
    more_and_fewer: [usize; 2],
    /// The number that differs by the largest ratio, with that and its case; none where no two numbers have one.
    largest: Option<(f64, String)>,
    /// The first case that differs, in words.
    first: String,
}

impl<'a> OfExperiment<'a> {
    fn of(id: &'a str, compared: usize, differences: Vec<&Difference<'_>>) -> Self {
        let operations = differences.iter().filter_map(|difference| difference.operations);
        let mut more_and_fewer = [0; 2];
        operations.for_each(|[first, second]| {
            more_and_fewer[0] += usize::from(second > first);
            more_and_fewer[1] += usize::from(second < first);
        });
        let ratios = differences.iter().flat_map(|difference| {
            let place = difference.place();
            let ratios = difference.quantities.iter().filter_map(ratio);
            ratios.map(move |(ratio, name)| (ratio, format!("{name} of {place}")))
        });
        let largest = ratios.max_by(|(a, _), (b, _)| spread(*a).total_cmp(&spread(*b)));
        let first = differences.first().map(|difference| difference.in_words()).unwrap_or_default();
        Self { id, compared, differing: differences.len(), more_and_fewer, largest, first }
    }

    /// The distance of the largest ratio from 1, as a factor's logarithm.
    fn spread(&self) -> f64 {
        self.largest.as_ref().map_or(0.0, |(ratio, _)| spread(*ratio))
    }
}

/// The ratio of the second number of a quantity to the first one, where both are numbers and neither is zero.
fn ratio([name, first, second]: &[String; 3]) -> Option<(f64, &str)> {
    let number = |text: &String| text.parse().ok().filter(|number: &f64| *number != 0.0 && number.is_finite());
    Some((number(second)? / number(first)?, name.as_str())).filter(|_| name != "answer")
}

fn spread(ratio: f64) -> f64 {
    libm::log(ratio.abs()).abs()
}

/// The numbers of cases that are alike and differ, and by what.
impl fmt::Display for OfExperiment<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { id, compared, differing, more_and_fewer: [more, fewer], .. } = self;
        let alike = counted(compared - differing, "case", "cases");
        write!(f, "  {id}: {alike} alike, {differing} not: {more} with more operations, {fewer} with fewer")?;
        match &self.largest {
            Some((ratio, of)) => write!(f, "; the largest ratio is {ratio:.4}, {of}"),
            None => write!(f, "; the first: {}", self.first),
        }
    }
}

/// The experiment and the instance, and what differs.
impl fmt::Display for Difference<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "  {}: {}", self.key.experiment, self.in_words())
    }
}

/// All operations of a case; none if it failed.
fn operations(row: &CountRow) -> Option<u64> {
    match &row.outcome {
        CountOutcome::Measured { counts, .. } => Some(counts.values().sum()),
        CountOutcome::Failed { .. } => None,
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
        let summed: Vec<String> = comparison.by_experiment().iter().map(OfExperiment::to_string).collect();
        let expected = "  toy: 1 case alike, 1 not: 1 with more operations, 0 with fewer; the largest ratio is \
                        0.5000, ratio of m on disc, n = 16, instance 0";
        assert_eq!(summed, [expected]);
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
