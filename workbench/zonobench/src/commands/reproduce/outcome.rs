//! The outcome of a run: growth laws, figures and claims from its records, and the folder that holds all of them.

use std::io::Write;
use std::path::Path;

use experiments::findings;
use experiments::measured::Measured;
use experiments::runner::Records;
use figures::figure::{Figure, FigureInput};
use paper_checks::catalog::CLAIMS;
use paper_checks::{ClaimResult, Finding};

use super::folder::{Folder, RECORDS};
use super::own_plots;
use super::plan::Plan;
use crate::commands::Ending;
use crate::commands::records::table;
use crate::output::{Existing, write_whole};
use crate::progress::Progress;
use crate::report::{self, Evidence, MANIFEST, Manifest, OutputFile};
use crate::standard_output::StandardOutput;

/// Finds what the records show, writes it into the folder, and tells it.
pub(super) fn write(out: &Path, plan: Plan, folder: Folder, records: Records) -> anyhow::Result<Ending> {
    let (selection, request) = (&plan.selection, &plan.request);
    let fits = report::fits(&selection.experiments, &records);
    let mut figures = draw_figures(&selection.figures, &records);
    if request.config.is_some() {
        figures.extend(selection.experiments.iter().flat_map(|experiment| own_plots::of(experiment, &records)));
    }
    let claims = check_claims(&plan, &report::check_context(request.seed, &fits));
    let evidence = Evidence {
        profile: request.profile,
        seed: request.seed,
        only: plan.only,
        config: plan.request.config,
        experiments: plan.selection.experiments,
        records,
        fits,
        figures,
        claims,
    };
    let written = write_all(out, folder, &evidence);
    let told = summarize(&evidence, written.is_ok().then_some(out));
    written.and(told)
}

/// Writes what was found; the manifest comes last.
fn write_all(out: &Path, folder: Folder, evidence: &Evidence) -> anyhow::Result<()> {
    let mut outputs = folder.record_files()?;
    let mut write = |path: &str, content: &[u8], deterministic: bool| -> anyhow::Result<()> {
        write_whole(&out.join(path), content, Existing::Replace)?;
        outputs.push(OutputFile::new(path, content, deterministic));
        Ok(())
    };
    for experiment in &evidence.experiments {
        let Records { counts, times, .. } = &evidence.records;
        let counts = counts.iter().filter(|row| row.key.experiment == experiment.id);
        write(&format!("{RECORDS}/{}.counts.csv", experiment.id), &table::csv(counts, [])?, true)?;
        if experiment.timing.is_some() {
            let times = times.iter().filter(|row| row.key.experiment == experiment.id);
            write(&format!("{RECORDS}/{}.times.csv", experiment.id), &table::csv([], times)?, false)?;
        }
    }
    for figure in &evidence.figures {
        if let Ok(svg) = &figure.drawing {
            write(&figure.path(), svg.as_bytes(), figure.figure.deterministic)?;
        }
    }
    if evidence.only.is_empty() {
        let ledger = paper_checks::markdown(&evidence.claims, paper_checks::OF_A_RUN);
        write("CLAIMS.md", ledger.as_bytes(), true)?;
    }
    write("CITATION.cff", report::CITATION.as_bytes(), true)?;
    write("report.html", report::report(evidence).as_bytes(), true)?;
    write("times.html", report::times(evidence).as_bytes(), false)?;

    outputs.sort_by(|a, b| a.path.cmp(&b.path));
    let manifest = Manifest {
        version: env!("CARGO_PKG_VERSION").to_owned(),
        profile: evidence.profile.to_string(),
        seed: evidence.seed,
        command: evidence.command(),
        environment: evidence.records.environment.clone(),
        outputs,
    };
    let manifest = format!("{}\n", serde_json::to_string_pretty(&manifest)?);
    write_whole(&out.join(MANIFEST), manifest.as_bytes(), Existing::Replace)?;
    Ok(folder.release()?)
}

/// The words that a person wants at the end; the ending is bad if an answer was wrong or a figure is missing.
fn summarize(evidence: &Evidence, out: Option<&Path>) -> anyhow::Result<Ending> {
    let faults = evidence.records.counts.iter().filter_map(|row| Some((row, row.fault()?)));
    let missing = evidence.figures.iter().filter_map(|figure| Some((figure.figure.id, figure.drawing.as_ref().err()?)));
    let mut output = StandardOutput::open()?;
    writeln!(output, "{} runs counted, {} times kept", evidence.records.counts.len(), evidence.records.times.len())?;
    writeln!(output, "{} figures drawn", evidence.figures.iter().filter(|figure| figure.drawing.is_ok()).count())?;
    let findings = if evidence.claims.is_empty() { &[][..] } else { &Finding::ALL[..] };
    for &finding in findings {
        let count = evidence.claims.iter().filter(|result| result.finding() == finding).count();
        writeln!(output, "{count} claims: {}", finding.words())?;
    }
    let left_out = CLAIMS.len() - evidence.claims.len();
    if left_out > 0 {
        let reason = match evidence.config {
            Some(_) => "they are about the experiments of the catalog",
            None => "they rest on other experiments or on none",
        };
        writeln!(output, "{left_out} claims: left out; {reason}")?;
    }
    let mut ending = Ending::Good;
    for (row, fault) in faults {
        ending = Ending::Bad;
        let word = if row.has_failed() { "FAILED" } else { "WRONG" };
        writeln!(output, "{word} {}: {fault}", row.key.case)?;
    }
    for (id, reason) in missing {
        ending = Ending::Bad;
        writeln!(output, "NOT DRAWN {id}: {reason}")?;
    }
    if evidence.config.is_none() {
        let found = Measured::of(&evidence.records);
        for experiment in &evidence.experiments {
            let unsaid = findings::unsaid(experiment.id, &found);
            if unsaid > 0 {
                ending = Ending::Bad;
                writeln!(output, "NO NUMBERS for {unsaid} sentences about {}", experiment.id)?;
            }
        }
    }
    if let Some(out) = out {
        writeln!(output, "{}", out.join("report.html").display())?;
    }
    output.finish()?;
    Ok(ending)
}

fn draw_figures(figures: &[&'static Figure], records: &Records) -> Vec<report::DrawnFigure> {
    let input = FigureInput { records: Some(records) };
    let progress = Progress::of(figures.len() as u64, "figures");
    figures
        .iter()
        .map(|figure| {
            let drawn = report::DrawnFigure::draw(figure, &input);
            progress.step();
            drawn
        })
        .collect()
}

fn check_claims(plan: &Plan, context: &paper_checks::CheckContext) -> Vec<ClaimResult> {
    let selection = &plan.selection;
    let progress = Progress::of(selection.claims.len() as u64, "claims");
    if plan.is_whole() {
        return paper_checks::run(context, |_| progress.step());
    }
    let checked = selection.claims.iter().map(|&claim| {
        let verdict = paper_checks::verdict(claim, context);
        progress.step();
        ClaimResult { claim, verdict }
    });
    checked.collect()
}
