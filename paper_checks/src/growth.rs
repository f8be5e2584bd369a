//! Evidence on how operation counts grow.

use experiments::fit::{GrowthModel, ModelVerdict, fit_growth};
use zonotope::tally::{Operation, OperationCounts};

/// A sample (n, operations of all kinds).
pub(crate) fn sample(n: usize, counts: &OperationCounts) -> (f64, f64) {
    let total: u64 = Operation::ALL.iter().map(|&operation| counts.get(operation)).sum();
    (n as f64, total as f64)
}

/// A sentence on how the operations of `what` grow beside a model; an error when they grow faster.
pub(crate) fn evidence(what: &str, samples: &[(f64, f64)], model: GrowthModel) -> Result<String, String> {
    let growth = fit_growth(samples, &[model], None).map_err(|error| error.to_string())?;
    let fit = growth.model(model).ok_or("the model was not fitted")?;
    let excess = fit.excess_exponent;
    let sentence = format!(
        "operations of {what}, over {model}, grow with exponent {:.2} in [{:.2}, {:.2}]",
        excess.value, excess.low, excess.high
    );
    if fit.verdict == ModelVerdict::Faster { Err(sentence) } else { Ok(sentence) }
}
