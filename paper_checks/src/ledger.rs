//! Running the claims and writing the ledger.

use std::fmt::Write;

use crate::catalog::{self, CLAIMS};
use crate::claim::{Check, CheckContext, Claim, ClaimKind, Verdict};
use crate::finding::Finding;

/// A claim with what its check found.
#[derive(Clone, Debug)]
pub struct ClaimResult {
    /// The claim.
    pub claim: &'static Claim,
    /// The verdict; `None` while the claim has no check.
    pub verdict: Option<Verdict>,
}

impl ClaimResult {
    /// The word before the remedy: a correction says what holds instead, beside a statement that holds stands a remark.
    pub fn remedy_word(&self) -> &'static str {
        match self.claim.kind {
            ClaimKind::Note => "Note",
            ClaimKind::Correction(_) => "Instead",
            _ => "Remark",
        }
    }

    /// The finding.
    pub fn finding(&self) -> Finding {
        Finding::of(self.claim, self.verdict.as_ref())
    }

    /// The evidence in one line: for a restatement, the claim that it restates.
    pub fn evidence(&self) -> String {
        match (&self.verdict, self.claim.check) {
            (Some(verdict), Check::Restates(id)) => {
                let original = catalog::find(id).map(|claim| Finding::of(claim, Some(verdict)).words());
                format!("restates `{id}` ({})", original.unwrap_or_default())
            }
            (Some(verdict), _) => verdict.evidence().to_owned(),
            (None, _) => String::new(),
        }
    }
}

/// Runs the check of one claim, or the check of the claim that it restates; `None` when there is no check yet.
///
/// A claim does not follow restatements itself: it would have to know the catalog, which lists every claim.
pub fn verdict(claim: &Claim, context: &CheckContext) -> Option<Verdict> {
    match claim.check {
        Check::NotYetImplemented => None,
        Check::Restates(id) => verdict(catalog::find(id)?, context),
        Check::Run(check) => {
            let verdict = check(context);
            Some(match claim.tried.alone(&context.families_for(claim)) {
                Some(kind) => verdict.where_tried(kind),
                None => verdict,
            })
        }
    }
}

/// Checks every claim in the order of the catalog; `progress` sees each result as it arrives.
pub fn run(context: &CheckContext, mut progress: impl FnMut(&ClaimResult)) -> Vec<ClaimResult> {
    let mut results: Vec<ClaimResult> = Vec::with_capacity(CLAIMS.len());
    for &claim in CLAIMS {
        let known = match claim.check {
            Check::Restates(id) => results.iter().find(|result| result.claim.id == id),
            _ => None,
        };
        let verdict = match known {
            Some(original) => original.verdict.clone(),
            None => verdict(claim, context),
        };
        let result = ClaimResult { claim, verdict };
        progress(&result);
        results.push(result);
    }
    results
}

fn tally(results: &[ClaimResult]) -> String {
    let counts: Vec<String> = Finding::ALL
        .iter()
        .map(|finding| {
            let count = results.iter().filter(|result| result.finding() == *finding).count();
            format!("{count} {}", finding.words())
        })
        .collect();
    let lines: Vec<String> = counts.chunks(6).map(|line| line.join(", ")).collect();
    format!("{} claims:\n{}", results.len(), lines.join(",\n"))
}

/// The last sentence of the preface of the committed ledger.
pub const COMMITTED: &str =
    "This file has what the checks alone find: `ZONOTOPE_BLESS=1 cargo test -p paper_checks` rewrites it.";

/// The last sentence of the preface of a ledger that a run writes.
pub const OF_A_RUN: &str =
    "`zonobench reproduce` wrote this file: to what the checks find it adds what the experiments of the run measured.";

/// The ledger as Markdown: claim, place, evidence, finding. The `origin` is the sentence that says who wrote it.
pub fn markdown(results: &[ClaimResult], origin: &str) -> String {
    let mut page = String::from(
        "# Claims\n\n\
         Every statement of \"Zonotopes as Bounding Volumes\" (Guibas, Nguyen, Zhang 2003) that can be true or false,\n\
         with the evidence that the checks of this crate produce in exact arithmetic and what was found; remarks on\n\
         other work and on what the authors do not know are left out. Each claim is counted once:\n\n",
    );
    for finding in Finding::ALL {
        page.push_str(&format!("- *{}*: the claim {}.\n", finding.words(), finding.meaning()));
    }
    page.push_str(&format!(
        "\nA correction or note says what to read instead, and is counted beside the statement that it is about; a \
         remark on a\nstatement that holds says what more there is to know.\n{origin}\n\n"
    ));
    let mut line = |text: std::fmt::Arguments| {
        writeln!(page, "{text}").expect("because writing to a string does not fail");
    };
    line(format_args!("{}.\n", tally(results)));
    line(format_args!("| Claim | Place | Evidence | Found |"));
    line(format_args!("| --- | --- | --- | --- |"));
    for result in results {
        let claim = result.claim;
        line(format_args!(
            "| **{}**: {} | {}, {} | {} | {} |",
            cell(claim.id),
            cell(claim.statement),
            cell(claim.place.section),
            cell(claim.place.label),
            evidence_cell(result),
            result.finding().words(),
        ));
    }
    page
}

fn evidence_cell(result: &ClaimResult) -> String {
    let claim = result.claim;
    let mut parts: Vec<String> = Vec::new();
    let evidence = result.evidence();
    if !evidence.is_empty() {
        parts.push(cell(&evidence));
    }
    if let Some(remedy) = claim.remedy {
        parts.push(format!("*{}:* {}", result.remedy_word(), cell(remedy)));
    }
    let experiments = claim.experiments();
    for (title, names) in [("Code", claim.code), ("Experiments", &experiments), ("Figures", claim.figures)] {
        if !names.is_empty() {
            let quoted: Vec<String> = names.iter().map(|name| format!("`{name}`")).collect();
            parts.push(format!("*{title}:* {}", quoted.join(", ")));
        }
    }
    parts.join("<br>")
}

/// Text as it may stand in a cell of a Markdown table.
fn cell(text: &str) -> String {
    text.replace('|', "\\|").replace('*', "\\*")
}

/// The ledger as plain lines for a terminal: claim, place, evidence and finding in turn.
pub fn text(results: &[ClaimResult]) -> String {
    let mut page = String::new();
    for result in results {
        let claim = result.claim;
        page.push_str(&format!(
            "{} | {}, {} | {} | {}\n",
            claim.id,
            claim.place.section,
            claim.place.label,
            result.evidence(),
            result.finding().words()
        ));
    }
    page.push_str(&tally(results));
    page.push_str(".\n");
    page
}
