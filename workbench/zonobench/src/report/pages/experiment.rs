//! An experiment within a page, folded up.

use experiments::definition::{Experiment, Verdict};
use experiments::findings;
use experiments::measured::Measured;
use experiments::record::CountOutcome;

use crate::report::Evidence;
use crate::report::html::{Escaped, grouped, prose};
use crate::report::repeat::{Repeat, shown};
use crate::report::tables::{growth_table, value_table};

/// The experiment with its laws and its other numbers. It stands open if an answer was wrong.
pub(super) fn folded(experiment: &'static Experiment, evidence: &Evidence) -> String {
    let rows = evidence.records.counts.iter().filter(|row| row.key.experiment == experiment.id);
    let mut correct = 0_u64;
    let mut unchecked = 0_u64;
    let mut faults = Vec::new();
    for row in rows {
        match (row.fault(), &row.outcome) {
            (Some(fault), _) => faults.push(format!("<code>{}</code>: {}", Escaped(&row.key.case), Escaped(fault))),
            (None, CountOutcome::Measured { verdict: Verdict::Unchecked(_), .. }) => unchecked += 1,
            (None, _) => correct += 1,
        }
    }
    let mut text = format!(
        "<details class=\"experiment\" id=\"experiment-{}\"{}>\n<summary>{} <small>{} answers checked and right, {} \
         without a check of their own, {} refused by it</small></summary>\n<p>{}</p>\n",
        experiment.id,
        if faults.is_empty() { "" } else { " open" },
        Escaped(experiment.title),
        grouped(correct),
        grouped(unchecked),
        faults.len(),
        prose(experiment.question),
    );
    text.push_str(&said(&findings::counted(experiment.id, &Measured::of(&evidence.records))));
    if !faults.is_empty() {
        text.push_str(&format!("<ul class=\"faults\"><li>{}</li></ul>\n", faults.join("</li><li>")));
    }
    let fits: Vec<_> = evidence.fits_of(experiment).filter(|fit| fit.is_deterministic()).collect();
    text.push_str(&growth_table(&fits));
    text.push_str(&value_table(experiment, &evidence.records.counts));
    text.push_str(&format!("<p><a href=\"records/{}.counts.csv\">Numbers as CSV</a>", experiment.id));
    let names: Vec<String> =
        experiment.variants.iter().map(|v| format!("<code>{}</code> {}", Escaped(v.id), Escaped(v.title))).collect();
    text.push_str(&format!(", where the methods are: {}", names.join("; ")));
    if experiment.timing.is_some() {
        text.push_str(&format!(". <a href=\"times.html#experiment-{}\">Times</a>", experiment.id));
    }
    text.push_str(".</p>\n");
    if let Some(command) = Repeat::of(evidence).experiment(experiment) {
        text.push_str(&format!("<p>By itself: {}</p>\n", shown(&command)));
    }
    text.push_str("</details>\n");
    text
}

/// Sentences made from the records, as a list; nothing without any.
pub(super) fn said(sentences: &[String]) -> String {
    if sentences.is_empty() {
        return String::new();
    }
    let items: Vec<String> = sentences.iter().map(|sentence| format!("<li>{}</li>", prose(sentence))).collect();
    let note = "<p><small>Numbers are medians over the instances of an input and a size, of an even number the upper \
                one; those of “from … to …” are the least and the greatest of all instances.</small></p>";
    format!("<ul class=\"found\">{}</ul>\n{note}\n", items.join(""))
}
