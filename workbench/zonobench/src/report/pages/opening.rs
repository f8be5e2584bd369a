//! The head of the report: what it is about, the counts of what was found, the contents.

use paper_checks::Finding;

use super::layout::Layout;
use crate::report::Evidence;
use crate::report::html::{Escaped, grouped};

const PAPER: &str = "L. J. Guibas, A. Nguyen and L. Zhang, <cite>Zonotopes as Bounding Volumes</cite>, SODA 2003";

/// The head of the page.
pub(super) fn section(layout: &Layout<'_>, evidence: &Evidence) -> String {
    let mut text = format!(
        "<header>\n<p class=\"kicker\">Zonotope Workbench</p>\n<h1>Zonotopes as bounding volumes, running</h1>\n\
         <p class=\"lead\">{PAPER}, describes algorithms on a class of symmetric bodies. This page shows them at \
         work: what each one solves, what was learned from running it, pictures of it, how its cost grows against the \
         bound in the paper, and whether the paper's statements hold. In the page that <code>zonobench explore \
         --open</code> opens, the same geometry can be dragged.</p>\n\
         </header>\n<ul class=\"tiles\">\n"
    );
    for (number, what) in tiles(evidence) {
        text.push_str(&format!("<li><b>{}</b> {what}</li>\n", grouped(number)));
    }
    text.push_str("</ul>\n");
    if !evidence.only.is_empty() {
        let left_out = match evidence.config {
            Some(_) => "Claims are about the experiments of the catalog, so they were left out.",
            None => "Claims that rest on other experiments, or on none, were left out.",
        };
        let only = evidence.only.join(", ");
        text.push_str(&format!("<p>Only a part was run: {}. {left_out}</p>\n", Escaped(&only)));
    }
    text.push_str("<nav><h2>Contents</h2>\n<ol>\n");
    if !layout.own_figures.is_empty() {
        text.push_str("<li><a href=\"#own\">Your plots</a></li>\n");
    }
    for part in &layout.parts {
        let (id, title, place) = (part.chapter.id, part.chapter.title, part.chapter.place);
        text.push_str(&format!(
            "<li><a href=\"#{id}\">{}</a> <small>{}</small></li>\n",
            Escaped(title),
            Escaped(place)
        ));
    }
    if evidence.only.is_empty() {
        text.push_str("<li><a href=\"#peers\">Beside other libraries</a></li>\n");
    }
    if evidence.fits.iter().any(|fit| fit.is_deterministic() && fit.verdict().is_some()) {
        text.push_str("<li><a href=\"#laws\">Growth laws by what was found</a></li>\n");
    }
    if !evidence.claims.is_empty() {
        text.push_str("<li><a href=\"#ledger\">The paper's statements, one by one</a></li>\n");
    }
    text.push_str("<li><a href=\"#reading\">How to read, repeat and cite this</a></li>\n</ol>\n</nav>\n");
    text
}

/// Counts with their nouns; findings that occur nowhere are left out.
fn tiles(evidence: &Evidence) -> Vec<(u64, &'static str)> {
    let noun = |finding: Finding| match finding {
        Finding::Holds => "statements hold",
        Finding::HoldsWhereTried => "hold where tried",
        Finding::HoldsInPart => "hold in part",
        Finding::Restated => "restate another one",
        Finding::AnsweredInPart => "questions are answered in part",
        Finding::Erratum => "errata, with a witness and a remedy",
        Finding::MissingCondition => "need a condition",
        Finding::Note => "notes for programs",
        Finding::Refuted => "statements are refuted that were not listed for correction",
        Finding::Inconclusive => "are inconclusive",
        Finding::NotYetImplemented => "wait for their algorithm",
    };
    let findings = Finding::ALL.into_iter().filter_map(|finding| {
        let count = evidence.claims.iter().filter(|result| result.finding() == finding).count();
        (count > 0).then(|| (count as u64, noun(finding)))
    });
    let counts = &evidence.records.counts;
    let wrong = counts.iter().filter(|row| row.fault().is_some()).count();
    findings.chain([(counts.len() as u64, "runs counted"), (wrong as u64, "of them refused by their check")]).collect()
}
