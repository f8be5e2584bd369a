//! Numbers of the records that sentences about what was measured speak of.

use crate::analysis;
use crate::definition::Quantity;
use crate::record::{CountOutcome, CountRow};
use crate::runner::Records;

/// The records of a run, to be asked for single numbers.
#[derive(Clone, Copy, Debug)]
pub struct Measured<'a> {
    records: &'a Records,
}

/// The place where numbers are looked up: an experiment, one of its inputs and one of its methods.
#[derive(Clone, Copy, Debug)]
pub struct Series<'s> {
    /// The experiment's id.
    pub experiment: &'s str,
    /// The family's id or the name of a real input.
    pub input: &'s str,
    /// The variant's id.
    pub method: &'s str,
}

/// A number with the input and the size at which it was measured.
#[derive(Clone, Debug, PartialEq)]
pub struct Extreme {
    /// The number.
    pub number: f64,
    /// The family's id or the name of a real input.
    pub input: String,
    /// The size.
    pub n: u64,
}

impl<'a> Measured<'a> {
    /// The numbers of these records.
    pub fn of(records: &'a Records) -> Self {
        Self { records }
    }

    /// The size and the number of every right answer, by increasing size.
    pub fn samples(&self, series: Series<'_>, quantity: Quantity) -> Vec<(f64, f64)> {
        analysis::samples(series.experiment, series.input, series.method, quantity, self.records).0
    }

    /// The largest size, and the middle one of the numbers there.
    pub fn at_largest(&self, series: Series<'_>, quantity: Quantity) -> Option<(u64, f64)> {
        let samples = self.samples(series, quantity);
        let largest = samples.last()?.0;
        Some((largest as u64, self.at(series, quantity, largest)?))
    }

    /// The largest size, and the least and the greatest of the numbers there.
    pub fn range_at_largest(&self, series: Series<'_>, quantity: Quantity) -> Option<(u64, [f64; 2])> {
        let samples = self.samples(series, quantity);
        let largest = samples.last()?.0;
        let here = samples.into_iter().filter(|(n, _)| *n == largest).map(|(_, number)| number);
        let range = here.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], x| [low.min(x), high.max(x)]);
        Some((largest as u64, range))
    }

    /// The middle one of the numbers at a size, the greater one of two.
    pub fn at(&self, series: Series<'_>, quantity: Quantity, size: f64) -> Option<f64> {
        let samples = self.samples(series, quantity);
        let mut here: Vec<f64> = samples.into_iter().filter(|(n, _)| *n == size).map(|(_, number)| number).collect();
        here.sort_by(f64::total_cmp);
        here.get(here.len() / 2).copied()
    }

    /// The smallest size, and the middle one of the numbers there.
    pub fn at_smallest(&self, series: Series<'_>, quantity: Quantity) -> Option<(u64, f64)> {
        let smallest = self.samples(series, quantity).first()?.0;
        Some((smallest as u64, self.at(series, quantity, smallest)?))
    }

    /// The inputs of a method in an experiment, each once, in the order of the records.
    pub fn inputs(&self, experiment: &str, method: &str) -> Vec<&'a str> {
        let of_method = |row: &&CountRow| row.key.experiment == experiment && row.key.variant == method;
        let mut inputs: Vec<&str> = Vec::new();
        for row in self.records.counts.iter().filter(of_method) {
            if !inputs.contains(&row.key.family.as_str()) {
                inputs.push(&row.key.family);
            }
        }
        inputs
    }

    /// The numbers at the largest size of each input, with the inputs.
    pub fn over_inputs(&self, experiment: &str, method: &str, quantity: Quantity) -> Vec<Extreme> {
        let inputs = self.inputs(experiment, method).into_iter();
        let at_largest = inputs.filter_map(|input| {
            let (n, number) = self.at_largest(Series { experiment, input, method }, quantity)?;
            Some(Extreme { number, input: input.to_owned(), n })
        });
        at_largest.collect()
    }

    /// The numbers of one method over those of another at the largest size of each input, with the inputs.
    pub fn ratios(&self, experiment: &str, [method, other]: [&str; 2], quantity: Quantity) -> Vec<(&'a str, f64)> {
        let of = |input, method| Some(self.at_largest(Series { experiment, input, method }, quantity)?.1);
        let inputs = self.inputs(experiment, method).into_iter();
        inputs.filter_map(|input| Some((input, of(input, method)? / of(input, other)?))).collect()
    }

    /// The least and the greatest of a number over all inputs and sizes of a method, with where they were measured;
    /// `number` makes it from the size and the quantity.
    pub fn extremes(
        &self,
        experiment: &str,
        method: &str,
        quantity: Quantity,
        number: impl Fn(f64, f64) -> f64,
    ) -> Option<[Extreme; 2]> {
        let mut ends: Option<[Extreme; 2]> = None;
        for input in self.inputs(experiment, method) {
            for (n, value) in self.samples(Series { experiment, input, method }, quantity) {
                let here = Extreme { number: number(n, value), input: input.to_owned(), n: n as u64 };
                ends = Some(match ends {
                    None => [here.clone(), here],
                    Some([least, greatest]) if here.number < least.number => [here, greatest],
                    Some([least, greatest]) if here.number > greatest.number => [least, here],
                    Some(ends) => ends,
                });
            }
        }
        ends
    }

    /// The sum of a value over the runs of a method on one input, those with wrong answers included.
    pub fn total_on(&self, series: Series<'_>, value: &str) -> Option<f64> {
        let of_series = |row: &&CountRow| {
            (row.key.experiment.as_str(), row.key.family.as_str(), row.key.variant.as_str())
                == (series.experiment, series.input, series.method)
        };
        let numbers = self.records.counts.iter().filter(of_series).filter_map(|row| row.value(value));
        numbers.reduce(|sum, number| sum + number)
    }

    /// The sum of a value over all runs of a method, those with wrong answers included.
    pub fn total(&self, experiment: &str, method: &str, value: &str) -> Option<f64> {
        let of_method = |row: &&CountRow| row.key.experiment == experiment && row.key.variant == method;
        let value = |row: &CountRow| match &row.outcome {
            CountOutcome::Measured { values, .. } => values.get(value).copied(),
            CountOutcome::Failed { .. } => None,
        };
        self.records.counts.iter().filter(of_method).filter_map(value).reduce(|sum, number| sum + number)
    }
}

/// The least and the greatest of some numbers.
pub fn range(numbers: impl IntoIterator<Item = f64>) -> Option<[f64; 2]> {
    numbers.into_iter().fold(None, |ends, number| {
        let [low, high] = ends.unwrap_or([number, number]);
        Some([low.min(number), high.max(number)])
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::definition::{Case, Measurement, Verdict};
    use crate::environment::Environment;
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
        let records = Records { counts, times: Vec::new(), environment: Environment::current(), elsewhere: Vec::new() };
        let found = Measured::of(&records);
        let series = Series { experiment: "wrong-answers", input: "flat_bodies", method: "by_gjk" };
        assert_eq!(found.at_largest(series, Quantity::Value("wrong")), Some((32, 5.0)));
        assert_eq!(found.at_largest(series, Quantity::Value("other")), None);
        assert_eq!(found.total("wrong-answers", "by_gjk", "wrong"), Some(89.0));
        assert_eq!(found.total("wrong-answers", "by_lad", "wrong"), None);
        assert_eq!(found.total_on(series, "wrong"), Some(89.0));
        assert_eq!(found.at_smallest(series, Quantity::Value("wrong")), Some((8, 1.0)));
        let same = found.ratios("wrong-answers", ["by_gjk", "by_gjk"], Quantity::Value("wrong"));
        assert_eq!(same, [("flat_bodies", 1.0)]);
        assert!(found.ratios("wrong-answers", ["by_gjk", "by_lad"], Quantity::Value("wrong")).is_empty());
        let ends = found.extremes("wrong-answers", "by_gjk", Quantity::Value("wrong"), |n, value| value / n);
        let [least, greatest] = ends.expect("there are right answers");
        assert_eq!((least.number, least.n), (0.125, 8));
        assert_eq!((greatest.number, greatest.n), (9.0 / 32.0, 32));
        assert_eq!(range([2.0, 1.0, 3.0]), Some([1.0, 3.0]));
        assert_eq!(range([]), None);
    }
}
