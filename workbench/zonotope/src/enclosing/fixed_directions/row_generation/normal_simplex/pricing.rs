//! Pricing: which variable enters the basis, and which leaves it.

use super::{Basic, NormalProgram};
use crate::numeric::lanes::product_in_fours;

/// The number of variables with the largest gains that are priced again and again before all variables are.
const CANDIDATE_COUNT: usize = 24;

impl<const D: usize> NormalProgram<D> {
    /// The reduced gain of a variable; `None` if it is not positive or may be rounding.
    pub(super) fn reduced_gain(&self, basic: Basic) -> Option<f64> {
        let (gain, rounding) = match basic {
            Basic::Slack(i) => {
                let price = self.prices[self.rank + i];
                (-price, 0.1 * self.precision)
            }
            Basic::Normal(j) => {
                let entries = &self.entries[j];
                let gain = self.rows[j].height - product_in_fours(entries, &self.prices);
                if gain <= 0.01 * self.precision {
                    return None;
                }
                let size = entries.iter().zip(&self.prices).map(|(e, p)| (e * p).abs()).sum::<f64>();
                (gain, self.precision * (size + 0.01))
            }
        };
        (gain > rounding).then_some(gain)
    }

    /// Whether a variable is in the basis.
    pub(super) fn is_basic(&self, basic: Basic) -> bool {
        match basic {
            Basic::Normal(j) => self.normal_is_basic[j],
            Basic::Slack(i) => self.slack_is_basic[i],
        }
    }

    /// The candidate with the largest reduced gain, and the gain; `None` if no candidate has one.
    pub(super) fn best_of(&self, candidates: &[Basic]) -> Option<(Basic, f64)> {
        let gains = candidates.iter().filter(|b| !self.is_basic(**b)).filter_map(|&b| Some((b, self.reduced_gain(b)?)));
        gains.max_by(|a, b| a.1.total_cmp(&b.1))
    }

    /// The variables with the largest reduced gains of all, [`CANDIDATE_COUNT`] at most.
    pub(super) fn promising(&self) -> Vec<Basic> {
        let all = (0..self.rows.len()).map(Basic::Normal).chain((0..self.directions.len()).map(Basic::Slack));
        let mut gains: Vec<(Basic, f64)> =
            all.filter(|b| !self.is_basic(*b)).filter_map(|b| Some((b, self.reduced_gain(b)?))).collect();
        gains.sort_by(|a, b| b.1.total_cmp(&a.1));
        gains.truncate(CANDIDATE_COUNT);
        gains.into_iter().map(|(b, _)| b).collect()
    }

    /// The column of a variable, multiplied by the inverse of the basis.
    pub(super) fn column(&self, entering: Basic) -> Vec<f64> {
        match entering {
            Basic::Slack(i) => self.inverse.iter().map(|row| row[self.rank + i]).collect(),
            Basic::Normal(j) => self.inverse.iter().map(|row| product_in_fours(row, &self.entries[j])).collect(),
        }
    }

    /// The row of the variable that leaves the basis, by a ratio test in two passes: of the rows whose values reach
    /// zero first but for rounding, the one with the largest pivot. `None` if no value falls.
    pub(super) fn leaving(&self, column: &[f64]) -> Option<usize> {
        let largest = column.iter().fold(0.0, |max: f64, v| max.max(v.abs()));
        let scale = self.values.iter().fold(0.0, |max: f64, v| max.max(v.abs()));
        let rising = || (0..column.len()).filter(|&i| column[i] > 1e-10 * largest);
        let bound =
            rising().map(|i| (self.values[i].max(0.0) + 1e-13 * scale) / column[i]).fold(f64::INFINITY, f64::min);
        rising()
            .filter(|&i| self.values[i].max(0.0) / column[i] <= bound)
            .max_by(|&a, &b| column[a].total_cmp(&column[b]))
    }
}
