//! A straight line through logarithms, or one bent by a lower-order term: ln y = ln c + a ln n + ln(1 + d n^(−decay)), d ≥ 0.
//!
//! Linear in ln c and a once d is fixed, so d runs over a grid of fifty values a factor of ten, zero included, with a regression at
//! each. The 95 % interval of a is its profile: all values that, with the best c and d for them, raise the residual sum of squares by at most the
//! factor 1 + t² / freedom, t the quantile of Student's distribution; at each d that sum is a parabola in a.

use super::regression::Regression;
use super::{Estimate, LowerOrder, t_quantile_975};

/// Steps of d in a factor of ten.
const STEPS: i32 = 50;

/// Powers of ten between which d lies, unless it is zero.
const POWERS: [i32; 2] = [-3, 6];

/// The best line, and the best level one.
pub(super) struct Curve {
    /// The slope a.
    pub slope: Estimate,
    /// ln c of the best line.
    pub intercept: f64,
    /// The residual sum of squares of the best line.
    pub residual_squares: f64,
    /// ln c and the residual sum of squares of the best curve with a = 0.
    pub level: [f64; 2],
}

impl Curve {
    /// At least four points (ln n, ln y) with at least three different n: the caller has counted them.
    pub fn new(points: &[(f64, f64)], lower_order: Option<LowerOrder>) -> Self {
        let straight = Straightened::new(points, |_| 1.0);
        let Some(LowerOrder { decay, .. }) = lower_order else {
            let Straightened { line, level, .. } = straight;
            return Self {
                slope: line.slope,
                intercept: line.intercept,
                residual_squares: line.residual_squares,
                level,
            };
        };
        let grid = (POWERS[0] * STEPS..=POWERS[1] * STEPS).map(|i| libm::exp10(f64::from(i) / f64::from(STEPS)));
        let bent = grid.map(|share| Straightened::new(points, |x| 1.0 + share * libm::exp(-decay * x)));
        let fits: Vec<Straightened> = std::iter::once(straight).chain(bent).collect();
        let best = least(&fits, |fit| fit.line.residual_squares);
        let level = least(&fits, |fit| fit.level[1]);
        let freedom = points.len() - 3;
        let quantile = t_quantile_975(freedom);
        let allowed = best.line.residual_squares * (1.0 + quantile * quantile / freedom as f64);
        let inside = fits.iter().filter(|fit| fit.line.residual_squares <= allowed).map(|fit| {
            let half_width = ((allowed - fit.line.residual_squares) / fit.spread).sqrt();
            [fit.line.slope.value - half_width, fit.line.slope.value + half_width]
        });
        let low = inside.clone().map(|ends| ends[0]).fold(f64::INFINITY, f64::min);
        let high = inside.map(|ends| ends[1]).fold(f64::NEG_INFINITY, f64::max);
        Self {
            slope: Estimate { value: best.line.slope.value, low, high },
            intercept: best.line.intercept,
            residual_squares: best.line.residual_squares,
            level: level.level,
        }
    }
}

/// The fit for one d.
struct Straightened {
    line: Regression,
    /// Σ (ln n − mean)².
    spread: f64,
    /// ln c and the residual sum of squares without a slope.
    level: [f64; 2],
}

impl Straightened {
    fn new(points: &[(f64, f64)], bend: impl Fn(f64) -> f64 + Copy) -> Self {
        let straight = points.iter().map(|&(x, y)| (x, y - libm::log(bend(x))));
        let count = points.len() as f64;
        let mean = |values: &mut dyn Iterator<Item = f64>| values.sum::<f64>() / count;
        let (mean_x, mean_y) = (mean(&mut straight.clone().map(|p| p.0)), mean(&mut straight.clone().map(|p| p.1)));
        let squares = |values: &mut dyn Iterator<Item = f64>| values.map(|v| v * v).sum::<f64>();
        Self {
            spread: squares(&mut straight.clone().map(|p| p.0 - mean_x)),
            level: [mean_y, squares(&mut straight.clone().map(|p| p.1 - mean_y))],
            line: Regression::new(straight),
        }
    }
}

fn least(fits: &[Straightened], size: impl Fn(&Straightened) -> f64) -> &Straightened {
    fits.iter().min_by(|a, b| size(a).total_cmp(&size(b))).expect("the grid is not empty")
}
