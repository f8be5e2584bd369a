//! The ledger within the page: each claim of the paper once, by section.

use paper_checks::{ClaimResult, Finding};

use super::layout::Layout;
use crate::report::Evidence;
use crate::report::html::Escaped;
use crate::report::tables::{claim_table, finding_badge};

/// The ledger, with what the sorts of findings mean and where the corrections stand; nothing where no claim was
/// checked.
pub(super) fn section(layout: &Layout<'_>, evidence: &Evidence) -> String {
    if evidence.claims.is_empty() {
        return String::new();
    }
    let mut text = String::from(
        "<section id=\"ledger\">\n<h2>The paper's statements, one by one</h2>\n\
         <p>Every statement, figure and open question of the paper, checked where its algorithm exists; each \
         claim is counted once. Each correction comes with a witness and with what to read instead.</p>\n\
         <details><summary>The sorts of findings, with their statements</summary>\n<ul class=\"sorts\">\n",
    );
    text.push_str(&sorts(evidence));
    text.push_str("</ul>\n</details>\n");
    let figures = |result: &ClaimResult| figure_links(result, layout);
    for section in sections(&evidence.claims) {
        let results: Vec<_> = evidence.claims.iter().filter(|result| result.claim.place.section == section).collect();
        text.push_str(&format!(
            "<details>\n<summary>Section {} <small>{}</small></summary>\n{}</details>\n",
            Escaped(section),
            tally(&results),
            claim_table(&results, figures)
        ));
    }
    text.push_str("</section>\n");
    text
}

/// The meaning of each finding but “holds”, with links to the claims that have it.
fn sorts(evidence: &Evidence) -> String {
    let mut text = String::new();
    for finding in Finding::ALL.into_iter().filter(|&finding| finding != Finding::Holds) {
        let found = evidence.claims.iter().filter(|result| result.finding() == finding);
        let links: Vec<String> =
            found.map(|result| format!("<a href=\"#claim-{0}\">{0}</a>", result.claim.id)).collect();
        if !links.is_empty() {
            let meaning = finding.meaning();
            text.push_str(&format!("<li>{} {meaning}: {}.</li>\n", finding_badge(finding), links.join(", ")));
        }
    }
    text
}

/// The sections of the claims, each once, in the order of their first claim.
fn sections(claims: &[ClaimResult]) -> Vec<&'static str> {
    let mut sections: Vec<&'static str> = Vec::new();
    for section in claims.iter().map(|result| result.claim.place.section) {
        if !sections.contains(&section) {
            sections.push(section);
        }
    }
    sections
}

/// The number of claims that have each finding: "3 [holds] 2 [erratum]".
fn tally(results: &[&ClaimResult]) -> String {
    let counted = Finding::ALL.into_iter().filter_map(|finding| {
        let count = results.iter().filter(|result| result.finding() == finding).count();
        (count > 0).then(|| format!("{count} {}", finding_badge(finding)))
    });
    counted.collect::<Vec<_>>().join(" ")
}

/// Links to the figures of the page that show a claim.
fn figure_links(result: &ClaimResult, layout: &Layout<'_>) -> Vec<String> {
    let link = |id: &&str| {
        let number = layout.number_of(id)? + 1;
        Some(format!("<a href=\"#figure-{id}\">Figure {number}</a>"))
    };
    result.claim.figures.iter().filter_map(link).collect()
}
