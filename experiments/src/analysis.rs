//! From records to growth laws: one fit for every fit plan, family and range of sizes.

use crate::definition::{Bound, Experiment, FitPlan, Quantity, StatedBy};
use crate::fit::{self, FitError, Growth, GrowthModel, LackOfFit, ModelFit, ModelVerdict};
use crate::record::CountRow;
use crate::runner::Records;
use std::collections::BTreeMap;

/// The sizes that a law is fitted on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Range {
    /// All sizes.
    Whole,
    /// The last four doublings of the size.
    LastDoublings,
}

/// The fit of one plan on one family.
#[derive(Clone, Debug, PartialEq)]
pub struct FittedGrowth {
    /// The experiment's id.
    pub experiment: &'static str,
    /// The family's id.
    pub family: &'static str,
    /// The variant's id.
    pub variant: &'static str,
    /// The quantity that was fitted.
    pub quantity: Quantity,
    /// The bound that the theory gives.
    pub bound: Option<Bound>,
    /// The growth that the quantity cannot stay below.
    pub floor: Option<GrowthModel>,
    /// Which sizes were fitted.
    pub range: Range,
    /// The samples (n, y), by increasing size.
    pub samples: Vec<(f64, f64)>,
    /// The number of rows that were left out because they failed, were wrong, or had their time voided.
    pub left_out: usize,
    /// The fit.
    pub growth: Result<Growth, FitError>,
}

impl FittedGrowth {
    /// The fit of the bound, when there is one and the fit succeeded.
    pub fn bound_fit(&self) -> Option<&ModelFit> {
        self.growth.as_ref().ok()?.model(self.bound?.model)
    }

    /// The verdict on the bound, when there is one and the fit succeeded. What has to read its input does not grow
    /// slower than that: where its bound is the input, it is within the bound, though the samples are below it. A bound
    /// that is a number is kept where every sample keeps it.
    pub fn verdict(&self) -> Option<ModelVerdict> {
        let fit = self.bound_fit()?;
        if let (Some(most), Some(greatest)) = (self.bound?.most, self.greatest()) {
            return Some(if greatest <= most { ModelVerdict::Kept } else { ModelVerdict::Above });
        }
        let is_at_floor = self.floor == Some(fit.model) && fit.verdict == ModelVerdict::Below;
        Some(if is_at_floor { ModelVerdict::Within } else { fit.verdict })
    }

    /// The greatest of the samples.
    pub fn greatest(&self) -> Option<f64> {
        self.samples.iter().map(|sample| sample.1).reduce(f64::max)
    }

    /// The greatest of the samples, where the bound is a number that none may exceed.
    pub fn beside_number(&self) -> Option<f64> {
        self.bound?.most.and_then(|_| self.greatest())
    }

    /// Whether the samples keep the bound; `None` without a bound, without a fit, and where that is undecided.
    pub fn supports_bound(&self) -> Option<bool> {
        self.verdict()?.keeps_bound()
    }

    /// Whether the samples grow slower than the quantity can in the end, so that lower-order terms show.
    pub fn shows_lower_order_terms(&self) -> bool {
        let floor = self.floor.and_then(|floor| self.growth.as_ref().ok()?.model(floor));
        floor.is_some_and(|fit| fit.verdict == ModelVerdict::Below)
    }

    /// The place of the paper that states the bound.
    pub fn paper_place(&self) -> Option<&'static str> {
        match self.bound?.stated_by {
            StatedBy::Paper(place) => Some(place),
            StatedBy::Workbench => None,
        }
    }

    /// Whether the law bends: of the samples over the bound, or of the power law where there is no bound.
    pub fn lack_of_fit(&self) -> Option<LackOfFit> {
        let power = || self.growth.as_ref().ok().map(|growth| growth.lack_of_fit);
        self.bound_fit().map(|fit| fit.lack_of_fit).or_else(power)
    }

    /// Whether the fit depends on the operation counts alone, so that it is the same on every machine.
    pub fn is_deterministic(&self) -> bool {
        !matches!(self.quantity, Quantity::Time(_))
    }
}

/// All fits of one experiment: each plan on each of its families, over all sizes and over the last doublings.
pub fn fits(experiment: &Experiment, records: &Records) -> Vec<FittedGrowth> {
    experiment.fits.iter().flat_map(|plan| of_plan(experiment.id, plan, records)).collect()
}

fn of_plan(experiment: &'static str, plan: &FitPlan, records: &Records) -> Vec<FittedGrowth> {
    let sampled = |&family: &&'static str| {
        let (mut samples, left_out) = samples(experiment, family, plan.variant, plan.quantity, records);
        samples.retain(|&(n, _)| n >= plan.smallest as f64);
        (family, (samples, left_out))
    };
    let families: Vec<_> = plan.families.iter().map(sampled).collect();
    let fitted = |family, range, samples: &[(f64, f64)], left_out| FittedGrowth {
        experiment,
        family,
        variant: plan.variant,
        quantity: plan.quantity,
        bound: plan.bound,
        floor: plan.floor,
        range,
        growth: fit::fit_growth(samples, plan.models),
        samples: samples.to_vec(),
        left_out,
    };
    let whole = families.iter().map(|(family, (samples, left_out))| fitted(family, Range::Whole, samples, *left_out));
    let last = families.iter().filter_map(|(family, (samples, left_out))| {
        let last = fit::last_doublings(samples);
        (last.len() < samples.len()).then(|| fitted(family, Range::LastDoublings, last, *left_out))
    });
    whole.chain(last).collect()
}

/// The samples (n, y) of a quantity by increasing size, and the number of rows that are no evidence.
pub fn samples(
    experiment: &str,
    family: &str,
    variant: &str,
    quantity: Quantity,
    records: &Records,
) -> (Vec<(f64, f64)>, usize) {
    let found: Vec<(usize, Option<f64>)> = match quantity {
        Quantity::Time(lap) => median_times(experiment, family, variant, lap, records),
        _ => records
            .counts
            .iter()
            .filter(|row| row.key.experiment == experiment && row.key.family == family && row.key.variant == variant)
            .map(|row| (row.key.n, if row.fault().is_some() { None } else { of_row(row, quantity) }))
            .collect(),
    };
    let mut samples: Vec<(f64, f64)> = found.iter().filter_map(|&(n, y)| Some((n as f64, y?))).collect();
    samples.sort_by(|a, b| a.0.total_cmp(&b.0));
    let left_out = found.len() - samples.len();
    (samples, left_out)
}

fn of_row(row: &CountRow, quantity: Quantity) -> Option<f64> {
    match quantity {
        Quantity::AllCounts => row.all_counts().map(|count| count as f64),
        Quantity::Count(name) => row.count(name).map(|count| count as f64),
        Quantity::Value(name) => row.value(name),
        Quantity::Time(_) => None,
    }
}

/// The median time of each case; a case with a voided or failed repetition has none.
fn median_times(
    experiment: &str,
    family: &str,
    variant: &str,
    lap: &str,
    records: &Records,
) -> Vec<(usize, Option<f64>)> {
    let mut cases: BTreeMap<(usize, u32), Vec<Option<u64>>> = BTreeMap::new();
    for row in &records.times {
        let key = &row.key;
        if key.experiment == experiment && key.family == family && key.variant == variant {
            cases.entry((key.n, key.instance)).or_default().push(row.lap_ns(lap));
        }
    }
    cases.into_iter().map(|((n, _), laps)| (n, laps.into_iter().collect::<Option<Vec<u64>>>().map(median))).collect()
}

/// The middle value, or the mean of the two middle ones, of at least one number.
pub fn median(mut values: Vec<u64>) -> f64 {
    values.sort_unstable();
    let middle = values.len() / 2;
    if values.len() % 2 == 1 {
        values[middle] as f64
    } else {
        (values[middle - 1] as f64 + values[middle] as f64) / 2.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::definition::{Case, Measurement, Verdict};
    use crate::environment::Environment;
    use crate::record::{CountRow, TimeOutcome, TimeRow};

    fn count_row(n: usize, count: u64, verdict: Verdict) -> CountRow {
        let measurement = Measurement {
            counts: BTreeMap::from([("a".to_owned(), count), ("b".to_owned(), 1)]),
            values: BTreeMap::from([("ratio".to_owned(), 1.5)]),
            digest: 0,
            verdict,
        };
        CountRow::new(&Case::new(1, "toy", "disc", "m", n, 0), Ok(measurement))
    }

    fn time_row(n: usize, repetition: u32, outcome: TimeOutcome) -> TimeRow {
        let key = (&Case::new(1, "toy", "disc", "m", n, 0)).into();
        TimeRow { key, repetition, environment: String::new(), outcome }
    }

    #[test]
    fn samples_leave_out_what_is_no_evidence() {
        let laps = |ns| BTreeMap::from([("total".to_owned(), ns)]);
        let right = || Verdict::Correct("checked".to_owned());
        let records = Records {
            counts: vec![
                count_row(8, 80, right()),
                count_row(4, 40, right()),
                count_row(16, 7, Verdict::Wrong("bad".to_owned())),
            ],
            times: vec![
                time_row(4, 0, TimeOutcome::Valid { laps_ns: laps(10) }),
                time_row(4, 1, TimeOutcome::Valid { laps_ns: laps(40) }),
                time_row(4, 2, TimeOutcome::Valid { laps_ns: laps(20) }),
                time_row(8, 0, TimeOutcome::Valid { laps_ns: laps(10) }),
                time_row(8, 1, TimeOutcome::Void { laps_ns: laps(11), reason: "bad".to_owned() }),
            ],
            environment: Environment::current(),
            elsewhere: Vec::new(),
        };
        let of = |quantity| samples("toy", "disc", "m", quantity, &records);
        assert_eq!(of(Quantity::Count("a")), (vec![(4.0, 40.0), (8.0, 80.0)], 1));
        assert_eq!(of(Quantity::AllCounts), (vec![(4.0, 41.0), (8.0, 81.0)], 1));
        assert_eq!(of(Quantity::Value("ratio")), (vec![(4.0, 1.5), (8.0, 1.5)], 1));
        assert_eq!(of(Quantity::Time("total")), (vec![(4.0, 20.0)], 1));
        assert_eq!(samples("toy", "disc", "other", Quantity::AllCounts, &records), (vec![], 0));
    }

    /// A law on samples of y(n) at 2^6 to 2^14, with a floor and the size from which it is fitted.
    fn fitted(y: impl Fn(f64) -> f64, floor: Option<GrowthModel>, smallest: usize) -> Vec<FittedGrowth> {
        let plan = FitPlan {
            floor,
            smallest,
            ..FitPlan::of_operations("m", &["disc"]).within(Bound::of_paper(GrowthModel::Linear, "Theorem 0"))
        };
        let row = |log: u32| count_row(1 << log, y(f64::from(1 << log)) as u64, Verdict::Correct(String::new()));
        let records = Records {
            counts: (6..=14).map(row).collect(),
            times: Vec::new(),
            environment: Environment::current(),
            elsewhere: Vec::new(),
        };
        of_plan("toy", &plan, &records)
    }

    #[test]
    fn laws_are_fitted_over_all_sizes_and_over_the_last_doublings() {
        let fits = fitted(|n| 3.0 * n, None, 0);
        assert_eq!([fits[0].range, fits[1].range], [Range::Whole, Range::LastDoublings]);
        assert_eq!(fits.iter().map(|fit| fit.samples.len()).collect::<Vec<_>>(), [9, 5]);
        assert_eq!((fits[1].verdict(), fits[1].paper_place()), (Some(ModelVerdict::Within), Some("Theorem 0")));
    }

    /// Small inputs are read a hundred times, larger ones twice; the law is that of the larger ones.
    #[test]
    fn where_a_method_changes_the_law_begins() {
        let switched = |n: f64| if n < 1024.0 { 100.0 * n } else { 2.0 * n };
        assert_eq!(fitted(switched, None, 0)[0].verdict(), Some(ModelVerdict::Below));
        let fits = fitted(switched, None, 1024);
        assert_eq!((fits.len(), fits[0].samples.len(), fits[0].verdict()), (1, 5, Some(ModelVerdict::Within)));
    }

    #[test]
    fn what_reads_its_input_is_not_below_it() {
        let slow = |n: f64| n + 200.0 * n.sqrt();
        let [free, reading] = [None, Some(GrowthModel::Linear)].map(|floor| fitted(slow, floor, 0).swap_remove(0));
        assert_eq!((free.verdict(), free.shows_lower_order_terms()), (Some(ModelVerdict::Below), false));
        assert_eq!((reading.verdict(), reading.shows_lower_order_terms()), (Some(ModelVerdict::Within), true));
        assert_eq!(reading.supports_bound(), Some(true));
    }

    /// The error of one grid goes up and down with whether it meets the lattice; each keeps the number, or one does
    /// not.
    #[test]
    fn a_bound_that_is_a_number_is_decided_by_each_sample() {
        let plan = FitPlan::new(Quantity::Count("a"), "m", &["disc"], GrowthModel::ALL);
        let row = |log: u32| count_row(1 << log, 50 + 40 * u64::from(log % 2), Verdict::Correct(String::new()));
        let records = Records {
            counts: (6..=14).map(row).collect(),
            times: Vec::new(),
            environment: Environment::current(),
            elsewhere: Vec::new(),
        };
        let verdict = |bound: Bound| of_plan("toy", &plan.within(bound), &records)[0].verdict();
        assert_eq!(verdict(Bound::of_paper(GrowthModel::Constant, "Lemma 0")), Some(ModelVerdict::Undecided));
        assert_eq!(verdict(Bound::number_of_paper(90.0, "Lemma 0")), Some(ModelVerdict::Kept));
        assert_eq!(verdict(Bound::number_of_paper(89.0, "Lemma 0")), Some(ModelVerdict::Above));
        let fits = of_plan("toy", &plan.within(Bound::number_of_paper(100.0, "Lemma 0")), &records);
        assert_eq!((fits[0].greatest(), fits[0].beside_number()), (Some(90.0), Some(90.0)));
    }

    #[test]
    fn the_median_of_an_even_number_is_a_mean() {
        assert_eq!(median(vec![4, 1, 3, 2]), 2.5);
        assert_eq!(median(vec![9]), 9.0);
    }
}
