//! A straight line through points, by ordinary least squares, with the 95 % interval of its slope.

use super::{Estimate, t_quantile_975};

/// y = intercept + slope x.
pub(super) struct Regression {
    pub slope: Estimate,
    pub intercept: f64,
    pub residual_squares: f64,
}

impl Regression {
    /// At least three points with at least two different x: the caller has counted them.
    pub fn new(points: impl Iterator<Item = (f64, f64)> + Clone) -> Self {
        let count = points.clone().count();
        let m = count as f64;
        let mean_x = points.clone().map(|p| p.0).sum::<f64>() / m;
        let mean_y = points.clone().map(|p| p.1).sum::<f64>() / m;
        let sum = |term: fn(f64, f64) -> f64| points.clone().map(|(x, y)| term(x - mean_x, y - mean_y)).sum::<f64>();
        let spread = sum(|x, _| x * x);
        let slope = sum(|x, y| x * y) / spread;
        let intercept = mean_y - slope * mean_x;
        let residual_squares = points
            .clone()
            .map(|(x, y)| {
                let residual = (y - mean_y) - slope * (x - mean_x);
                residual * residual
            })
            .sum::<f64>();
        let freedom = count - 2;
        let standard_error = (residual_squares / freedom as f64 / spread).sqrt();
        let half_width = t_quantile_975(freedom) * standard_error;
        let slope = Estimate { value: slope, low: slope - half_width, high: slope + half_width };
        Self { slope, intercept, residual_squares }
    }
}
