//! Evidence on how operation counts grow.

use crate::claim::{CheckContext, Claim, Measurement, Verdict};
use experiments::fit::{GrowthModel, ModelVerdict, fit_growth, in_decimals};
use zonotope::tally::{Operation, OperationCounts};

/// A sample (n, operations of all kinds).
pub(crate) fn sample(n: usize, counts: &OperationCounts) -> (f64, f64) {
    let total: u64 = Operation::ALL.iter().map(|&operation| counts.get(operation)).sum();
    (n as f64, total as f64)
}

/// A sentence on how the operations of `what` grow beside a model; an error unless they are shown to grow no faster.
pub(crate) fn evidence(what: &str, samples: &[(f64, f64)], model: GrowthModel) -> Result<String, String> {
    evidence_on(&format!("operations of {what}"), samples, model)
}

/// A sentence on how a quantity grows beside a model; an error unless it is shown to grow no faster.
pub(crate) fn evidence_on(quantity: &str, samples: &[(f64, f64)], model: GrowthModel) -> Result<String, String> {
    evidence_beside(&format!("{quantity}, over {model},"), samples, model)
}

/// The same of a quantity that is named together with what it stands over.
pub(crate) fn evidence_beside(ratio: &str, samples: &[(f64, f64)], model: GrowthModel) -> Result<String, String> {
    let growth = fit_growth(samples, &[model]).map_err(|error| error.to_string())?;
    let fit = growth.model(model).ok_or("the model was not fitted")?;
    let excess = fit.excess_exponent;
    let [value, low, high] = [excess.value, excess.low, excess.high].map(|number| in_decimals(number, 2));
    let sentence = format!("{ratio} grow with exponent {value} in [{low}, {high}]");
    match fit.verdict {
        ModelVerdict::Within | ModelVerdict::Below | ModelVerdict::Kept => Ok(sentence),
        ModelVerdict::Above => Err(format!("{sentence}, above the bound")),
        ModelVerdict::Undecided => Err(format!("{sentence}, which leaves the bound undecided")),
    }
}

/// A verdict on a statement of which a part was not tried: what held is no more than that part of it.
pub(crate) fn but_for(verdict: Verdict, not_tried: &str) -> Verdict {
    match verdict {
        Verdict::Holds(evidence) => Verdict::InPart(format!("{evidence}; not tried: {not_tried}")),
        other => other,
    }
}

/// The verdict on a theorem that states what is found and how fast: a witness against the first refutes it; growth that
/// is not shown to keep the bound, here or in the experiments on the methods that it is about, leaves it open. What the
/// experiments say of other methods is told beside it.
pub(crate) fn verdict(
    context: &CheckContext,
    claim: &Claim,
    found: Result<String, String>,
    growth: impl FnOnce(&CheckContext) -> Result<String, String>,
    methods: &[&str],
) -> Verdict {
    let found = match found {
        Ok(evidence) => evidence,
        Err(witness) => return Verdict::Refuted(witness),
    };
    let growth = match growth(context) {
        Ok(evidence) => evidence,
        Err(reason) => return Verdict::Inconclusive(format!("{found}; {reason}")),
    };
    let measured = context.measurements_for(claim);
    let mut evidence = format!("{found}; {growth}");
    for measurement in &measured {
        evidence.push_str(&format!("; {}: {}", measurement.experiment, measurement.summary));
    }
    let decides =
        |measurement: &&&Measurement| measurement.is_of_paper && methods.contains(&measurement.method.as_str());
    let open: Vec<&str> = measured.iter().filter(decides).filter(|m| !m.agrees).map(|m| m.summary.as_str()).collect();
    if open.is_empty() {
        Verdict::Holds(evidence)
    } else {
        Verdict::Inconclusive(format!("not shown: {}; beside it: {evidence}", open.join(", ")))
    }
}
