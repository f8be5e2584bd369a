//! Growth of a measured quantity with the size: a power law with an interval, and a comparison with named models.
//!
//! # Statement
//! Input: samples (n, y) with n >= 2 and y > 0, at least [`FEWEST_SAMPLES`] independent ones on at least
//! [`FEWEST_SIZES`] sizes. Output: the exponent of the best power law y = c n^a with its 95 % interval; for every model
//! M the constant of y = c M(n), its residual sum of squares and AICc in log space, and the exponent of y / M(n)
//! against n with its 95 % interval.
//!
//! The verdict on a model is defined on that last interval [low, high] and the slack s = [`EXPONENT_SLACK`], as a test
//! of non-inferiority:
//! - within: high <= s, and not below;
//! - below: high < -s;
//! - above: low > s;
//! - undecided: low <= s < high, so that the samples tell neither that y grows like M at most nor that it grows faster.
//!
//! # Method
//! 1. Take natural logarithms: ln y = ln c + a ln n + error.
//! 2. Ordinary least squares for a and ln c over the independent samples. What is independent is counted for the
//!    interval: where all instances of a size are equal, they are one sample, and Student's t has (independent samples
//!    - 2) degrees of freedom.
//! 3. An F test compares the means of the sizes around the line with the instances around these means. Where it finds
//!    a lack of fit, the instances of a size share their error, and the means are what is independent: the variance is
//!    theirs, with (sizes - 2) degrees of freedom.
//! 4. For a model, ln c is the mean of ln(y / M(n)); the exponent of y / M(n) comes from steps 2 and 3 on those ratios.
//! 5. AICc of the independent samples, with two fitted parameters for a model (constant, variance) and three for the
//!    power law.
//!
//! # Numerics
//! Logarithms from `libm`, so that fits of operation counts agree bit for bit on every machine. Everything is rounded.
//!
//! # Checked by
//! Synthetic data of known growth, and regressions worked out by hand, in the tests.

mod estimate;
mod f_distribution;
mod model;
mod regression;
mod replicates;
mod student;
mod verdict;

pub use self::estimate::Estimate;
pub use f_distribution::f_upper_tail;
pub use model::GrowthModel;
pub use replicates::{LACK_OF_FIT_LEVEL, LackOfFit};
pub use student::t_quantile_975;
pub use verdict::{EXPONENT_SLACK, ModelVerdict};

use regression::Regression;
use replicates::{by_size, independent, independent_samples};
use serde::Serialize;

/// The second fit of every growth law is over this many doublings of the size, up to the largest.
pub const LAST_DOUBLINGS: i32 = 4;

/// The fit over the last doublings has at least this many sizes: all doublings, ends included.
pub const SIZES_OF_LAST_DOUBLINGS: usize = 5;

/// With fewer independent samples an interval says nothing.
pub const FEWEST_SAMPLES: usize = 4;

/// With fewer different sizes a trend is an accident.
pub const FEWEST_SIZES: usize = 3;

/// Residuals in log space below this are rounding: a floor under the mean square keeps AICc finite on exact data.
const LOG_RESOLUTION: f64 = 1e-12;

/// One model, fitted.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct ModelFit {
    /// The model M.
    pub model: GrowthModel,
    /// c of y = c M(n).
    pub constant: f64,
    /// Sum of squares of ln y - ln(c M(n)).
    pub residual_squares: f64,
    /// Akaike's criterion with the small-sample correction; smaller is better, differences count.
    pub aicc: f64,
    /// Exponent of y / M(n) against n.
    pub excess_exponent: Estimate,
    /// Whether y / M(n) bends away from a power of n.
    pub lack_of_fit: LackOfFit,
    /// The verdict of the excess exponent.
    pub verdict: ModelVerdict,
}

/// The growth of y with n.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Growth {
    /// Number of samples.
    pub samples: usize,
    /// Number of independent samples: where all instances of a size are equal, they count once.
    pub independent: usize,
    /// Number of sizes.
    pub sizes: usize,
    /// Smallest size.
    pub smallest: f64,
    /// Largest size.
    pub largest: f64,
    /// Exponent a of the power law y = c n^a.
    pub exponent: Estimate,
    /// c of the power law.
    pub constant: f64,
    /// Sum of squares of ln y - ln(c n^a).
    pub residual_squares: f64,
    /// Whether the samples bend away from the power law.
    pub lack_of_fit: LackOfFit,
    /// AICc of the power law.
    pub aicc: f64,
    /// The models, in the order asked for.
    pub models: Vec<ModelFit>,
}

impl Growth {
    /// The fit of `model`, when it was asked for.
    pub fn model(&self, model: GrowthModel) -> Option<&ModelFit> {
        self.models.iter().find(|fit| fit.model == model)
    }

    /// The model of smallest AICc; the power law does not compete, since it can imitate any of them over a short range.
    pub fn best(&self) -> Option<&ModelFit> {
        self.models.iter().min_by(|a, b| a.aicc.total_cmp(&b.aicc))
    }
}

/// Why samples cannot be fitted.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum FitError {
    /// Fewer independent samples or sizes than the fit needs.
    #[error("{samples} independent samples at {sizes} sizes: a fit needs {FEWEST_SAMPLES} at {FEWEST_SIZES}")]
    TooFew {
        /// Number of independent samples.
        samples: usize,
        /// Number of different sizes.
        sizes: usize,
    },
    /// A sample has no logarithm, or log n is not positive.
    #[error("sample {index} is ({n}, {y}): a fit needs finite n >= 2 and y > 0")]
    OutOfRange {
        /// Position in the input.
        index: usize,
        /// The size.
        n: f64,
        /// The measured quantity.
        y: f64,
    },
}

/// Fits a power law and every one of `models` to `samples` (n, y). See the module's documentation.
pub fn fit_growth(samples: &[(f64, f64)], models: &[GrowthModel]) -> Result<Growth, FitError> {
    let valid = |&(n, y): &(f64, f64)| n >= 2.0 && n.is_finite() && y > 0.0 && y.is_finite();
    if let Some(index) = samples.iter().position(|sample| !valid(sample)) {
        let (n, y) = samples[index];
        return Err(FitError::OutOfRange { index, n, y });
    }
    let sorted = by_size(samples);
    let groups = sorted.chunk_by(|a, b| a.0 == b.0);
    let (sizes, independent) = (groups.clone().count(), groups.map(independent).sum::<usize>());
    let (Some(&(smallest, _)), Some(&(largest, _)), true, true) =
        (sorted.first(), sorted.last(), independent >= FEWEST_SAMPLES, sizes >= FEWEST_SIZES)
    else {
        return Err(FitError::TooFew { samples: independent, sizes });
    };

    let distinct = independent_samples(&sorted);
    let logarithms: Vec<(f64, f64)> = distinct.iter().map(|&(n, y)| (libm::log(n), libm::log(y))).collect();
    let power = Regression::new(&logarithms);
    let models = models.iter().map(|&model| fit_model(&distinct, model)).collect();
    Ok(Growth {
        samples: samples.len(),
        independent: power.independent,
        sizes,
        smallest,
        largest,
        exponent: power.slope,
        constant: libm::exp(power.intercept),
        residual_squares: power.residual_squares,
        lack_of_fit: power.lack_of_fit,
        aicc: aicc(power.independent, power.residual_squares / distinct.len() as f64, 3),
        models,
    })
}

/// The samples, by increasing size, that are at most [`LAST_DOUBLINGS`] doublings smaller than the largest.
pub fn last_doublings(samples: &[(f64, f64)]) -> &[(f64, f64)] {
    let largest = samples.last().map_or(0.0, |&(n, _)| n);
    let smallest = libm::ldexp(largest, -LAST_DOUBLINGS);
    &samples[samples.partition_point(|&(n, _)| n < smallest)..]
}

fn fit_model(samples: &[(f64, f64)], model: GrowthModel) -> ModelFit {
    let ratios: Vec<(f64, f64)> =
        samples.iter().map(|&(n, y)| (libm::log(n), libm::log(y) - model.ln_value(n))).collect();
    let mean = ratios.iter().map(|r| r.1).sum::<f64>() / ratios.len() as f64;
    let residual_squares = ratios.iter().map(|r| (r.1 - mean) * (r.1 - mean)).sum::<f64>();
    let excess = Regression::new(&ratios);
    ModelFit {
        model,
        constant: libm::exp(mean),
        residual_squares,
        aicc: aicc(excess.independent, residual_squares / ratios.len() as f64, 2),
        excess_exponent: excess.slope,
        lack_of_fit: excess.lack_of_fit,
        verdict: ModelVerdict::of(excess.slope),
    }
}

/// A number with so many decimals; one that rounds to zero has no sign.
pub fn in_decimals(number: f64, decimals: usize) -> String {
    let text = format!("{number:.decimals$}");
    match text.strip_prefix('-') {
        Some(zero) if zero.bytes().all(|letter| matches!(letter, b'0' | b'.')) => zero.to_owned(),
        _ => text,
    }
}

/// `m` ln(mean square) + 2k + 2k(k + 1) / (m - k - 1); the last term is left out where its denominator is not positive.
fn aicc(independent: usize, mean_square: f64, parameters: usize) -> f64 {
    let (m, k) = (independent as f64, parameters as f64);
    let mean_square = mean_square.max(LOG_RESOLUTION * LOG_RESOLUTION);
    let correction = if m > k + 1.0 { 2.0 * k * (k + 1.0) / (m - k - 1.0) } else { 0.0 };
    m * libm::log(mean_square) + 2.0 * k + correction
}

#[cfg(test)]
mod tests;
