//! The distance by which a straight line misses the means of the sizes, beside how far the instances of a size differ.
//!
//! Instances of one size differ by chance alone (pure error); the means of the sizes miss the line by chance and by the
//! bend of the true law (lack of fit). If there is no bend, both mean squares estimate the same variance, and their
//! ratio has the F distribution.

use super::f_distribution::f_upper_tail;
use serde::Serialize;

/// A probability below this says that the line misses the means by more than chance.
pub const LACK_OF_FIT_LEVEL: f64 = 0.05;

/// Whether a law bends away from the samples.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum LackOfFit {
    /// The instances of no size differ, so that nothing tells a bend from chance.
    NoReplicates,
    /// The F test.
    Tested {
        /// The mean square of the lack of fit over that of the pure error.
        ratio: f64,
        /// The degrees of freedom of both.
        freedom: [usize; 2],
        /// The probability of such a ratio or a larger one where there is no bend.
        probability: f64,
    },
}

impl LackOfFit {
    /// Whether the test finds a bend.
    pub fn is_detected(self) -> bool {
        matches!(self, Self::Tested { probability, .. } if probability < LACK_OF_FIT_LEVEL)
    }
}

/// The samples by increasing size, and within a size in their order.
pub(super) fn by_size(samples: &[(f64, f64)]) -> Vec<(f64, f64)> {
    let mut sorted = samples.to_vec();
    sorted.sort_by(|a, b| a.0.total_cmp(&b.0));
    sorted
}

/// The number of samples of one size that are independent: all of them, but only one where all are equal. Then the
/// method does the same on every instance, and whoever has seen one has seen them all; where some differ, chance is at
/// work, and others that are equal are draws of their own.
pub(super) fn independent(group: &[(f64, f64)]) -> usize {
    if group.iter().all(|sample| sample.1 == group[0].1) { 1 } else { group.len() }
}

/// The samples, sorted by size, of which the equal instances of a size are taken once.
pub(super) fn independent_samples(sorted: &[(f64, f64)]) -> Vec<(f64, f64)> {
    sorted.chunk_by(|a, b| a.0 == b.0).flat_map(|group| &group[..independent(group)]).copied().collect()
}

/// Sums of squares around a line, and how many samples are behind them.
pub(super) struct Spread {
    /// The number of independent samples, by [`independent`].
    pub independent: usize,
    /// The number of sizes.
    pub sizes: usize,
    /// Squares of the samples around the means of their sizes.
    pub pure_error: f64,
    /// Squares of the means of the sizes around the line, a square for each sample.
    pub lack_of_fit: f64,
}

impl Spread {
    /// The spread of points (x, y) around y = `line`(x).
    pub fn of(points: &[(f64, f64)], line: impl Fn(f64) -> f64) -> Self {
        let mut spread = Self { independent: 0, sizes: 0, pure_error: 0.0, lack_of_fit: 0.0 };
        for group in by_size(points).chunk_by(|a, b| a.0 == b.0) {
            let independent = independent(group);
            let count = group.len() as f64;
            let mean = group.iter().map(|p| p.1).sum::<f64>() / count;
            let miss = mean - line(group[0].0);
            spread.independent += independent;
            spread.sizes += 1;
            spread.lack_of_fit += count * miss * miss;
            if independent > 1 {
                spread.pure_error += group.iter().map(|p| (p.1 - mean) * (p.1 - mean)).sum::<f64>();
            }
        }
        spread
    }

    /// The test, for at least three sizes.
    pub fn test(&self) -> LackOfFit {
        let freedom = [self.sizes - 2, self.independent - self.sizes];
        let [between, within] = freedom.map(|freedom| freedom as f64);
        if freedom[1] == 0 || self.pure_error == 0.0 {
            return LackOfFit::NoReplicates;
        }
        let ratio = self.lack_of_fit / between / (self.pure_error / within);
        LackOfFit::Tested { ratio, freedom, probability: f_upper_tail(ratio, freedom) }
    }
}
