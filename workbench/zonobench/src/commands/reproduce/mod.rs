//! `zonobench reproduce`: every experiment, figure and claim, and the report of them.

mod config;
mod folder;
mod own_plots;
mod selection;

use std::io::{self, Write};
use std::path::{Path, PathBuf};

use clap::{Args, ValueEnum};
use experiments::data;
use experiments::definition::Profile;
use experiments::findings;
use experiments::measured::Measured;
use experiments::runner::{self, Records, RunOptions};
use figures::figure::{Figure, FigureInput};
use paper_checks::catalog::CLAIMS;
use paper_checks::{ClaimResult, Finding};

use self::config::Config;
use self::folder::{Folder, RECORDS};
use self::selection::Selection;
use super::Ending;
use super::records::table;
use crate::output::{Existing, write_whole};
use crate::progress::{Progress, RunProgress};
use crate::report::{self, Evidence, MANIFEST, Manifest, OutputFile, USUAL_SEED};

/// Options of `reproduce`.
#[derive(Debug, Args)]
pub struct Options {
    /// The profile: a few minutes, or everything up to the largest sizes.
    #[arg(long, value_enum, default_value_t = Extent::Quick)]
    profile: Extent,
    /// The folder for the report and all that belongs to it.
    #[arg(long, value_name = "DIR", default_value = "out/reproduce")]
    out: PathBuf,
    /// The seed of all random numbers.
    #[arg(long, default_value_t = USUAL_SEED)]
    seed: u64,
    /// Threads for counting; all processors if absent.
    ///
    /// Times are taken on one.
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=1024))]
    threads: Option<u16>,
    /// Run these experiments alone, or those that these figures show; `list` names them.
    ///
    /// Their figures are drawn and the claims checked that rest on nothing else.
    #[arg(long, value_name = "ID", num_args = 1..)]
    only: Vec<String>,
    /// Run the experiments of a TOML file alone, as it changes them, and plot them.
    ///
    /// The file has families, sizes, variants and own files as inputs.
    #[arg(long, value_name = "FILE", conflicts_with = "only")]
    config: Option<PathBuf>,
    /// Write into the folder although it holds something.
    #[arg(long)]
    force: bool,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Extent {
    Quick,
    Full,
}

impl From<Extent> for Profile {
    fn from(extent: Extent) -> Self {
        match extent {
            Extent::Quick => Self::Quick,
            Extent::Full => Self::Full,
        }
    }
}

/// Runs everything and writes the folder; the manifest comes last, so a folder with a manifest is complete.
pub fn run(options: &Options) -> anyhow::Result<Ending> {
    let plan = Plan::of(options)?;
    let selection = &plan.selection;
    let folder = Folder::claim(&options.out, options.force)?;
    let profile = Profile::from(options.profile);
    let records = run_experiments(options, profile, &plan, &folder)?;
    let fits = report::fits(&selection.experiments, &records);
    let mut figures = draw_figures(&selection.figures, &records);
    if options.config.is_some() {
        figures.extend(selection.experiments.iter().flat_map(|experiment| own_plots::of(experiment, &records)));
    }
    let claims = check_claims(&plan, &report::check_context(options.seed, &fits));
    let evidence = Evidence {
        profile,
        seed: options.seed,
        only: plan.only.clone(),
        config: options.config.clone(),
        experiments: selection.experiments.clone(),
        records,
        fits,
        figures,
        claims,
    };

    let written = write_all(options, profile, &plan, folder, &evidence);
    let told = summarize(&evidence, written.is_ok().then_some(options.out.as_path()));
    written.and(told)
}

/// Writes what was found; the manifest comes last.
fn write_all(
    options: &Options,
    profile: Profile,
    plan: &Plan,
    folder: Folder,
    evidence: &Evidence,
) -> anyhow::Result<()> {
    let mut outputs = folder.record_files()?;
    let mut write = |path: &str, content: &[u8], deterministic: bool| -> anyhow::Result<()> {
        write_whole(&options.out.join(path), content, Existing::Replace)?;
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
    if plan.is_whole() {
        let ledger = paper_checks::markdown(&evidence.claims, paper_checks::OF_A_RUN);
        write("CLAIMS.md", ledger.as_bytes(), true)?;
    }
    write("CITATION.cff", report::CITATION.as_bytes(), true)?;
    write("report.html", report::report(evidence).as_bytes(), true)?;
    write("times.html", report::times(evidence).as_bytes(), false)?;

    outputs.sort_by(|a, b| a.path.cmp(&b.path));
    let manifest = Manifest {
        version: env!("CARGO_PKG_VERSION").to_owned(),
        profile: profile.to_string(),
        seed: options.seed,
        command: evidence.command(),
        environment: evidence.records.environment.clone(),
        outputs,
    };
    let manifest = format!("{}\n", serde_json::to_string_pretty(&manifest)?);
    write_whole(&options.out.join(MANIFEST), manifest.as_bytes(), Existing::Replace)?;
    Ok(folder.release()?)
}

/// The words that a person wants at the end; the ending is bad if an answer was wrong or a figure is missing.
fn summarize(evidence: &Evidence, out: Option<&Path>) -> anyhow::Result<Ending> {
    let faults = evidence.records.counts.iter().filter_map(|row| Some((&row.key.case, row.fault()?)));
    let missing = evidence.figures.iter().filter_map(|figure| Some((figure.figure.id, figure.drawing.as_ref().err()?)));
    let mut output = io::stdout().lock();
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
    for (case, fault) in faults {
        ending = Ending::Bad;
        writeln!(output, "WRONG {case}: {fault}")?;
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
    Ok(ending)
}

/// The extent of a run.
struct Plan {
    selection: Selection,
    /// The ids that the run is restricted to.
    only: Vec<String>,
    /// A name for the content of the reader's own files.
    own_inputs: String,
}

impl Plan {
    fn of(options: &Options) -> anyhow::Result<Self> {
        let Some(file) = &options.config else {
            let selection = Selection::of(&options.only)?;
            return Ok(Self { selection, only: options.only.clone(), own_inputs: String::new() });
        };
        let Config { experiments, inputs, inputs_digest } = Config::read(file)?;
        data::add_inputs(inputs)?;
        let only = experiments.iter().map(|experiment| experiment.id.to_owned()).collect();
        // Figures and claims are about the experiments of the catalog.
        let selection = Selection { experiments, figures: Vec::new(), claims: Vec::new() };
        Ok(Self { selection, only, own_inputs: inputs_digest })
    }

    fn is_whole(&self) -> bool {
        self.only.is_empty()
    }
}

fn run_experiments(options: &Options, profile: Profile, plan: &Plan, folder: &Folder) -> anyhow::Result<Records> {
    let run = RunOptions {
        profile,
        seed: options.seed,
        threads: options.threads.map_or(0, usize::from),
        directory: Some(folder.records()),
        times: true,
        own_inputs: plan.own_inputs.clone(),
    };
    Ok(runner::run(&plan.selection.experiments, &run, &RunProgress::default())?)
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
