//! Growth laws: as sentences and as tables.

use experiments::analysis::FittedGrowth;
use experiments::catalog;
use experiments::definition::{Bound, StatedBy};
use experiments::findings::words;
use experiments::fit::{
    Estimate, Growth, GrowthModel, LAST_DOUBLINGS, LackOfFit, ModelVerdict, SIZES_OF_LAST_DOUBLINGS, in_decimals,
};
use paper_checks::Measurement;

use super::variant::variant_title;
use crate::report::html::{Escaped, badge, grouped, prose, table};
use experiments::measured::range;

/// The sentence on the bound of each method in each experiment that its fits make, leaving out what a clock
/// says.
pub(in crate::report) fn measurements(fits: &[FittedGrowth]) -> Vec<Measurement> {
    let judged = |fit: &&FittedGrowth| fit.is_deterministic() && fit.verdict().is_some();
    let fits: Vec<&FittedGrowth> = fits.iter().filter(judged).collect();
    let topic = |fit: &FittedGrowth| (fit.experiment, fit.variant, fit.quantity, fit.bound, fit.range);
    fits.chunk_by(|a, b| topic(a) == topic(b)).filter_map(measurement).collect()
}

/// One sentence on fits that differ in their inputs only.
fn measurement(fits: &[&FittedGrowth]) -> Option<Measurement> {
    let first = fits.first()?;
    let bound = first.bound?;
    let growths: Vec<&Growth> = fits.iter().filter_map(|fit| fit.growth.as_ref().ok()).collect();
    let [low, high] = range(growths.iter().map(|growth| growth.exponent.value))?.map(|end| in_decimals(end, 3));
    let [smallest, largest] = range(growths.iter().flat_map(|growth| [growth.smallest, growth.largest]))?;
    let excess = fits.iter().filter_map(|fit| fit.bound_fit()).map(|fit| fit.excess_exponent.high);
    let undecided = fits.iter().filter(|fit| fit.verdict() == Some(ModelVerdict::Undecided)).count();
    let open = if undecided == 0 { String::new() } else { format!(", undecided on {undecided}") };
    let measured =
        format!("{} of {} on {} inputs, n = {smallest} to {largest}", first.quantity, first.variant, fits.len());
    let summary = match (bound.most, fits.iter().filter_map(|fit| fit.greatest()).reduce(f64::max)) {
        (Some(most), Some(greatest)) => format!("{measured}: at most {}, of {most}", words::number(greatest)),
        _ => format!(
            "{measured}: exponents {low} to {high}, beyond {} at most {}{open}",
            bound.model,
            in_decimals(excess.fold(f64::NEG_INFINITY, f64::max), 3),
        ),
    };
    let agrees = fits.iter().all(|fit| fit.supports_bound() == Some(true));
    let (experiment, method) = (first.experiment.to_owned(), first.variant.to_owned());
    Some(Measurement { experiment, method, summary, agrees, is_of_paper: first.paper_place().is_some() })
}

/// The words for a verdict on the bound of a fit: a bound that the paper states is named after its place there.
fn verdict_words(fit: &FittedGrowth, verdict: ModelVerdict) -> String {
    let bound = fit.paper_place().map_or_else(|| "the bound".to_owned(), |place| format!("the bound of {place}"));
    match verdict {
        ModelVerdict::Within => format!("within {bound}"),
        ModelVerdict::Below => format!("below {bound}"),
        ModelVerdict::Kept => format!("no sample exceeds {bound}"),
        ModelVerdict::Above => format!("above {bound}"),
        ModelVerdict::Undecided => "undecided".to_owned(),
    }
}

/// The same where the bound and its place stand beside it.
fn short_words(verdict: ModelVerdict) -> &'static str {
    match verdict {
        ModelVerdict::Within => "within",
        ModelVerdict::Below => "below",
        ModelVerdict::Kept => "kept by all",
        ModelVerdict::Above => "above",
        ModelVerdict::Undecided => "undecided",
    }
}

/// The tone of a verdict: a bound that is kept is good, one that is not is bad, and what is undecided is grey.
fn tone(verdict: ModelVerdict) -> &'static str {
    match verdict.keeps_bound() {
        Some(true) => "good",
        Some(false) => "bad",
        None => "plain",
    }
}

/// A law without a bound says what was measured, and nothing is judged.
const MEASURED: &str = "<small>measured</small>";

/// The note on samples that grow slower than what has to read its input can.
const LOWER_ORDER: &str = "lower-order terms show";

/// The laws in a row for each quantity of each method, over all inputs and ranges; empty without any.
pub(in crate::report) fn growth_summary(fits: &[&FittedGrowth]) -> String {
    let topic = |fit: &FittedGrowth| (fit.experiment, fit.variant, fit.quantity, fit.bound);
    let rows: Vec<Vec<String>> = fits.chunk_by(|a, b| topic(a) == topic(b)).filter_map(summary_row).collect();
    if rows.is_empty() {
        return String::new();
    }
    table("growth", &["what", "method", "inputs", "n", "exponents", "bound", "found"], &rows)
}

/// One row on fits that differ in their inputs and ranges only; none if there is no law among them.
fn summary_row(fits: &[&FittedGrowth]) -> Option<Vec<String>> {
    let first = fits.first()?;
    let growths = || fits.iter().filter_map(|fit| fit.growth.as_ref().ok());
    let [low, high] = range(growths().map(|growth| growth.exponent.value))?.map(|end| in_decimals(end, 2));
    let [smallest, largest] = range(growths().flat_map(|growth| [growth.smallest, growth.largest]))?;
    let mut inputs: Vec<&str> = fits.iter().map(|fit| fit.family).collect();
    inputs.sort_unstable();
    inputs.dedup();
    let input = match inputs[..] {
        [input] => Escaped(&input.replace('_', " ")).to_string(),
        _ => inputs.len().to_string(),
    };
    Some(vec![
        quantity_name(first),
        method_title(first),
        input,
        format!("{} … {}", grouped(smallest as u64), grouped(largest as u64)),
        format!("{low} to {high}").replace('-', "−"),
        first.bound.map_or("–".to_owned(), bound_name),
        summary_of_verdicts(fits),
    ])
}

/// The number of fits with each verdict, or the verdict alone where all have the same.
fn summary_of_verdicts(fits: &[&FittedGrowth]) -> String {
    let verdicts: Vec<ModelVerdict> = fits.iter().filter_map(|fit| fit.verdict()).collect();
    let counted: Vec<(ModelVerdict, usize)> = ModelVerdict::ALL
        .into_iter()
        .map(|verdict| (verdict, verdicts.iter().filter(|other| **other == verdict).count()))
        .filter(|(_, count)| *count > 0)
        .collect();
    let mut found: Vec<String> = match counted[..] {
        [] => vec![MEASURED.to_owned()],
        [(verdict, _)] => vec![badge(tone(verdict), short_words(verdict))],
        _ => counted
            .iter()
            .map(|&(verdict, count)| {
                badge(tone(verdict), &format!("{} in {count} of {}", short_words(verdict), verdicts.len()))
            })
            .collect(),
    };
    if fits.iter().any(|fit| fit.shows_lower_order_terms()) {
        found.push(format!("<small>{LOWER_ORDER}</small>"));
    }
    found.join(" ")
}

/// A number with its interval.
fn interval(estimate: Estimate) -> String {
    let [value, low, high] = [estimate.value, estimate.low, estimate.high].map(|number| in_decimals(number, 3));
    format!("{value} [{low}, {high}]").replace('-', "−")
}

/// The laws as a table; empty without any. Where there are too few samples for a law, there is no row.
pub(in crate::report) fn growth_table(fits: &[&FittedGrowth]) -> String {
    let fitted = |fit: &&FittedGrowth| Some(row(fit, fit.growth.as_ref().ok()?));
    let rows: Vec<Vec<String>> = fits.iter().filter_map(fitted).collect();
    if rows.is_empty() {
        return String::new();
    }
    table(
        "growth",
        &["what", "method", "input", "n", "exponent, 95 %", "bound", "beyond it, 95 %", "bend", "closest", "verdict"],
        &rows,
    )
}

fn row(fit: &FittedGrowth, growth: &Growth) -> Vec<String> {
    let mut verdict = match fit.verdict() {
        None => MEASURED.to_owned(),
        Some(verdict) => badge(tone(verdict), &verdict_words(fit, verdict)),
    };
    if fit.shows_lower_order_terms() {
        verdict.push_str(&format!(" <small>{LOWER_ORDER}</small>"));
    }
    if fit.left_out > 0 {
        verdict.push_str(&format!(" <small>{} rows left out</small>", fit.left_out));
    }
    vec![
        quantity_name(fit),
        method_title(fit),
        Escaped(&fit.family.replace('_', " ")).to_string(),
        sizes(growth),
        interval(growth.exponent),
        fit.bound.map_or("–".to_owned(), bound_name),
        beyond(fit),
        fit.lack_of_fit().map_or("–".to_owned(), bend),
        growth.best().map_or("–".to_owned(), |best| model_name(best.model)),
        verdict,
    ]
}

/// The excess over the bound: an exponent with its interval, or the greatest sample beside a number.
pub(in crate::report) fn beyond(fit: &FittedGrowth) -> String {
    match (fit.beside_number(), fit.bound_fit()) {
        (Some(greatest), _) => format!("at most {}", words::number(greatest)),
        (None, Some(bound)) => interval(bound.excess_exponent),
        (None, None) => "–".to_owned(),
    }
}

/// The range of the sizes; where it is not five sizes over four doublings at least, how many sizes and doublings.
fn sizes(growth: &Growth) -> String {
    let range = format!("{} … {}", grouped(growth.smallest as u64), grouped(growth.largest as u64));
    let doublings = libm::log2(growth.largest / growth.smallest);
    if growth.sizes >= SIZES_OF_LAST_DOUBLINGS && doublings >= f64::from(LAST_DOUBLINGS) {
        return range;
    }
    format!("{range} <small>{} sizes, {} doublings</small>", growth.sizes, in_decimals(doublings, 1))
}

/// The words for the test of a lack of fit.
fn bend(lack_of_fit: LackOfFit) -> String {
    match lack_of_fit {
        LackOfFit::NoReplicates => "<small>no replicates</small>".to_owned(),
        LackOfFit::Tested { probability, .. } => {
            let probability = if probability < 0.001 {
                "p &lt; 0.001".to_owned()
            } else {
                format!("p = {}", in_decimals(probability, 3))
            };
            if lack_of_fit.is_detected() { format!("bends, {probability}") } else { format!("none, {probability}") }
        }
    }
}

/// The name of what was fitted.
pub(in crate::report) fn quantity_name(fit: &FittedGrowth) -> String {
    Escaped(&fit.quantity.to_string().replace('_', " ")).to_string()
}

/// A bound, with who states it.
fn bound_name(bound: Bound) -> String {
    let place = match bound.stated_by {
        StatedBy::Paper(place) => place,
        StatedBy::Workbench => "our own",
    };
    let law = bound.most.map_or_else(|| model_name(bound.model), |most| format!("{most} in each case"));
    format!("{law} <small>{place}</small>")
}

/// The title of the method whose growth was fitted.
pub(in crate::report) fn method_title(fit: &FittedGrowth) -> String {
    catalog::find(fit.experiment)
        .map_or_else(|| Escaped(fit.variant).to_string(), |experiment| variant_title(experiment, fit.variant))
}

fn model_name(model: GrowthModel) -> String {
    prose(&model.to_string())
}

#[cfg(test)]
mod tests;
