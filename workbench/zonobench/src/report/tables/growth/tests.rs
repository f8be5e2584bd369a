use experiments::analysis::Range;
use experiments::definition::Quantity;
use experiments::fit::fit_growth;

use super::*;

fn fit_of(samples: &[(f64, f64)], bound: Option<Bound>, floor: Option<GrowthModel>) -> FittedGrowth {
    FittedGrowth {
        experiment: "hull-scaling",
        family: "disc",
        variant: "by_monotone_chain",
        quantity: Quantity::AllCounts,
        bound,
        floor,
        range: Range::Whole,
        samples: samples.to_vec(),
        left_out: 0,
        growth: fit_growth(samples, GrowthModel::RUNNING_TIMES),
    }
}

fn powers(y: impl Fn(f64) -> f64) -> Vec<(f64, f64)> {
    (10..=14).map(|log| f64::from(1 << log)).map(|n| (n, y(n))).collect()
}

/// Five sizes at which the numbers are up and down: the interval is far wider than the slack.
fn noisy() -> Vec<(f64, f64)> {
    powers(|n| if [2048.0, 8192.0].contains(&n) { 9.0 * n } else { n })
}

const PAPERS: Bound = Bound::of_paper(GrowthModel::Linear, "Theorem 0");

#[test]
fn a_wide_interval_is_undecided_grey_and_no_evidence() {
    let fit = fit_of(&noisy(), Some(PAPERS), None);
    let table = growth_table(&[&fit]);
    assert!(table.contains("<span class=\"badge plain\">undecided</span>"), "{table}");
    assert!(!table.contains("within") && !table.contains("badge good"), "{table}");
    let measured = measurements(&[fit]);
    assert!(!measured[0].agrees && measured[0].summary.ends_with("undecided on 1"), "{:?}", measured[0]);
}

#[test]
fn a_bound_of_the_paper_is_named_and_one_of_ours_is_not_the_papers() {
    let papers = growth_table(&[&fit_of(&powers(|n| 3.0 * n), Some(PAPERS), None)]);
    assert!(papers.contains(">within the bound of Theorem 0</span>"), "{papers}");
    let own = growth_table(&[&fit_of(&powers(f64::sqrt), Some(Bound::own(GrowthModel::Linear)), None)]);
    assert!(own.contains(">below the bound</span>") && own.contains("our own"), "{own}");
    assert!(!own.contains("paper"), "{own}");
}

#[test]
fn a_total_that_reads_its_input_is_not_called_below_it() {
    let fit = fit_of(
        &powers(|n| n.sqrt() * n.sqrt().sqrt()),
        Some(Bound::own(GrowthModel::Linear)),
        Some(GrowthModel::Linear),
    );
    for (table, words) in [(growth_table(&[&fit]), ">within the bound<"), (growth_summary(&[&fit]), ">within<")] {
        assert!(table.contains(words) && table.contains(LOWER_ORDER) && !table.contains("below"), "{table}");
    }
}

#[test]
fn laws_without_a_fit_have_no_row() {
    let short = fit_of(&[(2.0, 3.0), (4.0, 5.0)], Some(PAPERS), None);
    assert_eq!((growth_table(&[&short]), growth_summary(&[&short])), (String::new(), String::new()));
}

#[test]
fn ranges_that_are_short_and_replicates_that_are_missing_are_told() {
    let short = growth_table(&[&fit_of(&[(6.0, 7.0), (8.0, 9.0), (12.0, 13.0), (16.0, 17.0)], None, None)]);
    assert!(short.contains("<small>4 sizes, 1.4 doublings</small>"), "{short}");
    assert!(short.contains("no replicates") && short.contains(MEASURED), "{short}");
    let long = growth_table(&[&fit_of(&powers(|n| 3.0 * n), Some(PAPERS), None)]);
    assert!(!long.contains("doublings"), "{long}");
    let twice: Vec<(f64, f64)> = powers(|n| 3.0 * n).into_iter().flat_map(|(n, y)| [(n, y), (n, 1.1 * y)]).collect();
    let tested = growth_table(&[&fit_of(&twice, Some(PAPERS), None)]);
    assert!(tested.contains("none, p = "), "{tested}");
}

/// The findings on several inputs are counted by verdict, the undecided ones in grey.
#[test]
fn a_summary_counts_each_verdict_apart() {
    let fits = [powers(|n| 3.0 * n), powers(|n| n * n), noisy()].map(|samples| fit_of(&samples, Some(PAPERS), None));
    let summary = growth_summary(&fits.each_ref());
    for badge in [
        "<span class=\"badge good\">within in 1 of 3</span>",
        "<span class=\"badge bad\">above in 1 of 3</span>",
        "<span class=\"badge plain\">undecided in 1 of 3</span>",
    ] {
        assert!(summary.contains(badge), "{summary}");
    }
}
