//! The evidence that a report shows: records, fits, figures and verdicts of one run.

use super::tables;
use experiments::analysis::{self, FittedGrowth};
use experiments::definition::{Experiment, Profile};
use experiments::runner::Records;
use figures::figure::Figure;
use paper_checks::{CheckContext, ClaimResult};
use std::path::PathBuf;

/// A figure with its drawing.
#[derive(Debug)]
pub struct DrawnFigure {
    /// The figure.
    pub figure: &'static Figure,
    /// The SVG document, or why there is none.
    pub drawing: Result<String, String>,
}

/// Everything that a report is made of.
#[derive(Debug)]
pub struct Evidence {
    /// The profile that was run.
    pub profile: Profile,
    /// The master seed.
    pub seed: u64,
    /// The ids that the run was restricted to; empty if everything was run.
    pub only: Vec<String>,
    /// The file that changed the experiments, if there was one.
    pub config: Option<PathBuf>,
    /// The experiments that were run.
    pub experiments: Vec<&'static Experiment>,
    /// The records of the experiments.
    pub records: Records,
    /// The growth laws found in the records, in the order of the catalog.
    pub fits: Vec<FittedGrowth>,
    /// The figures.
    pub figures: Vec<DrawnFigure>,
    /// The paper's claims with their verdicts.
    pub claims: Vec<ClaimResult>,
}

impl Evidence {
    /// The command line that finds it again.
    pub fn command(&self) -> String {
        let only = match &self.config {
            Some(config) => format!(" --config {}", config.display()),
            None if self.only.is_empty() => String::new(),
            None => format!(" --only {}", self.only.join(" ")),
        };
        format!("zonobench reproduce --profile {} --seed {}{only}", self.profile, self.seed)
    }

    /// The growth laws of an experiment.
    pub(crate) fn fits_of<'a>(&'a self, experiment: &'a Experiment) -> impl Iterator<Item = &'a FittedGrowth> {
        self.fits.iter().filter(|fit| fit.experiment == experiment.id)
    }
}

/// All growth laws of experiments that were run.
pub fn fits(experiments: &[&Experiment], records: &Records) -> Vec<FittedGrowth> {
    experiments.iter().flat_map(|experiment| analysis::fits(experiment, records)).collect()
}

/// The measurements that the claims' checks are told of the growth that operation counts show.
pub fn check_context(seed: u64, fits: &[FittedGrowth]) -> CheckContext {
    CheckContext { seed, measurements: tables::measurements(fits) }
}
