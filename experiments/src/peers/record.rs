//! The record of a race: its cells, entries and line fits.

use crate::environment::Environment;
use serde::{Deserialize, Serialize};

/// A run of every contender.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct PeersRecord {
    /// The machine and the programs with which it was made.
    pub environment: Option<Environment>,
    /// The seed of the questions.
    pub seed: u64,
    /// One entry a family, placement and size.
    pub cells: Vec<Cell>,
    /// The L1 line fit against `palb`.
    pub line_fits: Vec<LineFit>,
}

/// The questions of one family, placement and size.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Cell {
    /// The family of bodies.
    pub family: String,
    /// The place of the questions' points.
    pub placement: String,
    /// The number of generators.
    pub n: usize,
    /// The number of questions that could be made.
    pub questions: u32,
    /// The results of each contender on them.
    pub entries: Vec<Entry>,
}

/// One contender on the questions of a cell.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Entry {
    /// The contender.
    pub method: String,
    /// Questions that it took.
    pub asked: u32,
    /// Answers that are not the truth.
    pub wrong: u32,
    /// Questions without an answer.
    pub failed: u32,
    /// Raw samples in nanoseconds, a list a question.
    pub samples_ns: Vec<Vec<f64>>,
}

/// The L1 line fit by `palb` and by the kernel, on the same points.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct LineFit {
    /// The number of points.
    pub n: usize,
    /// Raw times of `palb`.
    pub palb_ns: Vec<f64>,
    /// Raw times of the kernel.
    pub ours_ns: Vec<f64>,
    /// Raw times of one pass: the sum of absolute residuals over the rows of the points.
    pub pass_ns: Vec<f64>,
    /// The sum of absolute residuals of the line that `palb` found.
    pub palb_residual: f64,
    /// That of the kernel's line.
    pub ours_residual: f64,
}

impl Entry {
    /// An entry without answers.
    pub fn new(method: &str) -> Self {
        Self { method: method.to_owned(), asked: 0, wrong: 0, failed: 0, samples_ns: Vec::new() }
    }
}

impl Cell {
    /// Whether another cell has the same family, placement and size.
    pub fn is_about_the_same(&self, other: &Self) -> bool {
        (&self.family, &self.placement, self.n) == (&other.family, &other.placement, other.n)
    }

    /// The entry of a contender.
    pub fn entry(&self, method: &str) -> Option<&Entry> {
        self.entries.iter().find(|entry| entry.method == method)
    }

    /// A contender's times in nanoseconds, question by question: medians of the samples.
    pub fn times(&self, method: &str) -> Vec<f64> {
        self.entry(method).map_or_else(Vec::new, |entry| entry.samples_ns.iter().filter_map(|s| median(s)).collect())
    }

    /// A contender's time divided by that of `unit`, question by question: medians of the samples.
    pub fn ratios(&self, method: &str, unit: &str) -> Vec<f64> {
        let (Some(entry), Some(unit)) = (self.entry(method), self.entry(unit)) else { return Vec::new() };
        let pairs = entry.samples_ns.iter().zip(&unit.samples_ns);
        pairs.filter_map(|(samples, unit)| Some(median(samples)? / median(unit)?)).collect()
    }
}

/// The committed record.
///
/// # Errors
/// When the file does not read as a record.
pub fn committed() -> Result<PeersRecord, serde_json::Error> {
    serde_json::from_str(include_str!("../../data/peers.json"))
}

/// The middle value, or the mean of the two middle ones.
pub fn median(values: &[f64]) -> Option<f64> {
    let mut sorted = values.to_vec();
    sorted.sort_by(f64::total_cmp);
    let (below, above) = (sorted.len().checked_sub(1)? / 2, sorted.len() / 2);
    Some(f64::midpoint(sorted[below], sorted[above]))
}
