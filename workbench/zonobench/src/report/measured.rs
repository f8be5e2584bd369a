//! Numbers of the records that sentences of the report speak of.

use experiments::analysis;
use experiments::definition::Quantity;
use experiments::record::{CountOutcome, CountRow};
use experiments::runner::Records;

/// The records of a run, to be asked for single numbers.
#[derive(Clone, Copy, Debug)]
pub struct Measured<'a> {
    records: &'a Records,
}

/// Where numbers are looked up: an experiment, one of its inputs and one of its methods.
#[derive(Clone, Copy, Debug)]
pub(super) struct Series {
    /// The experiment's id.
    pub(super) experiment: &'static str,
    /// The family's id or the name of a real input.
    pub(super) input: &'static str,
    /// The variant's id.
    pub(super) method: &'static str,
}

impl<'a> Measured<'a> {
    /// The numbers of these records.
    pub(super) fn of(records: &'a Records) -> Self {
        Self { records }
    }

    /// The size and the number of every right answer, by increasing size.
    pub(super) fn samples(&self, series: Series, quantity: Quantity) -> Vec<(f64, f64)> {
        analysis::samples(series.experiment, series.input, series.method, quantity, self.records).0
    }

    /// The largest size, and the middle one of the numbers there.
    pub(super) fn at_largest(&self, series: Series, quantity: Quantity) -> Option<(u64, f64)> {
        let samples = self.samples(series, quantity);
        let largest = samples.last()?.0;
        Some((largest as u64, self.at(series, quantity, largest)?))
    }

    /// The middle one of the numbers at a size.
    pub(super) fn at(&self, series: Series, quantity: Quantity, size: f64) -> Option<f64> {
        let samples = self.samples(series, quantity);
        let mut here: Vec<f64> = samples.into_iter().filter(|(n, _)| *n == size).map(|(_, number)| number).collect();
        here.sort_by(f64::total_cmp);
        here.get(here.len() / 2).copied()
    }

    /// The sum of a value over all runs of a method, those with wrong answers included.
    pub(super) fn total(&self, experiment: &str, method: &str, value: &str) -> Option<f64> {
        let of_method = |row: &&CountRow| row.key.experiment == experiment && row.key.variant == method;
        let value = |row: &CountRow| match &row.outcome {
            CountOutcome::Measured { values, .. } => values.get(value).copied(),
            CountOutcome::Failed { .. } => None,
        };
        self.records.counts.iter().filter(of_method).filter_map(value).reduce(|sum, number| sum + number)
    }
}

/// The least and the greatest of some numbers.
pub(super) fn range(numbers: impl IntoIterator<Item = f64>) -> Option<[f64; 2]> {
    numbers.into_iter().fold(None, |ends, number| {
        let [low, high] = ends.unwrap_or([number, number]);
        Some([low.min(number), high.max(number)])
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use experiments::definition::{Case, Measurement, Verdict};
    use experiments::environment::Environment;
    use zonotope::tally::OperationCounts;

    fn row(n: usize, instance: u32, wrong: f64, verdict: Verdict) -> CountRow {
        let case = Case::new(1, "wrong-answers", "flat_bodies", "by_gjk", n, instance);
        CountRow::new(&case, Ok(Measurement::new(&OperationCounts::default(), 0, verdict).with_value("wrong", wrong)))
    }

    #[test]
    fn numbers_are_those_of_the_largest_size_or_sums_of_all() {
        let right = || Verdict::Correct("checked".to_owned());
        let counts = vec![
            row(8, 0, 1.0, right()),
            row(32, 0, 4.0, right()),
            row(32, 1, 9.0, right()),
            row(32, 2, 5.0, right()),
            row(64, 0, 70.0, Verdict::Wrong("no evidence, and counted in sums".to_owned())),
        ];
        let records = Records { counts, times: Vec::new(), environment: Environment::current() };
        let found = Measured::of(&records);
        let series = Series { experiment: "wrong-answers", input: "flat_bodies", method: "by_gjk" };
        assert_eq!(found.at_largest(series, Quantity::Value("wrong")), Some((32, 5.0)));
        assert_eq!(found.at_largest(series, Quantity::Value("other")), None);
        assert_eq!(found.total("wrong-answers", "by_gjk", "wrong"), Some(89.0));
        assert_eq!(found.total("wrong-answers", "by_lad", "wrong"), None);
        assert_eq!(range([2.0, 1.0, 3.0]), Some([1.0, 3.0]));
        assert_eq!(range([]), None);
    }
}
