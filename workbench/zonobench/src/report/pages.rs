//! The two pages.

use experiments::definition::{Experiment, Profile, Verdict as AnswerVerdict};
use experiments::record::{CountOutcome, TimeOutcome};
use paper_checks::{ClaimResult, Verdict};

use super::chapter::{CHAPTERS, Chapter};
use super::claims::{claim_table, verdict};
use super::figures::{DrawnFigure, gallery};
use super::growth::growth_table;
use super::html::{Escaped, badge, grouped, page, prose, table};
use super::values::{time_table, value_table};
use super::{Evidence, FittedGrowth, peers};

const PAPER: &str = "L. J. Guibas, A. Nguyen and L. Zhang, <cite>Zonotopes as Bounding Volumes</cite>, SODA 2003";

/// `report.html`: nothing in it depends on a clock or a machine.
pub fn report(evidence: &Evidence) -> String {
    let mut body = String::from("<main>\n");
    body.push_str(&opening(evidence));
    for chapter in chapters(evidence) {
        body.push_str(&chapter_section(chapter, evidence));
    }
    if evidence.only.is_empty() {
        body.push_str(&peers::section());
    }
    body.push_str(&remaining_section(evidence));
    body.push_str(&ledger_section(evidence));
    body.push_str(&reading_section(evidence));
    body.push_str("</main>\n");
    page("Zonotope Workbench: report", &body)
}

/// `times.html`: what the clock says.
pub fn times(evidence: &Evidence) -> String {
    let environment = &evidence.records.environment;
    let facts = [
        ("version", &environment.version),
        ("revision", &environment.revision),
        ("compiler", &environment.toolchain),
        ("build", &environment.build),
        ("processor", &environment.cpu),
        ("system", &environment.system),
    ];
    let mut body = String::from(
        "<main>\n<header><p class=\"kicker\">Zonotope Workbench</p>\n<h1>Times</h1>\n\
         <p class=\"lead\">What the clock says, on one machine. Growth is judged on operation counts, \
         in the <a href=\"report.html\">report</a>.</p></header>\n<section><h2>Machine</h2>\n",
    );
    let rows: Vec<_> = facts.iter().map(|(name, value)| vec![(*name).to_owned(), Escaped(value).to_string()]).collect();
    body.push_str(&table("facts", &["what", "which"], &rows));
    body.push_str("</section>\n");
    for experiment in evidence.experiments.iter().filter(|experiment| experiment.timing.is_some()) {
        let rows = evidence.records.times.iter().filter(|row| row.key.experiment == experiment.id);
        let void = rows.clone().filter(|row| !matches!(row.outcome, TimeOutcome::Valid { .. })).count();
        body.push_str(&format!(
            "<section><h2>{}</h2>\n\
             <p>{} repetitions, {void} of them void because the answer was wrong or missing.</p>\n",
            Escaped(experiment.title),
            grouped(rows.count() as u64)
        ));
        let fits = fits_of(experiment, evidence).filter(|fit| !fit.is_deterministic());
        body.push_str(&growth_table(&fits.collect::<Vec<_>>()));
        body.push_str(&time_table(experiment, &evidence.records.times));
        body.push_str("</section>\n");
    }
    let figures: Vec<_> = evidence.figures.iter().filter(|drawn| !drawn.figure.deterministic).collect();
    if !figures.is_empty() {
        body.push_str(&format!("<section><h2>Figures</h2>\n{}</section>\n", gallery(&figures)));
    }
    body.push_str("</main>\n");
    page("Zonotope Workbench: times", &body)
}

fn opening(evidence: &Evidence) -> String {
    let count =
        |wanted: fn(&Option<Verdict>) -> bool| evidence.claims.iter().filter(|result| wanted(&result.verdict)).count();
    let holds = count(|verdict| matches!(verdict, Some(Verdict::Holds(_))));
    let refuted = count(|verdict| matches!(verdict, Some(Verdict::Refuted(_))));
    let open = count(|verdict| matches!(verdict, Some(Verdict::Inconclusive(_))));
    let waiting = count(Option::is_none);
    let mut text = format!(
        "<header>\n<p class=\"kicker\">Zonotope Workbench</p>\n<h1>Zonotopes as bounding volumes, running</h1>\n\
         <p class=\"lead\">{PAPER}, describes algorithms on a class of symmetric bodies. This page shows them at \
         work: what each one solves, a picture of it, how its cost grows against the bound in the paper, and whether \
         the paper's statements hold.</p>\n\
         </header>\n<ul class=\"tiles\">\n"
    );
    let cases = evidence.records.counts.len() as u64;
    let wrong = evidence.records.counts.iter().filter(|row| row.fault().is_some()).count() as u64;
    let tiles = [
        (holds as u64, "statements hold"),
        (refuted as u64, "are refuted, with a witness and a remedy"),
        (open as u64, "are undecided"),
        (waiting as u64, "wait for their algorithm"),
        (cases, "runs counted"),
        (wrong, "of them wrong or failed"),
    ];
    for (number, what) in tiles {
        text.push_str(&format!("<li><b>{}</b> {what}</li>\n", grouped(number)));
    }
    text.push_str("</ul>\n");
    if !evidence.only.is_empty() {
        text.push_str(&format!(
            "<p>Only a part was run: {}. Claims that rest on other experiments, or on none, were left out.</p>\n",
            Escaped(&evidence.only.join(", "))
        ));
    }
    text.push_str("<nav><h2>Contents</h2>\n<ol>\n");
    for chapter in chapters(evidence) {
        text.push_str(&format!(
            "<li><a href=\"#{}\">{}</a> <small>{}</small></li>\n",
            chapter.id,
            Escaped(chapter.title),
            Escaped(chapter.place)
        ));
    }
    text.push_str("<li><a href=\"#ledger\">The paper's statements, one by one</a></li>\n");
    text.push_str("<li><a href=\"#reading\">How to read and repeat this</a></li>\n</ol>\n</nav>\n");
    text
}

fn chapter_section(chapter: &Chapter, evidence: &Evidence) -> String {
    let shares = |claims: &[&str]| claims.iter().any(|claim| chapter.claims.contains(claim));
    let mut text = format!(
        "<section id=\"{}\">\n<p class=\"kicker\">{}</p>\n<h2>{}</h2>\n<p class=\"statement\">{}</p>\n",
        chapter.id,
        Escaped(chapter.place),
        Escaped(chapter.title),
        prose(chapter.statement)
    );
    let experiments: Vec<_> = experiments_of(chapter, evidence).collect();
    let results: Vec<_> = evidence.claims.iter().filter(|result| shares(&[result.claim.id])).collect();
    text.push_str(&verdict_line(&experiments, &results, evidence));
    for paragraph in chapter.method {
        text.push_str(&format!("<p>{}</p>\n", prose(paragraph)));
    }
    text.push_str(&format!("<p class=\"bound\"><b>Cost.</b> {}</p>\n", Escaped(chapter.bound)));
    let figures: Vec<&DrawnFigure> = evidence
        .figures
        .iter()
        .filter(|drawn| drawn.figure.deterministic && home_of_figure(drawn) == Some(chapter.id))
        .collect();
    text.push_str(&gallery(&figures));
    for experiment in experiments {
        text.push_str(&experiment_section(experiment, evidence));
    }
    text.push_str("<h3>Run it alone</h3>\n<dl class=\"commands\">\n");
    for (command, effect) in chapter.commands {
        text.push_str(&format!("<dt><code>{}</code></dt><dd>{}</dd>\n", Escaped(command), Escaped(effect)));
    }
    text.push_str("</dl>\n<h3>What the paper says of it</h3>\n");
    text.push_str(&claim_table(&format!("{}-claim", chapter.id), &results));
    text.push_str("</section>\n");
    text
}

/// The chapters that something was found for.
fn chapters(evidence: &Evidence) -> impl Iterator<Item = &'static Chapter> {
    let is_drawn = |chapter: &Chapter| evidence.figures.iter().any(|drawn| home_of_figure(drawn) == Some(chapter.id));
    let is_shown = move |chapter: &&&Chapter| {
        evidence.only.is_empty() || is_drawn(chapter) || experiments_of(chapter, evidence).next().is_some()
    };
    CHAPTERS.iter().filter(is_shown).copied()
}

/// The experiments of a chapter that were run.
fn experiments_of(chapter: &Chapter, evidence: &Evidence) -> impl Iterator<Item = &'static Experiment> {
    evidence.experiments.iter().copied().filter(|experiment| home(experiment) == Some(chapter.id))
}

/// The chapter of an experiment.
fn home(experiment: &Experiment) -> Option<&'static str> {
    let listed = CHAPTERS.iter().find(|chapter| chapter.experiments.contains(&experiment.id));
    listed.map(|chapter| chapter.id).or_else(|| home_of_claims(experiment.claims))
}

/// The chapter of a figure.
fn home_of_figure(drawn: &DrawnFigure) -> Option<&'static str> {
    let experiments = drawn.figure.experiments.iter().filter_map(|id| experiments::catalog::find(id));
    experiments.filter_map(home).next().or_else(|| home_of_claims(drawn.figure.claims))
}

/// The chapter of the first of these claims that has one.
fn home_of_claims(claims: &[&str]) -> Option<&'static str> {
    let home = |claim: &&str| CHAPTERS.iter().find(|chapter| chapter.claims.contains(claim));
    claims.iter().find_map(home).map(|chapter| chapter.id)
}

/// One line that sums a chapter up.
fn verdict_line(experiments: &[&'static Experiment], results: &[&ClaimResult], evidence: &Evidence) -> String {
    let mut parts = Vec::new();
    let laws =
        experiments.iter().flat_map(|experiment| fits_of(experiment, evidence)).filter(|fit| fit.is_deterministic());
    let judged: Vec<_> = laws.filter_map(FittedGrowth::supports_bound).collect();
    if !judged.is_empty() {
        let kept = judged.iter().filter(|&&supported| supported).count();
        let tone = if kept == judged.len() { "good" } else { "bad" };
        parts.push(badge(tone, &format!("growth within the bound in {kept} of {} fits", judged.len())));
    }
    for (tone, word) in
        [("good", "holds"), ("bad", "refuted"), ("open", "inconclusive"), ("plain", "not yet implemented")]
    {
        let count = results.iter().filter(|result| result.word() == word).count();
        if count > 0 {
            parts.push(badge(tone, &format!("{count} {word}")));
        }
    }
    format!("<p class=\"verdict\">{}</p>\n", parts.join(" "))
}

fn fits_of<'a>(experiment: &'static Experiment, evidence: &'a Evidence) -> impl Iterator<Item = &'a FittedGrowth> {
    evidence.fits.iter().filter(|fit| fit.experiment == experiment.id)
}

fn experiment_section(experiment: &'static Experiment, evidence: &Evidence) -> String {
    let rows = evidence.records.counts.iter().filter(|row| row.key.experiment == experiment.id);
    let mut correct = 0_u64;
    let mut unchecked = 0_u64;
    let mut faults = Vec::new();
    for row in rows {
        match (row.fault(), &row.outcome) {
            (Some(fault), _) => faults.push(format!("<code>{}</code>: {}", Escaped(&row.key.case), Escaped(fault))),
            (None, CountOutcome::Measured { verdict: AnswerVerdict::Unchecked(_), .. }) => unchecked += 1,
            (None, _) => correct += 1,
        }
    }
    let mut text = format!(
        "<section class=\"experiment\" id=\"experiment-{}\">\n<h3>{}</h3>\n<p>{}</p>\n<p><small>{} answers checked \
         and right, {} unchecked, {} wrong or failed.</small></p>\n",
        experiment.id,
        Escaped(experiment.title),
        prose(experiment.question),
        grouped(correct),
        grouped(unchecked),
        faults.len()
    );
    if !faults.is_empty() {
        text.push_str(&format!("<ul class=\"faults\"><li>{}</li></ul>\n", faults.join("</li><li>")));
    }
    let fits: Vec<_> = fits_of(experiment, evidence).filter(|fit| fit.is_deterministic()).collect();
    text.push_str(&growth_table(&fits));
    let values = value_table(experiment, &evidence.records.counts);
    if fits.is_empty() || values.is_empty() {
        text.push_str(&values);
    } else {
        text.push_str(&format!("<details>\n<summary>Sizes and other numbers</summary>\n{values}</details>\n"));
    }
    text.push_str("</section>\n");
    text
}

/// Figures and experiments that belong to no chapter.
fn remaining_section(evidence: &Evidence) -> String {
    let figures: Vec<&DrawnFigure> =
        evidence.figures.iter().filter(|drawn| drawn.figure.deterministic && home_of_figure(drawn).is_none()).collect();
    let experiments = evidence.experiments.iter().filter(|experiment| home(experiment).is_none());
    let experiments: Vec<&'static Experiment> = experiments.copied().collect();
    if figures.is_empty() && experiments.is_empty() {
        return String::new();
    }
    let mut text = String::from("<section id=\"parts\">\n<h2>Parts and tools</h2>\n");
    text.push_str(&gallery(&figures));
    for experiment in experiments {
        text.push_str(&experiment_section(experiment, evidence));
    }
    text.push_str("</section>\n");
    text
}

fn ledger_section(evidence: &Evidence) -> String {
    let mut sections: Vec<&str> = evidence.claims.iter().map(|result| result.claim.place.section).collect();
    sections.dedup();
    let mut seen: Vec<&str> = Vec::new();
    sections.retain(|section| {
        let new = !seen.contains(section);
        seen.push(section);
        new
    });
    let mut text = String::from(
        "<section id=\"ledger\">\n<h2>The paper's statements, one by one</h2>\n\
         <p>Every statement, figure and open question of the paper, checked where its algorithm exists. A refuted \
         statement comes with what to read instead.</p>\n",
    );
    for section in sections {
        let results: Vec<_> = evidence.claims.iter().filter(|result| result.claim.place.section == section).collect();
        let (judged, waiting): (Vec<_>, Vec<_>) = results.iter().partition(|result| result.verdict.is_some());
        let marks: Vec<String> = results.iter().map(|result| verdict(result)).collect();
        let open = if judged.is_empty() { "" } else { " open" };
        text.push_str(&format!(
            "<details{open}>\n<summary>Section {} <small>{}</small></summary>\n",
            Escaped(section),
            tally(&marks)
        ));
        if !judged.is_empty() {
            text.push_str(&claim_table("claim", &judged));
        }
        if !waiting.is_empty() {
            let table = claim_table("claim", &waiting);
            text.push_str(&match (judged.is_empty(), waiting.len()) {
                (true, _) => table,
                (false, count) => {
                    format!("<details>\n<summary>{count} that wait for their algorithm</summary>\n{table}</details>\n")
                }
            });
        }
        text.push_str("</details>\n");
    }
    text.push_str("</section>\n");
    text
}

/// "3 × [holds] 2 × [refuted]".
fn tally(marks: &[String]) -> String {
    let mut counted: Vec<(&String, usize)> = Vec::new();
    for mark in marks {
        match counted.iter_mut().find(|(known, _)| *known == mark) {
            Some((_, count)) => *count += 1,
            None => counted.push((mark, 1)),
        }
    }
    counted.iter().map(|(mark, count)| format!("{count} {mark}")).collect::<Vec<_>>().join(" ")
}

fn reading_section(evidence: &Evidence) -> String {
    let profile = match evidence.profile {
        Profile::Quick => "quick",
        Profile::Full => "full",
    };
    format!(
        "<section id=\"reading\">\n<h2>How to read and repeat this</h2>\n\
         <p><b>Growth</b> is judged on operation counts, which are the same on every machine. An exponent <i>a</i> \
         is that of the best power law <i>n<sup>a</sup></i> over the sizes shown, with its 95 % interval; every law \
         is fitted over all sizes and over the last four doublings. “Beyond it” is the exponent that remains after \
         division by the bound: near zero means consistent, below zero that the count grows slower still. “Closest” \
         names the law among n, n log n, n log² n and n² that fits best.</p>\n\
         <p><b>Claims</b> are checked in exact arithmetic on instances from a fixed seed. “Holds” means that it held \
         wherever it was tried; “refuted” shows a witness.</p>\n\
         <p><b>Everything here</b> comes from the profile {profile} with seed {}. <code>manifest.json</code> lists \
         every file with its hash and says which ones must not change from run to run; \
         <code>records/counts.jsonl</code> holds the counts, <a href=\"times.html\"><code>times.html</code></a> what \
         the clock said.</p>\n\
         <pre><code>{}</code></pre>\n</section>\n",
        evidence.seed,
        Escaped(&evidence.command())
    )
}
