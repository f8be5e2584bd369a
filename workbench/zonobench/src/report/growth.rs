//! Growth laws: as sentences and as tables.

use experiments::analysis::FittedGrowth;
use experiments::catalog;
use experiments::fit::{Estimate, Growth, GrowthModel, ModelVerdict};
use paper_checks::Measurement;

use super::html::{Escaped, badge, grouped, table};

/// What the fits of each method in each experiment say of its bound, in one sentence, leaving out what a clock says.
pub(super) fn measurements(fits: &[FittedGrowth]) -> Vec<Measurement> {
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
    let range = |value: fn(&Growth) -> f64| {
        let values = growths.iter().map(|growth| value(growth));
        [values.clone().fold(f64::INFINITY, f64::min), values.fold(f64::NEG_INFINITY, f64::max)]
    };
    let [low, high] = range(|growth| growth.exponent.value);
    let excess = growths.iter().filter_map(|growth| growth.model(bound)).map(|model| model.excess_exponent.high);
    let summary = format!(
        "{} of {} on {} inputs, n = {} to {}: exponents {low:.3} to {high:.3}, beyond {bound} at most {:.3}",
        first.quantity,
        first.variant,
        fits.len(),
        range(|growth| growth.smallest)[0],
        range(|growth| growth.largest)[1],
        excess.fold(f64::NEG_INFINITY, f64::max),
    );
    let agrees = fits.iter().all(|fit| fit.supports_bound() == Some(true));
    let (experiment, method) = (first.experiment.to_owned(), first.variant.to_owned());
    Some(Measurement { experiment, method, summary, agrees })
}

/// A number with its interval.
fn interval(estimate: Estimate) -> String {
    format!("{:.3} [{:.3}, {:.3}]", estimate.value, estimate.low, estimate.high).replace('-', "−")
}

/// The laws as a table; empty without any.
pub(super) fn growth_table(fits: &[&FittedGrowth]) -> String {
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
    let quantity = Escaped(&fit.quantity.to_string()).to_string();
    let mut cells = vec![quantity, variant_title(fit), Escaped(&fit.family.replace('_', " ")).to_string()];
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
                ModelVerdict::Consistent => "consistent",
                ModelVerdict::Slower => "slower",
                ModelVerdict::Faster => "faster",
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

fn variant_title(fit: &FittedGrowth) -> String {
    let variants = catalog::find(fit.experiment).map_or(&[][..], |experiment| experiment.variants);
    let title = variants.iter().find(|variant| variant.id == fit.variant).map_or(fit.variant, |variant| variant.title);
    Escaped(title).to_string()
}

fn model_name(model: GrowthModel) -> String {
    model.to_string().replace("^2", "²")
}
