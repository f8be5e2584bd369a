//! The line y ≈ slope · x + intercept of least absolute deviations through weighted points, by the kernel.
//!
//! # Statement
//! Input: points (x_i, y_i) with weights w_i ≥ 0. Output: an exact minimiser of Σ w_i |slope · x_i + intercept − y_i|
//! with its proof. When the best line is not unique it is a vertex of the set of best lines, one through two points. If
//! all points of positive weight have the same x, any line through their weighted median is best: the answer is the one
//! whose (slope, intercept) is nearest to the origin, and so for one point. Without points of positive weight it is
//! y = 0.
//!
//! # Source
//! Beyond the paper: the points are generators (x, y, w) of a zonotope, and the fit is the kernel's problem for them.
//!
//! # Method
//! 1. In the plane of (slope, intercept) each point is the line x_i · slope + intercept − y_i = 0 with the weight w_i:
//!    minimise by [`by_pruning`].
//! 2. Before that, one pass for the bounds of the points, and a frame around the middle of a few of them in which
//!    coordinates are about 1 in magnitude (`point_frame`). The lines are made in that frame as a pass reads them,
//!    eight at a time (`point_lines`): nothing of the size of the points is stored but a sign for each.
//!
//! The fit is also the facet in which a ray leaves the zonotope of the generators (x_i, y_i, w_i), which the kernel in
//! homogeneous form finds. The frame is why that form is not taken: generators of points far from the origin, of sizes
//! far from 1 or in clusters are nearly parallel or long and short, which costs it digits or readings.
//!
//! # Complexity
//! n points: expected O(n), about two passes over the points and sublinear work beside them; space one byte a point and
//! some n^(2/3) lines. Where many points lie on the best line, further passes, and exact sums over the points. The
//! [proof](LineFit::proof) with its O(n) coefficients is made when it is asked for.
//!
//! # Shapes
//! `points`: n × 3, the rows (x, y, weight) in any order, duplicates allowed; weight 1 throughout for a fit without
//! weights.
//!
//! # Numerics
//! The line is the exact optimum, with rational slope and intercept; [`LineFit::rounded`] rounds them. Which of several
//! best lines it is depends on the frame.
//!
//! # Errors
//! [`LineFitError::NonFinite`] ⇔ a coordinate or a weight is NaN or infinite; [`LineFitError::NegativeWeight`] ⇔ a
//! weight is below zero; [`LineFitError::TooMany`] ⇔ 2^32 points or more.
//!
//! # Checked by
//! The kernel's brute force, and the crate `verifier` on every answer.
//!
//! # Example
//! ```
//! use zonotope::line_fit::fit;
//! // three points on y = 2 x + 1 and one far off: least absolute deviations ignore it
//! let points = [[0.0, 1.0, 1.0], [1.0, 3.0, 1.0], [2.0, 5.0, 1.0], [1.5, 40.0, 1.0]];
//! let fit = fit(&points).unwrap();
//! assert_eq!(fit.rounded(), [2.0, 1.0]);
//! assert_eq!(fit.deviation(), 36.into());
//! ```

mod point_frame;
mod point_lines;

use thiserror::Error;

use point_frame::{Bounds, PointFrame};
use point_lines::PointLines;

use crate::arrangement::ExactLine;
use crate::lad::{LadError, LadOptimum, LadProblem, Minimizer, WeightedLine, by_pruning};
use crate::numeric::Rational;
use crate::numeric::dyadic::Dyadic;
use crate::numeric::non_finite::NonFinite;
use crate::seed::DEFAULT_SEED;
use crate::tally::Tally;

/// Why points are refused.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
#[non_exhaustive]
pub enum LineFitError {
    /// A coordinate or a weight is NaN or infinite.
    #[error(transparent)]
    NonFinite(#[from] NonFinite),
    /// A weight is below zero.
    #[error("point {point}: the weight {weight} is negative")]
    NegativeWeight {
        /// The point.
        point: usize,
        /// The weight.
        weight: f64,
    },
    /// There are more points than a 32-bit index can name.
    #[error("{count} points are more than the {} that an index can name", u32::MAX)]
    TooMany {
        /// How many points there are.
        count: usize,
    },
}

/// The best line.
#[derive(Debug)]
pub struct LineFit<'p> {
    points: &'p [[f64; 3]],
    minimizer: Minimizer,
}

/// The proof of a best line.
#[derive(Debug)]
pub struct LineFitProof {
    /// The kernel's problem: the point with index i is its line i.
    pub problem: LadProblem<'static>,
    /// Its optimum, with coefficients of the points.
    pub optimum: LadOptimum,
}

/// The line of least absolute deviations.
///
/// # Errors
/// [`LineFitError`] names the first point that is no point.
pub fn fit(points: &[[f64; 3]]) -> Result<LineFit<'_>, LineFitError> {
    fit_counted(points, &mut ())
}

/// [`fit`], counting its operations.
///
/// # Errors
/// Those of [`fit`].
pub fn fit_counted<'p>(points: &'p [[f64; 3]], tally: &mut impl Tally) -> Result<LineFit<'p>, LineFitError> {
    let Some(bounds) = Bounds::of(points).filter(|_| u32::try_from(points.len()).is_ok()) else {
        check(points)?;
        return Ok(LineFit { points, minimizer: Minimizer::Plane });
    };
    let lines = PointLines { points, frame: PointFrame::new(points, &bounds) };
    let problem = LadProblem::from_made_lines(Box::new(lines), Box::new(lines));
    Ok(LineFit { points, minimizer: by_pruning::minimizer(&problem, DEFAULT_SEED, tally) })
}

/// Refuses the first point that is no point.
fn check(points: &[[f64; 3]]) -> Result<(), LineFitError> {
    for (point, &[x, y, weight]) in points.iter().enumerate() {
        NonFinite::check_fields("point", point, &[("x", x), ("y", y), ("the weight", weight)])?;
    }
    match points.iter().position(|point| point[2] < 0.0) {
        Some(point) => Err(LineFitError::NegativeWeight { point, weight: points[point][2] }),
        None if u32::try_from(points.len()).is_err() => Err(LineFitError::TooMany { count: points.len() }),
        None => Ok(()),
    }
}

fn problem_of(points: &[[f64; 3]]) -> Result<LadProblem<'static>, LineFitError> {
    check(points)?;
    let line = |&[x, y, weight]: &[f64; 3]| WeightedLine { normal: [x, 1.0], offset: -y, weight };
    let lines: Vec<WeightedLine> = points.iter().map(line).collect();
    LadProblem::new(&lines, [0.0, 0.0]).map_err(LineFitError::of)
}

impl LineFitError {
    /// The kernel's refusal of the lines of points, in terms of the points.
    fn of(error: LadError) -> Self {
        match error {
            LadError::NonFinite(number) => Self::NonFinite(number),
            LadError::NegativeWeight { line, weight } => Self::NegativeWeight { point: line, weight },
            LadError::TooMany { count } => Self::TooMany { count },
        }
    }
}

impl LineFit<'_> {
    /// Slope and intercept, exactly.
    pub fn exact(&self) -> [Rational; 2] {
        let [x, y, w] = self.homogeneous().map(|v| v.to_rational());
        [x / &w, y / w]
    }

    /// Slope and intercept, each within a relative 2^-50.
    pub fn rounded(&self) -> [f64; 2] {
        let [x, y, w] = self.homogeneous();
        [x.ratio(&w), y.ratio(&w)]
    }

    /// Σ w_i |slope · x_i + intercept − y_i|, exactly. O(n) exact operations.
    pub fn deviation(&self) -> Rational {
        let point = self.homogeneous();
        let deviations = self.points.iter().map(|p| line_of(p).evaluate(&point).abs() * Dyadic::from_f64(p[2]));
        let total = deviations.fold(Dyadic::zero(), |sum, deviation| sum + deviation);
        total.to_rational() / point[2].to_rational()
    }

    /// The proof that no line is better; where several are as good, its own may be another one. Expected O(n).
    pub fn proof(&self) -> LineFitProof {
        let problem = problem_of(self.points).expect("the points were validated when the line was fitted");
        let outcome = by_pruning::minimize(&problem, DEFAULT_SEED, &mut ());
        let optimum = outcome.into_optimum().expect("a sum of absolute values is bounded below");
        LineFitProof { problem, optimum }
    }

    fn homogeneous(&self) -> [Dyadic; 3] {
        self.minimizer.homogeneous_point(|line| line_of(&self.points[line.position()]))
    }
}

/// The lines through a point, as a line of the plane of (slope, intercept).
fn line_of(&[x, y, _]: &[f64; 3]) -> ExactLine {
    let [x, one, y] = [x, 1.0, -y].map(Dyadic::from_f64);
    ExactLine { normal: [x, one], offset: y }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::interop::verifier::check_lad;
    use crate::lad::{LadOutcome, brute_force};
    use crate::numeric::lanes::level::at_each_level;
    use proptest::prelude::*;
    use rand::{RngExt, SeedableRng};
    use rand_pcg::Pcg64Mcg;

    fn points() -> impl Strategy<Value = Vec<[f64; 3]>> {
        (any::<bool>(), any_points()).prop_map(|(equal, mut points)| {
            points.iter_mut().filter(|_| equal).for_each(|point| point[2] = 0.5);
            points
        })
    }

    fn any_points() -> impl Strategy<Value = Vec<[f64; 3]>> {
        let coordinate = || {
            prop_oneof![
                3 => (-4i32..5).prop_map(f64::from),
                2 => -1.0..1.0f64,
                1 => Just(1e16),
                1 => Just(-1e-300),
                1 => Just(1e300),
            ]
        };
        let weight = prop_oneof![4 => Just(1.0), 1 => Just(0.0), 1 => 0.0..10.0f64];
        proptest::collection::vec((coordinate(), coordinate(), weight).prop_map(Into::into), 0..10)
    }

    properties! {
        #![proptest_config(crate::property_cases::config(500))]

        #[test]
        fn no_line_is_better(points in points()) {
            let fit = fit(&points).expect("finite");
            let LineFitProof { problem, optimum } = fit.proof();
            let truth = brute_force::minimize(&problem).expect("bounded");
            prop_assert_eq!(fit.deviation(), truth.value);
            prop_assert_eq!(optimum.exact_value(&problem), Some(fit.deviation()));
            prop_assert_eq!(check_lad(&problem, &LadOutcome::Optimal(optimum)).proof().map(drop), Ok(()));
            let [slope, intercept] = fit.exact();
            let exact = |v: f64| Rational::try_from(v).expect("finite");
            let sum = points.iter().fold(Rational::ZERO, |sum, p| {
                let off = &slope * exact(p[0]) + &intercept - exact(p[1]);
                sum + exact(p[2]) * if off < Rational::ZERO { -off } else { off }
            });
            prop_assert_eq!(sum, fit.deviation());
        }
    }

    /// Points of the kinds that lead to different ends of the search, with and without weights.
    fn family(kind: usize, n: usize, random: &mut Pcg64Mcg) -> Vec<[f64; 3]> {
        let point = |i: usize| {
            let (u, v) = (random.random_range(-1.0..1.0f64), random.random_range(-1.0..1.0f64));
            let k = f64::from(random.random_range(0..1u32 << 20));
            let [x, y] = match kind {
                0 => [u, 3.0 * u + v * v * v],
                1 => [3.0 * k, 2.0 * k],
                2 => [0.3, v],
                3 => [(k % 10.0), (k / 16.0).floor() % 7.0],
                4 if i.is_multiple_of(2) => [u, 0.5 * u],
                4 => [u, v],
                5 => [1e6 + u, 1e8 + 2.0 * u + v],
                6 => [1e-300 * u, 1e-300 * (u + v)],
                7 => [1e300 * u, 1e300 * (u + v)],
                8 => [1e-9 * u, u + v],
                9 => [f64::from(i as u32) / n as f64, (f64::from(i as u32) / n as f64).powi(2)],
                10 => [f64::from(i as u32 % 20).sqrt(), libm::sin(f64::from(i as u32 % 20))],
                11 => [u / v, v / u],
                _ => [f64::from_bits(1) * (k % 9.0), f64::MAX * u],
            };
            [x, y, 1.0]
        };
        (0..n).map(point).collect()
    }

    #[test]
    fn fits_of_many_points_have_the_deviation_of_their_proofs_at_every_level() {
        let random = &mut Pcg64Mcg::seed_from_u64(5);
        for kind in 0..13 {
            for is_weighted in [false, true] {
                let mut points = family(kind, 600, random);
                let weights = points.iter_mut().enumerate().filter(|_| is_weighted);
                weights.for_each(|(i, point)| point[2] = [1.0, 0.0, 0.3, 2.5][i % 4]);
                let fits = at_each_level(|| fit(&points).expect("finite").minimizer);
                assert!(fits.iter().all(|own| *own == fits[0]), "kind {kind}");
                let fit = fit(&points).expect("finite");
                let LineFitProof { problem, optimum } = fit.proof();
                assert_eq!(optimum.exact_value(&problem), Some(fit.deviation()), "kind {kind}");
                assert_eq!(check_lad(&problem, &LadOutcome::Optimal(optimum)).proof().map(drop), Ok(()));
            }
        }
    }

    #[test]
    fn few_points_and_one_abscissa() {
        let rounded = |points: &[(f64, f64)]| {
            let points: Vec<[f64; 3]> = points.iter().map(|&(x, y)| [x, y, 1.0]).collect();
            fit(&points).expect("finite").rounded()
        };
        assert_eq!(rounded(&[]), [0.0, 0.0]);
        assert_eq!(rounded(&[(1.0, 4.0)]), [2.0, 2.0]);
        assert_eq!(rounded(&[(1.0, 4.0), (3.0, 8.0)]), [2.0, 2.0]);
        assert_eq!(rounded(&[(1.0, 0.0), (1.0, 4.0), (1.0, 9.0)]), [2.0, 2.0]);
    }

    #[test]
    fn refusals_name_the_point() {
        let good = [0.0, 0.0, 1.0];
        let refused = fit(&[good, [0.0, f64::INFINITY, 1.0]]).expect_err("not finite");
        assert_eq!(refused.to_string(), "point 1: y is inf, not a finite number");
        let refused = fit(&[good, good, [0.0, 0.0, -1.0]]).expect_err("negative");
        assert_eq!(refused, LineFitError::NegativeWeight { point: 2, weight: -1.0 });
        let nan = fit(&[good, [f64::NAN, 0.0, 1.0], good]).expect_err("not a number");
        assert_eq!(nan.to_string(), "point 1: x is NaN, not a finite number");
        let first = fit(&[[0.0, 0.0, -1.0], [0.0, 0.0, f64::NAN]]).expect_err("not a number");
        assert_eq!(first.to_string(), "point 1: the weight is NaN, not a finite number");
    }
}
