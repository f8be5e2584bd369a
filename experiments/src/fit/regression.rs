//! A straight line through points, by ordinary least squares, with the 95 % interval of its slope.

use super::replicates::{LackOfFit, Spread};
use super::{Estimate, t_quantile_975};

/// y = intercept + slope x.
pub(super) struct Regression {
    pub slope: Estimate,
    pub intercept: f64,
    pub residual_squares: f64,
    /// The number of independent points.
    pub independent: usize,
    pub lack_of_fit: LackOfFit,
}

impl Regression {
    /// At least three points with different x: the caller has counted them.
    ///
    /// The variance behind the interval is that of the residuals, with (independent points - 2) degrees of freedom.
    /// With a lack of fit that the test finds, points of one x share most of their residual; then it is that of the
    /// means, with (different x - 2) degrees of freedom.
    pub fn new(points: &[(f64, f64)]) -> Self {
        let m = points.len() as f64;
        let mean_x = points.iter().map(|p| p.0).sum::<f64>() / m;
        let mean_y = points.iter().map(|p| p.1).sum::<f64>() / m;
        let sum = |term: fn(f64, f64) -> f64| points.iter().map(|(x, y)| term(x - mean_x, y - mean_y)).sum::<f64>();
        let spread_of_x = sum(|x, _| x * x);
        let slope = sum(|x, y| x * y) / spread_of_x;
        let intercept = mean_y - slope * mean_x;
        let spread = Spread::of(points, |x| mean_y + slope * (x - mean_x));
        let lack_of_fit = spread.test();
        let residual_squares = spread.pure_error + spread.lack_of_fit;
        let (squares, freedom) = if lack_of_fit.is_detected() {
            (spread.lack_of_fit, spread.sizes - 2)
        } else {
            (residual_squares, spread.independent - 2)
        };
        let standard_error = (squares / freedom as f64 / spread_of_x).sqrt();
        let half_width = t_quantile_975(freedom) * standard_error;
        let slope = Estimate { value: slope, low: slope - half_width, high: slope + half_width };
        Self { slope, intercept, residual_squares, independent: spread.independent, lack_of_fit }
    }
}
