//! Growth laws: as sentences and as tables.

use experiments::analysis::FittedGrowth;
use experiments::catalog;
use experiments::fit::{Estimate, GrowthModel, ModelVerdict};

use super::html::{Escaped, badge, grouped, table};

/// One growth law in one sentence, when there is one to tell.
pub(super) fn sentence(fit: &FittedGrowth) -> Option<String> {
    let growth = fit.growth.as_ref().ok()?;
    let bound = fit.bound?;
    let excess = growth.model(bound)?.excess_exponent;
    Some(format!(
        "{} of {} on {}: exponent {} for n = {} to {}; beyond {bound}: {}",
        fit.quantity,
        fit.variant,
        fit.family,
        interval(growth.exponent),
        growth.smallest,
        growth.largest,
        interval(excess),
    ))
}

/// A number with its interval.
fn interval(estimate: Estimate) -> String {
    format!("{:.3} [{:.3}, {:.3}]", estimate.value, estimate.low, estimate.high)
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
