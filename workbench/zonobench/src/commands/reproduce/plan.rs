//! The extent of a run.

use std::fs;
use std::path::PathBuf;

use experiments::data;
use experiments::definition::Profile;
use experiments::runner::RunOptions;
use serde_json::{Value, json};

use super::config::Config;
use super::selection::Selection;
use crate::digest::sha256;

/// A request for a run: with one program, the same one gives the same records.
#[derive(Debug, Clone)]
pub(super) struct Request {
    pub(super) profile: Profile,
    pub(super) seed: u64,
    /// The ids of experiments and figures that the run is restricted to.
    pub(super) only: Vec<String>,
    /// The file that changes experiments.
    pub(super) config: Option<PathBuf>,
}

/// The extent of a run.
pub(super) struct Plan {
    pub(super) request: Request,
    pub(super) selection: Selection,
    /// The ids that the run is restricted to.
    pub(super) only: Vec<String>,
    /// A name for the content of the reader's own files.
    own_inputs: String,
    /// A name for the content of the file that changes experiments.
    config_digest: Option<String>,
}

impl Plan {
    pub(super) fn of(request: Request) -> anyhow::Result<Self> {
        let Some(file) = &request.config else {
            let (selection, only) = (Selection::of(&request.only)?, request.only.clone());
            return Ok(Self { request, selection, only, own_inputs: String::new(), config_digest: None });
        };
        let Config { experiments, inputs, inputs_digest: own_inputs } = Config::read(file)?;
        let config_digest = Some(sha256(&fs::read(file)?));
        data::add_inputs(inputs)?;
        let only = experiments.iter().map(|experiment| experiment.id.to_owned()).collect();
        // Figures and claims are about the experiments of the catalog.
        let selection = Selection { experiments, figures: Vec::new(), claims: Vec::new() };
        Ok(Self { request, selection, only, own_inputs, config_digest })
    }

    pub(super) fn is_whole(&self) -> bool {
        self.only.is_empty()
    }

    /// The run of the plan on all processors, without files.
    pub(super) fn run_options(&self) -> RunOptions {
        RunOptions {
            profile: self.request.profile,
            seed: self.request.seed,
            threads: 0,
            directory: None,
            times: true,
            own_inputs: self.own_inputs.clone(),
            shard: None,
        }
    }

    /// The run as its shards name it: what has to be the same in all of them.
    pub(super) fn work(&self) -> Value {
        let Request { profile, seed, only, config } = &self.request;
        json!({
            "profile": profile.to_string(),
            "seed": seed,
            "only": only,
            "config": config.as_ref().map(|file| file.display().to_string()),
            "content of the config": self.config_digest,
            "own inputs": self.own_inputs,
        })
    }
}

impl Request {
    /// The request of a run that a shard names.
    pub(super) fn of_work(work: &Value) -> Option<Self> {
        let profile = match work["profile"].as_str()? {
            "quick" => Profile::Quick,
            "full" => Profile::Full,
            _ => return None,
        };
        let only = work["only"].as_array()?.iter().map(|id| Some(id.as_str()?.to_owned())).collect::<Option<_>>()?;
        let config = work["config"].as_str().map(PathBuf::from);
        Some(Self { profile, seed: work["seed"].as_u64()?, only, config })
    }
}
