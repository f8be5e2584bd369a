//! The paper's claims as a table.

use paper_checks::{ClaimResult, Verdict};

use super::html::{Escaped, badge, prose, table};

/// The claims with their verdicts. A row's place on the page is named `prefix` and the claim.
pub(super) fn claim_table(prefix: &str, results: &[&ClaimResult]) -> String {
    let rows: Vec<Vec<String>> = results
        .iter()
        .map(|result| {
            let claim = result.claim;
            let place = format!("{}, {}", claim.place.section, claim.place.label);
            let mut evidence = prose(&result.evidence());
            if let Some(remedy) = claim.remedy {
                evidence.push_str(&format!("<p class=\"remedy\">Instead: {}</p>", prose(remedy)));
            }
            vec![
                format!(
                    "<span id=\"{prefix}-{}\">{}</span><br><small>{}</small>",
                    claim.id,
                    prose(claim.statement),
                    Escaped(&place)
                ),
                evidence,
                verdict(result),
            ]
        })
        .collect();
    table("claims", &["the paper says", "what was found", "verdict"], &rows)
}

/// The verdict as a badge.
pub(super) fn verdict(result: &ClaimResult) -> String {
    let tone = match &result.verdict {
        Some(Verdict::Holds(_)) => "good",
        Some(Verdict::Refuted(_)) => "bad",
        Some(Verdict::Inconclusive(_)) => "open",
        None => "plain",
    };
    badge(tone, result.word())
}
