//! Growth of a measured quantity with the size: a power law with an interval, and a comparison with named models.
//!
//! # Statement
//! Input: samples (n, y) with n >= 2 and y > 0, at least [`FEWEST_SAMPLES`] of them on at least [`FEWEST_SIZES`]
//! different sizes. Output: the exponent of the best power law y = c n^a with its 95 % interval; for every model M the
//! constant of y = c M(n), its residual sum of squares and AICc in log space, and the exponent of y / M(n) against n
//! with its 95 % interval.
//!
//! The verdict on a model is defined on that last interval [low, high]:
//! - within: it meets [-[`EXPONENT_SLACK`], [`EXPONENT_SLACK`]];
//! - below: it lies below (y grows less than M, so y = O(M) is not contradicted);
//! - above: it lies above.
//!
//! # Method
//! 1. Take natural logarithms: ln y = ln c + a ln n + error.
//! 2. Ordinary least squares for a and ln c; the interval uses Student's t with (samples - 2) degrees of freedom.
//! 3. For a model, ln c is the mean of ln(y / M(n)); the exponent of y / M(n) comes from step 2 on those ratios.
//! 4. AICc with two fitted parameters for a model (constant, variance) and three for the power law.
//!
//! # Numerics
//! Logarithms from `libm`, so that fits of operation counts agree bit for bit on every machine. Everything is rounded.
//!
//! # Checked by
//! Synthetic data of known growth, and a regression worked out by hand, in the tests.

mod model;
mod regression;
mod student;

pub use model::GrowthModel;
pub use student::t_quantile_975;

use regression::Regression;
use serde::Serialize;

/// How far from zero an exponent of y / M(n) may be for lower-order terms alone.
///
/// Counts are nearly free of noise, so an interval can be so narrow that a lower-order term keeps it off zero: 3n + 5
/// log n is no pure 3n at any size. The slack must tell neighbouring models apart: a factor log n has a local exponent
/// of 1 / ln n, that is 0.11 at 2^13, the geometric middle of 2^6 .. 2^20, and 0.14 at 2^10. Less than half of the
/// smaller one is 0.05.
pub const EXPONENT_SLACK: f64 = 0.05;

/// The second fit of every growth law is over this many doublings of the size, up to the largest.
pub const LAST_DOUBLINGS: i32 = 4;

/// With fewer samples an interval says nothing.
pub const FEWEST_SAMPLES: usize = 4;

/// With fewer different sizes a trend is an accident.
pub const FEWEST_SIZES: usize = 3;

/// Residuals in log space below this are rounding: a floor under the mean square keeps AICc finite on exact data.
const LOG_RESOLUTION: f64 = 1e-12;

/// A number with its 95 % confidence interval.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Estimate {
    /// Least-squares value.
    pub value: f64,
    /// Lower end of the interval.
    pub low: f64,
    /// Upper end of the interval.
    pub high: f64,
}

/// What the samples say about one model; defined in the module's statement.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum ModelVerdict {
    /// The exponent beyond the model has an interval that meets the slack around zero.
    Within,
    /// The exponent of the samples is below the model's.
    Below,
    /// The exponent of the samples is above the model's.
    Above,
}

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
    /// What the excess exponent says.
    pub verdict: ModelVerdict,
}

/// The growth of y with n.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Growth {
    /// Number of samples.
    pub samples: usize,
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
    /// Fewer samples or sizes than the fit needs.
    #[error("{samples} samples at {sizes} sizes: a fit needs {FEWEST_SAMPLES} at {FEWEST_SIZES}")]
    TooFew {
        /// Number of samples.
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
    let mut sizes: Vec<f64> = samples.iter().map(|&(n, _)| n).collect();
    sizes.sort_by(f64::total_cmp);
    let (smallest, largest) = (sizes.first().copied(), sizes.last().copied());
    sizes.dedup();
    let (Some(smallest), Some(largest), true, true) =
        (smallest, largest, samples.len() >= FEWEST_SAMPLES, sizes.len() >= FEWEST_SIZES)
    else {
        return Err(FitError::TooFew { samples: samples.len(), sizes: sizes.len() });
    };

    let power = Regression::new(samples.iter().map(|&(n, y)| (libm::log(n), libm::log(y))));
    let models = models.iter().map(|&model| fit_model(samples, model)).collect();
    Ok(Growth {
        samples: samples.len(),
        smallest,
        largest,
        exponent: power.slope,
        constant: libm::exp(power.intercept),
        residual_squares: power.residual_squares,
        aicc: aicc(samples.len(), power.residual_squares, 3),
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
    let residual_squares = ratios.iter().map(|r| (r.1 - mean) * (r.1 - mean)).sum();
    let excess_exponent = Regression::new(ratios.iter().copied()).slope;
    ModelFit {
        model,
        constant: libm::exp(mean),
        residual_squares,
        aicc: aicc(samples.len(), residual_squares, 2),
        excess_exponent,
        verdict: verdict(excess_exponent),
    }
}

fn verdict(excess: Estimate) -> ModelVerdict {
    if excess.high < -EXPONENT_SLACK {
        ModelVerdict::Below
    } else if excess.low > EXPONENT_SLACK {
        ModelVerdict::Above
    } else {
        ModelVerdict::Within
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

/// `m` ln(RSS / m) + 2k + 2k(k + 1) / (m - k - 1); the last term is left out where its denominator is not positive.
fn aicc(samples: usize, residual_squares: f64, parameters: usize) -> f64 {
    let (m, k) = (samples as f64, parameters as f64);
    let mean_square = (residual_squares / m).max(LOG_RESOLUTION * LOG_RESOLUTION);
    let correction = if m > k + 1.0 { 2.0 * k * (k + 1.0) / (m - k - 1.0) } else { 0.0 };
    m * libm::log(mean_square) + 2.0 * k + correction
}

#[cfg(test)]
mod tests;
