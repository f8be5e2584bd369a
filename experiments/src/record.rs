//! Rows of the two record files. `counts.jsonl` is the same on every run and machine; `times.jsonl` is not.

use crate::definition::{Case, Measurement, Verdict};
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// The part of every row about its case.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct CaseKey {
    /// Unique id of the case.
    pub case: String,
    /// Id of the experiment.
    pub experiment: String,
    /// Family or real input.
    pub family: String,
    /// Variant, usually a method.
    pub variant: String,
    /// Size.
    pub n: usize,
    /// Instance.
    pub instance: u32,
    /// Seed of the instance, in hexadecimal (64 bits do not fit a number of every JSON reader).
    pub instance_seed: String,
    /// Seed of the method.
    pub seed: String,
}

impl From<&Case> for CaseKey {
    fn from(case: &Case) -> Self {
        Self {
            case: case.id(),
            experiment: case.experiment.to_owned(),
            family: case.family.to_owned(),
            variant: case.variant.to_owned(),
            n: case.n,
            instance: case.instance,
            instance_seed: format!("{:016x}", case.instance_seed),
            seed: format!("{:016x}", case.seed),
        }
    }
}

/// A row of `counts.jsonl`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct CountRow {
    /// The case.
    #[serde(flatten)]
    pub key: CaseKey,
    /// The outcome.
    #[serde(flatten)]
    pub outcome: CountOutcome,
}

/// The outcome of counting a case.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum CountOutcome {
    /// It ran to the end; the answer may be wrong.
    Measured {
        /// Operation counts by name.
        counts: BTreeMap<String, u64>,
        /// Other numbers by name.
        values: BTreeMap<String, f64>,
        /// Hash of the answer, in hexadecimal.
        digest: String,
        /// Whether the answer is right.
        verdict: Verdict,
    },
    /// It returned an error or panicked.
    Failed {
        /// The message.
        error: String,
    },
}

impl CountRow {
    /// The row of a case. A value that is not finite turns into a failure, since JSON has no word for it.
    pub fn new(case: &Case, result: Result<Measurement, String>) -> Self {
        let outcome = result.and_then(all_finite).map_or_else(
            |error| CountOutcome::Failed { error },
            |measurement| CountOutcome::Measured {
                counts: measurement.counts,
                values: measurement.values,
                digest: format!("{:016x}", measurement.digest),
                verdict: measurement.verdict,
            },
        );
        Self { key: case.into(), outcome }
    }

    /// The operation count called `name`.
    pub fn count(&self, name: &str) -> Option<u64> {
        match &self.outcome {
            CountOutcome::Measured { counts, .. } => counts.get(name).copied(),
            CountOutcome::Failed { .. } => None,
        }
    }

    /// The sum of all operation counts.
    pub fn all_counts(&self) -> Option<u64> {
        match &self.outcome {
            CountOutcome::Measured { counts, .. } => Some(counts.values().sum()),
            CountOutcome::Failed { .. } => None,
        }
    }

    /// The value called `name`.
    pub fn value(&self, name: &str) -> Option<f64> {
        match &self.outcome {
            CountOutcome::Measured { values, .. } => values.get(name).copied(),
            CountOutcome::Failed { .. } => None,
        }
    }

    /// Whether there is no answer: the instance could not be made, or the method ended with an error.
    pub fn has_failed(&self) -> bool {
        matches!(self.outcome, CountOutcome::Failed { .. })
    }

    /// Why the row is no evidence: the error, or what is wrong with the answer.
    pub fn fault(&self) -> Option<&str> {
        match &self.outcome {
            CountOutcome::Failed { error } => Some(error),
            CountOutcome::Measured { verdict: Verdict::Wrong(reason), .. } => Some(reason),
            CountOutcome::Measured { .. } => None,
        }
    }
}

fn all_finite(measurement: Measurement) -> Result<Measurement, String> {
    match measurement.values.iter().find(|(_, value)| !value.is_finite()) {
        Some((name, value)) => Err(format!("the value {name} is {value}")),
        None => Ok(measurement),
    }
}

/// A row of `times.jsonl`: one repetition of one case.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct TimeRow {
    /// The case.
    #[serde(flatten)]
    pub key: CaseKey,
    /// 0, 1, …; the unrecorded first run has no row.
    pub repetition: u32,
    /// Id of the environment, as in `environment.json`.
    pub environment: String,
    /// The outcome.
    #[serde(flatten)]
    pub outcome: TimeOutcome,
}

/// The outcome of timing a repetition.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum TimeOutcome {
    /// The answer is that of the counted run, and not wrong.
    Valid {
        /// Laps by name, in nanoseconds.
        laps_ns: BTreeMap<String, u64>,
    },
    /// The time is no evidence; it is kept to be seen.
    Void {
        /// Laps by name, in nanoseconds.
        laps_ns: BTreeMap<String, u64>,
        /// Why.
        reason: String,
    },
    /// The run returned an error or panicked.
    Failed {
        /// The message.
        error: String,
    },
}

impl TimeRow {
    /// The lap called `name`, when the time is evidence.
    pub fn lap_ns(&self, name: &str) -> Option<u64> {
        match &self.outcome {
            TimeOutcome::Valid { laps_ns } => laps_ns.get(name).copied(),
            TimeOutcome::Void { .. } | TimeOutcome::Failed { .. } => None,
        }
    }
}
