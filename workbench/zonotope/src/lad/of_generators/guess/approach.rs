//! A guess of the optimum by Newton steps for some thinner and thinner bands, without a bound of how near it is.

use super::huber_newton::{Step, solve};
use crate::lad::of_generators::plane::in_doubles::RoundedLines;

/// The least number of bands of an approach.
const APPROACH_BANDS: usize = 2;

/// A band that holds this part of the lines is followed by another: many lines nearly meet, and among them a descent
/// would begin far from the minimum.
const CROWDED_BAND: f64 = 0.25;

/// The most steps of an approach.
const APPROACH_STEP_LIMIT: usize = 12;

/// The mean square of the change of the lines' distances, in terms of the band, above which another step of an approach
/// is taken with the same band.
const STEADY_APPROACH: f64 = 0.5;

/// The least number of lines in the band of a step of an approach.
const THINNEST_APPROACH: f64 = 8.0;

/// The next band of an approach, in terms of the distance that the lines of this band leave the minimum uncertain by:
/// the band over the root of their number.
const BAND_OF_DEVIATIONS: f64 = 2.0;

/// The end of a few Newton steps.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Approach {
    pub(crate) point: [f64; 2],
    /// The distance within which the minimum is likely to be, in terms of the length of a generator.
    pub(crate) band: f64,
    /// The standard deviation of the distance of the minimum of all lines of which these are a sample.
    pub(crate) deviation: f64,
}

impl RoundedLines {
    /// A point near the minimum of linear · x + Σ |a x + b y + c|, without a bound of how near: Newton steps for some
    /// thinner and thinner bands, as many for each as it takes until the point is steady, from a point and a first
    /// band, if they are known. `None` where all lines are parallel.
    ///
    /// A descent from there crosses a few lines, and to cross a line among a hundred takes less than to make sure of
    /// a better guess.
    pub(crate) fn approach(&self, linear: [f64; 2], start: Option<([f64; 2], f64)>) -> Option<Approach> {
        let (mut point, mut band) = start.or_else(|| self.least_squares())?;
        let (mut deviation, mut thinned) = (band, 0);
        for _ in 0..APPROACH_STEP_LIMIT {
            let moments = self.moments(point, band);
            if moments.count < THINNEST_APPROACH {
                break;
            }
            let gradient = [moments.gradient[0] + linear[0], moments.gradient[1] + linear[1]];
            let Some(newton) = solve(&moments.hessian, gradient) else { break };
            let step = Step::new(point, newton, gradient);
            point = step.end();
            if step.change(&moments) > STEADY_APPROACH {
                continue;
            }
            deviation = band * (self.len() as f64 / 3.0).sqrt() / moments.count;
            band *= (BAND_OF_DEVIATIONS / moments.count.sqrt()).min(0.5);
            thinned += 1;
            if thinned >= APPROACH_BANDS && moments.count < CROWDED_BAND * self.len() as f64 {
                break;
            }
        }
        Some(Approach { point, band, deviation })
    }
}
