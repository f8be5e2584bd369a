//! The two pages.

mod chapter_section;
mod experiment;
mod figures;
mod laws;
mod layout;
mod ledger;
mod opening;
mod peers;
mod reading;

use experiments::environment::Environment;
use experiments::measured::Measured;
use experiments::record::TimeOutcome;

pub use reading::CITATION;

use self::figures::plates;
use self::layout::Layout;
use super::Evidence;
use super::html::{Escaped, grouped, page, table};
use super::repeat::Repeat;
use super::tables::{growth_table, time_table};
use crate::report::DrawnFigure;

/// `report.html`: nothing in it depends on a clock or a machine.
pub fn report(evidence: &Evidence) -> String {
    let layout = Layout::of(evidence);
    let mut body = String::from("<main>\n");
    body.push_str(&opening::section(&layout, evidence));
    body.push_str(&chapter_section::own_section(&layout, evidence));
    for part in &layout.parts {
        body.push_str(&chapter_section::section(part, &layout, evidence));
    }
    if evidence.only.is_empty() {
        body.push_str(&peers::section());
    }
    body.push_str(&chapter_section::remaining_section(&layout, evidence));
    body.push_str(&laws::section(evidence));
    body.push_str(&ledger::section(&layout, evidence));
    body.push_str(&reading::section(evidence));
    body.push_str("</main>\n");
    page("Zonotope Workbench: report", &body)
}

/// The facts about a machine and the program on it.
fn machine_table(environment: &Environment) -> String {
    let facts = [
        ("version", &environment.version),
        ("source revision when run", &environment.revision),
        ("compiler", &environment.toolchain),
        ("build", &environment.build),
        ("processor", &environment.cpu),
        ("system", &environment.system),
    ];
    let rows: Vec<_> = facts.iter().map(|(name, value)| vec![(*name).to_owned(), Escaped(value).to_string()]).collect();
    table("facts", &["what", "which"], &rows)
}

/// `times.html`: what the clock says.
pub fn times(evidence: &Evidence) -> String {
    let elsewhere = &evidence.records.elsewhere;
    let machines = if elsewhere.is_empty() { std::slice::from_ref(&evidence.records.environment) } else { elsewhere };
    let place = if machines.len() == 1 { "on one machine" } else { "on several machines, each row on one of them" };
    let mut body = format!(
        "<main>\n<header><p class=\"kicker\">Zonotope Workbench</p>\n<h1>Times</h1>\n\
         <p class=\"lead\">What the clock says, {place}. Growth is judged on operation counts, \
         in the <a href=\"report.html\">report</a>.</p></header>\n<section id=\"machine\"><h2>Machine</h2>\n",
    );
    for environment in machines {
        body.push_str(&machine_table(environment));
    }
    body.push_str("</section>\n");
    for experiment in evidence.experiments.iter().filter(|experiment| experiment.timing.is_some()) {
        let rows = evidence.records.times.iter().filter(|row| row.key.experiment == experiment.id);
        let void = rows.clone().filter(|row| !matches!(row.outcome, TimeOutcome::Valid { .. })).count();
        body.push_str(&format!(
            "<section id=\"experiment-{}\"><h2>{}</h2>\n\
             <p>{} repetitions, {void} of them void because the answer was wrong or missing.</p>\n",
            experiment.id,
            Escaped(experiment.title),
            grouped(rows.count() as u64)
        ));
        let said = experiments::findings::timed(experiment.id, &Measured::of(&evidence.records));
        body.push_str(&experiment::said(&said));
        let fits = evidence.fits_of(experiment).filter(|fit| !fit.is_deterministic());
        body.push_str(&growth_table(&fits.collect::<Vec<_>>()));
        body.push_str(&time_table(experiment, &evidence.records.times));
        body.push_str("</section>\n");
    }
    let figures: Vec<&DrawnFigure> = evidence.figures.iter().filter(|drawn| !drawn.figure.deterministic).collect();
    if !figures.is_empty() {
        let number = |drawn: &DrawnFigure| figures.iter().position(|other| other.figure.id == drawn.figure.id);
        body.push_str(&format!(
            "<section><h2>Figures</h2>\n{}</section>\n",
            plates(&figures, Repeat::of(evidence), number)
        ));
    }
    body.push_str("</main>\n");
    page("Zonotope Workbench: times", &body)
}

#[cfg(test)]
mod tests;
