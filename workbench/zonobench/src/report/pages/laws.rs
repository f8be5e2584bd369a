//! The growth laws of the whole page by their verdicts, and those that are undecided, one by one.

use experiments::analysis::FittedGrowth;
use experiments::fit::ModelVerdict;

use crate::report::Evidence;
use crate::report::html::{Escaped, badge, grouped, prose, table};
use crate::report::tables::{beyond, method_title, quantity_name};

/// The section; nothing where no law has a bound.
pub(super) fn section(evidence: &Evidence) -> String {
    let fits: Vec<&FittedGrowth> = evidence.fits.iter().filter(|fit| fit.is_deterministic()).collect();
    let judged = |is_of_paper: bool, verdict: ModelVerdict| {
        let is_counted =
            |fit: &&&FittedGrowth| fit.paper_place().is_some() == is_of_paper && fit.verdict() == Some(verdict);
        fits.iter().filter(is_counted).count() as u64
    };
    if fits.iter().all(|fit| fit.verdict().is_none()) {
        return String::new();
    }
    let rows: Vec<Vec<String>> = [(true, "bounds of the paper"), (false, "bounds of our own")]
        .into_iter()
        .map(|(is_of_paper, name)| {
            let counts = ModelVerdict::ALL.map(|verdict| grouped(judged(is_of_paper, verdict)));
            [name.to_owned()].into_iter().chain(counts).collect()
        })
        .collect();
    let measured = fits.iter().filter(|fit| fit.growth.is_ok() && fit.verdict().is_none()).count();
    let mut text = format!(
        "<section id=\"laws\">\n<h2>Growth laws by what was found</h2>\n\
         <p>Every law on the counts of an experiment, over all sizes and over the last doublings. A bound is kept \
         where the whole interval is at most the slack of 0.05; where the interval reaches beyond it and does not lie \
         beyond it altogether, the law is {}. A bound that is a number is kept by all \
         where no sample exceeds it, whatever the interval. {} more laws have no bound.</p>\n",
        badge("plain", "undecided"),
        grouped(measured as u64)
    );
    text.push_str(&table("laws", &["", "within", "below", "kept by all", "above", "undecided"], &rows));
    let lists = [(ModelVerdict::Above, "exceeded", "Exceeded"), (ModelVerdict::Undecided, "undecided", "Undecided")];
    for (verdict, word, heading) in lists {
        for (is_of_paper, name) in [(true, "of the paper"), (false, "of our own")] {
            let is_listed =
                |fit: &&&FittedGrowth| fit.paper_place().is_some() == is_of_paper && fit.verdict() == Some(verdict);
            let listed: Vec<&FittedGrowth> = fits.iter().filter(is_listed).copied().collect();
            if listed.is_empty() {
                text.push_str(&format!("<p>No bound {name} is {word}.</p>\n"));
            } else {
                let items: String = listed.iter().copied().map(item).collect();
                text.push_str(&format!(
                    "<details><summary>{heading} bounds {name}: {}</summary>\n<ul class=\"undecided\">\n{items}</ul>\n\
                     </details>\n",
                    listed.len()
                ));
            }
        }
    }
    let without: String = fits.iter().filter_map(|fit| without_law(fit)).collect();
    if !without.is_empty() {
        text.push_str(&format!(
            "<p>Bounds that no law was fitted for:</p>\n<ul class=\"undecided\">\n{without}</ul>\n"
        ));
    }
    text.push_str("</section>\n");
    text
}

/// A bound whose quantity has no law, with the reason; nothing where it has one.
fn without_law(fit: &FittedGrowth) -> Option<String> {
    let (Some(_), Err(reason)) = (fit.bound, &fit.growth) else { return None };
    Some(format!(
        "<li><a href=\"#experiment-{0}\">{0}</a>: {1} of {2} on {3}: {4}</li>\n",
        fit.experiment,
        quantity_name(fit),
        method_title(fit),
        Escaped(&fit.family.replace('_', " ")),
        Escaped(&reason.to_string()),
    ))
}

/// A law that is exceeded or undecided, in a line.
fn item(fit: &FittedGrowth) -> String {
    let (Ok(growth), Some(bound)) = (&fit.growth, fit.bound_fit()) else { return String::new() };
    let law = fit.bound.and_then(|bound| bound.most).map_or_else(|| bound.model.to_string(), |most| most.to_string());
    let place = fit.paper_place().map_or_else(String::new, |place| format!(" of {place}"));
    format!(
        "<li><a href=\"#experiment-{0}\">{0}</a>: {1} of {2} on {3}, n = {4} to {5}: beyond {6}{place} by {7}</li>\n",
        fit.experiment,
        quantity_name(fit),
        method_title(fit),
        Escaped(&fit.family.replace('_', " ")),
        grouped(growth.smallest as u64),
        grouped(growth.largest as u64),
        prose(&law),
        beyond(fit),
    )
}
