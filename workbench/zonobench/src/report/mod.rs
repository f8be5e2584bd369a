//! The report: what experiments, figures and claims found, as pages that need nothing but a browser.
//!
//! `report.html` holds nothing that depends on a clock or a machine, so that two runs with one seed and profile give
//! the same bytes; what depends on them stands in `times.html`.

pub mod chapter;
mod chapters;
mod claims;
mod figures;
mod growth;
mod html;
mod manifest;
mod pages;
mod peers;
mod totals;
mod values;
mod variant;

use std::path::PathBuf;

use experiments::analysis::{self, FittedGrowth};
use experiments::definition::{Experiment, Profile};
use experiments::runner::Records;
use paper_checks::{CheckContext, ClaimResult};

pub use figures::DrawnFigure;
pub use manifest::{Manifest, OutputFile};
pub use pages::{report, times};

/// Everything that a report is made of.
#[derive(Debug)]
pub struct Evidence {
    /// How much was run.
    pub profile: Profile,
    /// The master seed.
    pub seed: u64,
    /// The ids that the run was restricted to; empty if everything was run.
    pub only: Vec<String>,
    /// The file that changed the experiments, if there was one.
    pub config: Option<PathBuf>,
    /// The experiments that were run.
    pub experiments: Vec<&'static Experiment>,
    /// What the experiments recorded.
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
}

/// All growth laws of experiments that were run.
pub fn fits(experiments: &[&Experiment], records: &Records) -> Vec<FittedGrowth> {
    experiments.iter().flat_map(|experiment| analysis::fits(experiment, records)).collect()
}

/// What the claims' checks are told of the growth that operation counts show.
pub fn check_context(seed: u64, fits: &[FittedGrowth]) -> CheckContext {
    CheckContext { seed, measurements: growth::measurements(fits) }
}
