//! The paper's claims as a table.

use paper_checks::{Check, ClaimResult, Finding};

use crate::report::html::{Escaped, badge, prose, table};

/// The claims with what was found; the row of a claim is the anchor `claim-` and its id. `figures` has the links to the
/// figures that show a claim.
pub(in crate::report) fn claim_table(
    results: &[&ClaimResult],
    figures: impl Fn(&ClaimResult) -> Vec<String>,
) -> String {
    let rows: Vec<Vec<String>> = results
        .iter()
        .map(|result| {
            let claim = result.claim;
            let place = format!("{}, {}", claim.place.section, claim.place.label);
            let mut evidence = match (result.claim.check, &result.verdict) {
                (Check::Restates(id), Some(_)) => prose(&result.evidence())
                    .replace(&format!("<code>{id}</code>"), &format!("<a href=\"#claim-{id}\">{id}</a>")),
                _ => prose(&result.evidence()),
            };
            if let Some(remedy) = claim.remedy {
                let word = result.remedy_word();
                evidence.push_str(&format!("<p class=\"remedy\">{word}: {}</p>", prose(remedy)));
            }
            let links = figures(result);
            if !links.is_empty() {
                evidence.push_str(&format!("<p class=\"remedy\">{}</p>", links.join(", ")));
            }
            vec![
                format!(
                    "<span id=\"claim-{}\">{}</span><br><small>{}: {}</small>",
                    claim.id,
                    prose(claim.statement),
                    claim.id,
                    Escaped(&place)
                ),
                evidence,
                finding_badge(result.finding()),
            ]
        })
        .collect();
    table("claims", &["the paper says", "what was found", "in a word"], &rows)
}

/// The finding as a badge.
pub(in crate::report) fn finding_badge(finding: Finding) -> String {
    let tone = match finding {
        Finding::Holds | Finding::HoldsWhereTried | Finding::HoldsInPart => "good",
        Finding::Erratum | Finding::Refuted => "bad",
        Finding::MissingCondition | Finding::Note | Finding::Inconclusive | Finding::AnsweredInPart => "open",
        Finding::Restated | Finding::NotYetImplemented => "plain",
    };
    badge(tone, finding.words())
}
