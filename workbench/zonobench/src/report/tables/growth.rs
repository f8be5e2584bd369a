//! Growth laws: as sentences and as tables.

use experiments::analysis::FittedGrowth;
use experiments::catalog;
use experiments::fit::{Estimate, Growth, GrowthModel, ModelVerdict, in_decimals};
use paper_checks::Measurement;

use super::variant::variant_title;
use crate::report::html::{Escaped, badge, grouped, prose, table};
use experiments::measured::range;

/// What the fits of each method in each experiment say of its bound, in one sentence, leaving out what a clock says.
pub(in crate::report) fn measurements(fits: &[FittedGrowth]) -> Vec<Measurement> {
    let judged = |fit: &&FittedGrowth| fit.is_deterministic() && fit.verdict().is_some();
    let fits: Vec<&FittedGrowth> = fits.iter().filter(judged).collect();
    let smallest = |fit: &FittedGrowth| fit.samples.first().map(|&(n, _)| n);
    let topic = |fit: &FittedGrowth| (fit.experiment, fit.variant, fit.quantity, fit.bound, smallest(fit));
    fits.chunk_by(|a, b| topic(a) == topic(b)).filter_map(measurement).collect()
}

/// One sentence on fits that differ in their inputs only.
fn measurement(fits: &[&FittedGrowth]) -> Option<Measurement> {
    let first = fits.first()?;
    let bound = first.bound?;
    let growths: Vec<&Growth> = fits.iter().filter_map(|fit| fit.growth.as_ref().ok()).collect();
    let [low, high] = range(growths.iter().map(|growth| growth.exponent.value))?.map(|end| in_decimals(end, 3));
    let [smallest, largest] = range(growths.iter().flat_map(|growth| [growth.smallest, growth.largest]))?;
    let excess = growths.iter().filter_map(|growth| growth.model(bound)).map(|model| model.excess_exponent.high);
    let summary = format!(
        "{} of {} on {} inputs, n = {smallest} to {largest}: exponents {low} to {high}, beyond {bound} at most {}",
        first.quantity,
        first.variant,
        fits.len(),
        in_decimals(excess.fold(f64::NEG_INFINITY, f64::max), 3),
    );
    let agrees = fits.iter().all(|fit| fit.supports_bound() == Some(true));
    let (experiment, method) = (first.experiment.to_owned(), first.variant.to_owned());
    Some(Measurement { experiment, method, summary, agrees })
}

/// The words for samples within a bound.
const WITHIN: &str = "within the bound";
/// The words for samples that stay below a bound, which is one from above.
const BELOW: &str = "below the bound, as the paper says";
/// The words for samples that exceed a bound.
const ABOVE: &str = "above the bound";

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
    let count = |verdict: ModelVerdict| fits.iter().filter(|fit| fit.verdict() == Some(verdict)).count();
    let found = match [ModelVerdict::Above, ModelVerdict::Within, ModelVerdict::Below].map(count) {
        [0, 0, 0] => badge("plain", "measured"),
        [0, _, 0] => badge("good", WITHIN),
        [0, 0, _] => badge("good", BELOW),
        [0, _, _] => badge("good", "within the bound or below it"),
        [above, within, below] => badge("bad", &format!("{ABOVE} in {above} of {} fits", above + within + below)),
    };
    Some(vec![
        Escaped(&first.quantity.to_string().replace('_', " ")).to_string(),
        method_title(first),
        input,
        format!("{} … {}", grouped(smallest as u64), grouped(largest as u64)),
        format!("{low} to {high}").replace('-', "−"),
        first.bound.map_or("–".to_owned(), model_name),
        found,
    ])
}

/// A number with its interval.
fn interval(estimate: Estimate) -> String {
    let [value, low, high] = [estimate.value, estimate.low, estimate.high].map(|number| in_decimals(number, 3));
    format!("{value} [{low}, {high}]").replace('-', "−")
}

/// The laws as a table; empty without any.
pub(in crate::report) fn growth_table(fits: &[&FittedGrowth]) -> String {
    if fits.is_empty() {
        return String::new();
    }
    let rows: Vec<Vec<String>> = fits.iter().map(|fit| row(fit)).collect();
    table(
        "growth",
        &["what", "method", "input", "n", "exponent, 95 %", "bound", "beyond it, 95 %", "closest", "verdict"],
        &rows,
    )
}

fn row(fit: &FittedGrowth) -> Vec<String> {
    let quantity = Escaped(&fit.quantity.to_string().replace('_', " ")).to_string();
    let mut cells = vec![quantity, method_title(fit), Escaped(&fit.family.replace('_', " ")).to_string()];
    let growth = match &fit.growth {
        Ok(growth) => growth,
        Err(error) => {
            cells.extend(["–", "–", "–", "–", "–"].map(str::to_owned));
            cells.push(format!("{} <small>{}</small>", badge("open", "no fit"), Escaped(&error.to_string())));
            return cells;
        }
    };
    cells.push(format!("{} … {}", grouped(growth.smallest as u64), grouped(growth.largest as u64)));
    cells.push(interval(growth.exponent));
    let bound = fit.bound.and_then(|model| growth.model(model));
    cells.push(bound.map_or("–".to_owned(), |model| model_name(model.model)));
    cells.push(bound.map_or("–".to_owned(), |model| interval(model.excess_exponent)));
    cells.push(growth.best().map_or("–".to_owned(), |best| model_name(best.model)));
    let mut verdict = match bound.map(|model| model.verdict) {
        None => badge("plain", "measured"),
        Some(verdict) => {
            let word = match verdict {
                ModelVerdict::Within => WITHIN,
                ModelVerdict::Below => BELOW,
                ModelVerdict::Above => ABOVE,
            };
            badge(if fit.supports_bound() == Some(true) { "good" } else { "bad" }, word)
        }
    };
    if fit.left_out > 0 {
        verdict.push_str(&format!(" <small>{} rows left out</small>", fit.left_out));
    }
    cells.push(verdict);
    cells
}

/// The title of the method whose growth was fitted.
fn method_title(fit: &FittedGrowth) -> String {
    catalog::find(fit.experiment)
        .map_or_else(|| Escaped(fit.variant).to_string(), |experiment| variant_title(experiment, fit.variant))
}

fn model_name(model: GrowthModel) -> String {
    prose(&model.to_string())
}
