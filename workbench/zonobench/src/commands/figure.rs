//! `zonobench figure`: one figure of the report, drawn alone.

use std::path::PathBuf;

use clap::Args;
use experiments::definition::{Experiment, Profile};
use experiments::runner::{self, RunOptions};
use figures::figure::FigureInput;

use super::Ending;
use super::usage::{Usage, check_names};
use crate::output::{Existing, Outputs};
use crate::progress::RunProgress;
use crate::report::USUAL_SEED;

/// Options of `figure`.
#[derive(Debug, Args)]
pub struct Options {
    /// The figure; `list figures` names them.
    id: String,
    /// Write the picture; `-` is standard output.
    #[arg(long, value_name = "FILE")]
    svg: PathBuf,
    /// The seed of the experiments that the figure shows, if it shows any.
    #[arg(long, default_value_t = USUAL_SEED)]
    seed: u64,
    /// Replace a file that exists.
    #[arg(long)]
    force: bool,
}

/// Runs the experiments that the figure shows, in the quick profile, and draws it.
pub fn run(options: &Options) -> anyhow::Result<Ending> {
    let figure = figures::catalog::find(&options.id).ok_or_else(|| {
        let experiment = experiments::catalog::find(&options.id);
        experiment.map_or_else(|| Usage::UnknownId(options.id.clone()), |experiment| Usage::NoFigure(experiment.id))
    })?;
    check_names(&[("SVG", Some(&options.svg))])?;
    let outputs = Outputs::checked([&options.svg], &[], Existing::from_force(options.force))?;
    let experiments: Vec<&'static Experiment> =
        figure.experiments.iter().filter_map(|id| experiments::catalog::find(id)).collect();
    let run = RunOptions {
        profile: Profile::Quick,
        seed: options.seed,
        threads: 0,
        directory: None,
        times: !figure.deterministic,
        own_inputs: String::new(),
        shard: None,
    };
    let records = runner::run(&experiments, &run, &RunProgress::default())?;
    let svg = figure.draw(&FigureInput { records: Some(&records) })?;
    outputs.finish_one(&options.svg, svg.as_bytes(), &format!("{}\n{}\n", figure.title, figure.caption))?;
    Ok(Ending::Good)
}
