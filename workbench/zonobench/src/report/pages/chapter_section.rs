//! A chapter within the page: what was learned, its pictures and one table open, all else folded up.

use experiments::analysis::FittedGrowth;
use experiments::definition::{Experiment, Tabulated};
use experiments::fit::{GrowthModel, ModelVerdict};
use paper_checks::Finding;

use super::experiment;
use super::figures::plates;
use super::layout::{Layout, Part};
use crate::report::DrawnFigure;
use crate::report::Evidence;
use crate::report::chapter::{Chapter, ChapterTable, Cost, Held};
use crate::report::html::{Escaped, badge, prose, table};
use crate::report::repeat::Repeat;
use crate::report::tables::{finding_badge, growth_summary, overall_table, value_table, value_table_on};
use experiments::measured::Measured;

/// The chapter.
pub(super) fn section(part: &Part<'_>, layout: &Layout<'_>, evidence: &Evidence) -> String {
    let chapter = part.chapter;
    let mut text = format!(
        "<section id=\"{}\">\n<p class=\"kicker\">{}</p>\n<h2>{}</h2>\n<p class=\"statement\">{}</p>\n",
        chapter.id,
        Escaped(chapter.place),
        Escaped(chapter.title),
        prose(chapter.statement)
    );
    if let Some(lesson) = (chapter.lesson)(&Measured::of(&evidence.records)) {
        text.push_str(&format!("<p class=\"lesson\"><b>What we learned.</b> {}</p>\n", prose(&lesson)));
    }
    text.push_str(&findings(part, evidence));
    let number = |drawn: &DrawnFigure| number_of(layout, drawn);
    text.push_str(&plates(&part.pictures, Repeat::of(evidence), number));
    text.push_str(&open_table(part, evidence));
    text.push_str("<details>\n<summary>How it is solved, and what it costs</summary>\n");
    for paragraph in chapter.method {
        text.push_str(&format!("<p>{}</p>\n", prose(paragraph)));
    }
    let costs: Vec<String> = chapter.costs.iter().map(|cost| cost_line(cost, evidence)).collect();
    text.push_str(&format!("<p><b>Cost.</b> {}</p>\n</details>\n", costs.join(" ")));
    text.push_str(&folded_figures(&part.folded, layout, evidence));
    for experiment in &part.experiments {
        text.push_str(&experiment::folded(experiment, evidence));
    }
    // The commands are about the chapter's own examples, which a run with other inputs does not show.
    if evidence.config.is_none() {
        text.push_str(&commands(chapter));
    }
    text.push_str("</section>\n");
    text
}

/// The plots of experiments that the reader's file has changed, above all else.
pub(super) fn own_section(layout: &Layout<'_>, evidence: &Evidence) -> String {
    if layout.own_figures.is_empty() {
        return String::new();
    }
    let plots = plates(&layout.own_figures, Repeat::of(evidence), |drawn| number_of(layout, drawn));
    format!("<section id=\"own\">\n<h2>Your plots</h2>\n{plots}</section>\n")
}

/// Figures and experiments that belong to no chapter.
pub(super) fn remaining_section(layout: &Layout<'_>, evidence: &Evidence) -> String {
    if layout.other_figures.is_empty() && layout.other_experiments.is_empty() {
        return String::new();
    }
    let mut text = String::from("<section id=\"parts\">\n<h2>Parts and tools</h2>\n");
    text.push_str(&plates(&layout.other_figures, Repeat::of(evidence), |drawn| number_of(layout, drawn)));
    for experiment in &layout.other_experiments {
        text.push_str(&experiment::folded(experiment, evidence));
    }
    text.push_str("</section>\n");
    text
}

fn number_of(layout: &Layout<'_>, drawn: &DrawnFigure) -> Option<usize> {
    layout.number_of(drawn.figure.id)
}

/// The figures that do not stand open, with their titles to choose by.
fn folded_figures(figures: &[&DrawnFigure], layout: &Layout<'_>, evidence: &Evidence) -> String {
    if figures.is_empty() {
        return String::new();
    }
    let title = |drawn: &&DrawnFigure| {
        let number = number_of(layout, drawn).map_or(0, |number| number + 1);
        format!("Figure {number}: {}", prose(drawn.figure.title))
    };
    let titles: Vec<String> = figures.iter().map(title).collect();
    format!(
        "<details>\n<summary>More pictures <small>{}</small></summary>\n{}</details>\n",
        titles.join("; "),
        plates(figures, Repeat::of(evidence), |drawn| number_of(layout, drawn))
    )
}

/// The table that stands open.
fn open_table(part: &Part<'_>, evidence: &Evidence) -> String {
    let rows = &evidence.records.counts;
    let run = |id: &str| part.experiments.iter().find(|experiment| experiment.id == id);
    match part.chapter.table {
        ChapterTable::Growth => growth_summary(&laws(&part.experiments, evidence)),
        ChapterTable::Values(id) => run(id).map_or_else(String::new, |experiment| match experiment.table {
            Tabulated::Total => overall_table(experiment, rows),
            Tabulated::MedianAtLargest => value_table(experiment, rows),
        }),
        ChapterTable::ValuesOn(id, input) => {
            run(id).map_or_else(String::new, |experiment| value_table_on(experiment, input, rows))
        }
        ChapterTable::Words { head, rows } => {
            let row = |row: &&[&str]| row.iter().map(|cell| prose(cell)).collect();
            table("words", head, &rows.iter().map(row).collect::<Vec<Vec<String>>>())
        }
    }
}

/// The laws of operation counts and values of some experiments.
fn laws<'a>(experiments: &[&'static Experiment], evidence: &'a Evidence) -> Vec<&'a FittedGrowth> {
    let all = experiments.iter().flat_map(|experiment| evidence.fits_of(experiment));
    all.filter(|fit| fit.is_deterministic()).collect()
}

/// The growth beside the bounds, and the chapter's claims by what was found, each a link to the
/// ledger.
fn findings(part: &Part<'_>, evidence: &Evidence) -> String {
    let mut lines = Vec::new();
    let verdicts: Vec<ModelVerdict> =
        laws(&part.experiments, evidence).into_iter().filter_map(FittedGrowth::verdict).collect();
    use ModelVerdict::{Above, Below, Kept, Undecided, Within};
    let counted = |of: &[ModelVerdict]| verdicts.iter().filter(|verdict| of.contains(verdict)).count();
    let growth: [(&[ModelVerdict], &str, &str); 4] = [
        (&[Within, Below], "good", "growth within the bound or below it"),
        (&[Kept], "good", "no sample beyond a bound that is a number"),
        (&[Above], "bad", "growth above the bound"),
        (&[Undecided], "plain", "growth undecided"),
    ];
    let badges: Vec<String> = growth
        .into_iter()
        .map(|(of, tone, words)| (counted(of), tone, words))
        .filter(|(count, ..)| *count > 0)
        .map(|(count, tone, words)| badge(tone, &format!("{words} in {count} of {} fits", verdicts.len())))
        .collect();
    if !badges.is_empty() {
        lines.push(badges.join(" "));
    }
    for finding in Finding::ALL {
        let links: Vec<String> = part
            .results
            .iter()
            .filter(|result| result.finding() == finding)
            .map(|result| format!("<a href=\"#claim-{0}\">{0}</a>", result.claim.id))
            .collect();
        if !links.is_empty() {
            lines.push(format!("{} {}", finding_badge(finding), links.join(", ")));
        }
    }
    format!("<p class=\"findings\">{}</p>\n", lines.join("<br>\n"))
}

/// A law of a cost with a link to what holds it, where the page has that, and how far that bears it.
fn cost_line(cost: &Cost, evidence: &Evidence) -> String {
    let (anchor, name, found) = match cost.held {
        Held::Claim(id) => {
            let result = evidence.claims.iter().find(|result| result.claim.id == id);
            ("claim", id, result.map(|result| format!(": {}", result.finding().words())))
        }
        Held::Fit { experiment, method, law } => {
            let shown = evidence.experiments.iter().find(|shown| shown.id == experiment);
            ("experiment", experiment, shown.map(|shown| judged(evidence.fits_of(shown), method, law)))
        }
    };
    match found {
        Some(found) => format!("{} <small>(<a href=\"#{anchor}-{name}\">{name}</a>{found})</small>", prose(cost.text)),
        None => prose(cost.text),
    }
}

/// The number of fits of a method against a law that keep it, and of those that do not or leave it open.
fn judged<'a>(fits: impl Iterator<Item = &'a FittedGrowth>, method: &str, law: GrowthModel) -> String {
    let judges = |fit: &&FittedGrowth| fit.variant == method && fit.bound.is_some_and(|bound| bound.model == law);
    let verdicts: Vec<ModelVerdict> = fits.filter(judges).filter_map(|fit| fit.verdict()).collect();
    let count = |keeps: Option<bool>| verdicts.iter().filter(|verdict| verdict.keeps_bound() == keeps).count();
    let all = verdicts.len();
    let counted = [(Some(true), "kept"), (Some(false), "exceeded"), (None, "undecided")]
        .map(|(keeps, word)| (count(keeps), word))
        .into_iter()
        .filter(|(count, _)| *count > 0)
        .map(|(count, word)| format!("{word} in {count} of {all} fits"));
    let words: Vec<String> = counted.collect();
    if words.is_empty() { String::new() } else { format!(": {}", words.join(", ")) }
}

fn commands(chapter: &Chapter) -> String {
    let mut text = String::from("<details>\n<summary>Run it alone</summary>\n<dl class=\"commands\">\n");
    for (command, effect) in chapter.commands {
        text.push_str(&format!("<dt><code>{}</code></dt><dd>{}</dd>\n", Escaped(command), Escaped(effect)));
    }
    text.push_str("</dl>\n</details>\n");
    text
}
