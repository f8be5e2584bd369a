//! The commands that find a part of a report again.

use experiments::definition::{Experiment, Profile};
use figures::figure::Figure;

use super::evidence::Evidence;
use super::html::Escaped;

/// The command with which a checkout runs the program.
const IN_A_CHECKOUT: &str = "cargo run --release --";

/// The seed of runs that name none.
pub const USUAL_SEED: u64 = 2003;

/// The description of a run, as far as its parts must be asked for in the same way.
#[derive(Debug, Clone, Copy)]
pub(super) struct Repeat {
    profile: Profile,
    seed: u64,
    /// Whether a file of the reader's has changed the experiments, which are found again together alone.
    is_changed: bool,
}

impl Repeat {
    pub(super) fn of(evidence: &Evidence) -> Self {
        Self { profile: evidence.profile, seed: evidence.seed, is_changed: evidence.config.is_some() }
    }

    /// The command that draws a figure of the catalog by itself.
    pub(super) fn figure(self, figure: &Figure) -> Option<String> {
        figures::catalog::find(figure.id).filter(|_| !self.is_changed)?;
        let id = figure.id;
        // alone, a figure is drawn from a quick run
        if self.profile != Profile::Quick && !figure.experiments.is_empty() {
            return Some(self.run_of(id));
        }
        Some(format!("{IN_A_CHECKOUT} figure {id} --svg {id}.svg{}", self.seed_option(figure.experiments.is_empty())))
    }

    /// The command that runs an experiment of the catalog by itself, with its figures.
    pub(super) fn experiment(self, experiment: &Experiment) -> Option<String> {
        (!self.is_changed).then(|| self.run_of(experiment.id))
    }

    fn run_of(self, id: &str) -> String {
        let profile =
            if self.profile == Profile::Quick { String::new() } else { format!(" --profile {}", self.profile) };
        format!("{IN_A_CHECKOUT} reproduce --only {id} --out out/{id}{profile}{}", self.seed_option(false))
    }

    fn seed_option(self, is_fixed: bool) -> String {
        if is_fixed || self.seed == USUAL_SEED { String::new() } else { format!(" --seed {}", self.seed) }
    }
}

/// A command as it stands in a page, to be copied as a whole.
pub(super) fn shown(command: &str) -> String {
    format!("<code class=\"repeat\">{}</code>", Escaped(command))
}
