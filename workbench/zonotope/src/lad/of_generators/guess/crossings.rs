//! The crossings on a line that is searched, and the weighted median of their places.

use crate::numeric::reused::Reused;
use crate::numeric::weighted_median::weighted_median;

/// A crossing on a line that is searched: its place along the line, and the line that crosses there.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Crossing {
    pub(crate) place: f64,
    pub(crate) line: usize,
}

/// Crossings in the order of their lines, in columns.
#[derive(Debug)]
pub(crate) struct CrossingList {
    places: Reused<f64>,
    /// Half of what the slope gains at each.
    weights: Reused<f64>,
    lines: Reused<u32>,
}

impl CrossingList {
    pub(crate) fn with_capacity(capacity: usize) -> Self {
        Self {
            places: Reused::with_capacity(capacity),
            weights: Reused::with_capacity(capacity),
            lines: Reused::with_capacity(capacity),
        }
    }

    pub(crate) fn clear(&mut self) {
        self.places.clear();
        self.weights.clear();
        self.lines.clear();
    }

    pub(crate) fn len(&self) -> usize {
        self.places.len()
    }

    pub(crate) fn push(&mut self, place: f64, weight: f64, line: usize) {
        self.places.push(place);
        self.weights.push(weight);
        self.lines.push(line as u32);
    }

    /// Adds the crossing of a line with a normal, and returns its weight.
    #[inline(always)]
    pub(crate) fn add(&mut self, place: f64, [a, b]: [f64; 2], [dx, dy]: [f64; 2], line: usize) -> f64 {
        let weight = (a * dx + b * dy).abs();
        self.push(place, weight, line);
        weight
    }

    /// The first crossing, by place and then by line, at which the weights up to it and with it reach `target`; the
    /// last one if they never do.
    pub(crate) fn select(&self, target: f64) -> Option<Crossing> {
        let found = weighted_median(&self.places, &self.weights, target)?;
        Some(Crossing { place: self.places[found], line: self.lines[found] as usize })
    }
}
