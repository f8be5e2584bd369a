//! Times of two runs: for every method of an experiment the ratio of the second run to the first.
//!
//! A case has the ratio of its medians over the repetitions. The ratio of a method is the geometric mean over its
//! cases, with the 95 % interval of Student's t for the mean of the logarithms: how much single cases scatter. The
//! cases of one run share whatever else the machine did, and scatter less than two runs differ: an interval is no
//! verdict, and few cases have none. An experiment has the geometric mean over all of its methods and cases.

use std::collections::BTreeMap;
use std::fmt::Write;

use experiments::analysis::median;
use experiments::fit::t_quantile_975;
use experiments::record::{TimeOutcome, TimeRow};

/// An experiment, a method, and what was timed.
type Method<'a> = (&'a str, &'a str, &'a str);

/// The times of one run: for every method the repetitions of each case.
type Samples<'a> = BTreeMap<Method<'a>, BTreeMap<&'a str, Vec<u64>>>;

/// The ratios of the cases of a method, by case.
type Ratios<'a> = Vec<(&'a str, f64)>;

/// The ratios as text: what they are, and a line for an experiment, or for each of its methods and cases.
pub(super) fn text(first: &[TimeRow], second: &[TimeRow], with_all: bool) -> (String, Vec<String>) {
    let mut text = String::new();
    let [before, after] = [first, second].map(samples);
    let mut line = |words: String| writeln!(text, "{words}").expect("writing to a string does not fail");
    let ratios: Vec<(Method<'_>, Ratios<'_>)> = before
        .iter()
        .filter_map(|(method, cases)| {
            let others = after.get(method)?;
            let ratios = cases.iter().filter_map(|(case, ns)| Some((*case, ratio(others.get(case)?, ns)?)));
            let ratios: Ratios<'_> = ratios.collect();
            (!ratios.is_empty()).then_some((*method, ratios))
        })
        .collect();
    if ratios.is_empty() {
        line("times         no time is in both runs".to_owned());
        return (text, Vec::new());
    }
    line("times         of the second run as a multiple of the first".to_owned());
    line(
        "              they depend on the load of the machines, which is not recorded: no ratio is a verdict"
            .to_owned(),
    );
    let environments = [first, second].map(|rows| rows.first().map(|row| row.environment.as_str()));
    if environments[0] != environments[1] {
        line("              measured by different programs or on different machines".to_owned());
    }
    let void = [first, second].map(|rows| rows.iter().filter(|row| !is_valid(row)).count());
    if void != [0, 0] {
        line(format!("              {} and {} times are void or failed", void[0], void[1]));
    }
    if with_all {
        line("              with the 95 % intervals of geometric means over cases".to_owned());
        (text, ratios.iter().flat_map(by_case).collect())
    } else {
        (text, by_experiment(&ratios))
    }
}

/// A line for a method, and one for each of its cases.
fn by_case(((experiment, method, lap), ratios): &(Method<'_>, Ratios<'_>)) -> Vec<String> {
    let alone: Vec<f64> = ratios.iter().map(|(_, ratio)| *ratio).collect();
    let of_cases = ratios.iter().map(|(case, ratio)| format!("    {case}, {lap}: {ratio:.3}"));
    std::iter::once(format!("  {experiment}: {method}, {lap}: {}", mean(&alone))).chain(of_cases).collect()
}

/// A line for each experiment, that with the ratio farthest from 1 first.
fn by_experiment(ratios: &[(Method<'_>, Ratios<'_>)]) -> Vec<String> {
    let mut experiments: BTreeMap<&str, Vec<f64>> = BTreeMap::new();
    for ((experiment, ..), ratios) in ratios {
        experiments.entry(experiment).or_default().extend(ratios.iter().map(|(_, ratio)| *ratio));
    }
    let mut lines: Vec<(f64, String)> = experiments
        .into_iter()
        .map(|(experiment, ratios)| {
            let logarithms: Vec<f64> = ratios.iter().map(|&ratio| libm::log(ratio)).collect();
            let middle = logarithms.iter().sum::<f64>() / logarithms.len() as f64;
            let [least, greatest] = range(&ratios);
            let shorter = ratios.iter().filter(|&&ratio| ratio < 1.0).count();
            let longer = ratios.iter().filter(|&&ratio| ratio > 1.0).count();
            let average = libm::exp(middle);
            let words = format!(
                "  {experiment}: {average:.3} on average, from {least:.3} to {greatest:.3}; {shorter} shorter, \
                 {longer} longer"
            );
            (middle.abs(), words)
        })
        .collect();
    lines.sort_by(|(a, _), (b, _)| b.total_cmp(a));
    lines.into_iter().map(|(_, words)| words).collect()
}

/// The least and the greatest ratio.
fn range(ratios: &[f64]) -> [f64; 2] {
    [ratios.iter().copied().fold(f64::INFINITY, f64::min), ratios.iter().copied().fold(0.0, f64::max)]
}

fn is_valid(row: &TimeRow) -> bool {
    matches!(row.outcome, TimeOutcome::Valid { .. })
}

fn samples(rows: &[TimeRow]) -> Samples<'_> {
    let mut samples = Samples::new();
    for row in rows {
        let TimeOutcome::Valid { laps_ns } = &row.outcome else { continue };
        for (lap, ns) in laps_ns {
            let method = (row.key.experiment.as_str(), row.key.variant.as_str(), lap.as_str());
            samples.entry(method).or_default().entry(&row.key.case).or_default().push(*ns);
        }
    }
    samples
}

/// The ratio of two medians; none if one is zero, as a clock may have it.
fn ratio(after: &[u64], before: &[u64]) -> Option<f64> {
    let [after, before] = [after, before].map(|ns| median(ns.to_vec()));
    (after > 0.0 && before > 0.0).then_some(after / before)
}

/// Fewer cases than this have no interval.
const CASES_WITH_INTERVAL: usize = 5;

/// The geometric mean with its interval; of few cases the least and the greatest ratio.
fn mean(ratios: &[f64]) -> String {
    let logarithms: Vec<f64> = ratios.iter().map(|&ratio| libm::log(ratio)).collect();
    let count = logarithms.len() as f64;
    let mean = logarithms.iter().sum::<f64>() / count;
    let value = libm::exp(mean);
    if ratios.len() == 1 {
        return format!("{value:.3}, one case: too few to tell a change");
    }
    if ratios.len() < CASES_WITH_INTERVAL {
        let [least, greatest] = range(ratios);
        return format!("{value:.3}, {count} cases from {least:.3} to {greatest:.3}: too few to tell a change");
    }
    let freedom = ratios.len() - 1;
    let squares: f64 = logarithms.iter().map(|x| (x - mean) * (x - mean)).sum();
    let half_width = t_quantile_975(freedom) * (squares / freedom as f64 / count).sqrt();
    let [low, high] = [mean - half_width, mean + half_width].map(libm::exp);
    format!("{value:.3} ({low:.3} to {high:.3}), {count} cases")
}

#[cfg(test)]
mod tests {
    use super::*;
    use experiments::definition::Case;

    fn row(n: usize, repetition: u32, ns: u64) -> TimeRow {
        let key = (&Case::new(1, "toy", "disc", "m", n, 0)).into();
        let outcome = TimeOutcome::Valid { laps_ns: [("total".to_owned(), ns)].into_iter().collect() };
        TimeRow { key, repetition, environment: String::new(), outcome }
    }

    #[test]
    fn ratios_are_those_of_medians() {
        let first = [row(4, 0, 100), row(4, 1, 300), row(4, 2, 110), row(8, 0, 200)];
        let second = [row(4, 0, 220), row(8, 0, 400), row(16, 0, 1)];
        let told = text(&first, &second, true).1;
        let cases = ["    toy/disc/m/n=4/0, total: 2.000", "    toy/disc/m/n=8/0, total: 2.000"];
        let method = "  toy: m, total: 2.000, 2 cases from 2.000 to 2.000: too few to tell a change";
        assert_eq!(told, [method, cases[0], cases[1]]);
        let told = text(&first, &second[..1], true).1;
        assert_eq!(told, ["  toy: m, total: 2.000, one case: too few to tell a change", cases[0]]);
        let (head, told) = text(&first, &second, false);
        assert_eq!(told, ["  toy: 2.000 on average, from 2.000 to 2.000; 0 shorter, 2 longer"]);
        assert!(head.contains("no ratio is a verdict\n"), "{head}");
        assert!(text(&first, &second[2..], false).0.contains("no time is in both runs"));
    }

    /// Logarithms of 1, 1, 2, 4 and 4: their mean is that of 2, their variance that logarithm's square, and the
    /// quantile for four degrees of freedom is 2.7764.
    #[test]
    fn intervals_are_those_of_the_logarithms() {
        let half_width = 2.7764 * libm::log(2.0) / 5.0_f64.sqrt();
        let [low, high] = [-1.0, 1.0].map(|sign: f64| 2.0 * libm::exp(sign * half_width));
        assert_eq!(mean(&[1.0, 4.0, 2.0, 4.0, 1.0]), format!("2.000 ({low:.3} to {high:.3}), 5 cases"));
        assert_eq!(mean(&[1.0, 4.0]), "2.000, 2 cases from 1.000 to 4.000: too few to tell a change");
    }
}
