//! The line y ≈ slope · x + intercept of least absolute deviations through weighted points, by the kernel.
//!
//! # Statement
//! Input: points with weights w_i ≥ 0 ([`FitPoint`]). Output: an exact minimiser of Σ w_i |slope · x_i + intercept − y_i| with its proof. When the best
//! line is not unique it is a vertex of the set of best lines, one through two points. If all points of positive weight have
//! the same x, any line through their weighted median is best: the answer is the one whose (slope, intercept) is nearest to the
//! origin, and so for one point. Without points of positive weight it is y = 0.
//!
//! # Source
//! Beyond the paper: the points are generators (x, 1, −y) of a zonotope, and the fit is the kernel's problem for them.
//!
//! # Method
//! 1. Points of equal weights are generators (x_i, 1, −y_i), and the facet of their zonotope in which the ray along the third axis leaves
//!    ([`by_lad::facet`]) is spanned by the two points that the best line goes through.
//! 2. Where there is no such facet (all points on one line, one abscissa), and for other weights, in the plane of (slope, intercept) each
//!    point is the line x_i · slope + intercept − y_i = 0 with the weight w_i: minimise by [`by_pruning`].
//!
//! # Complexity
//! n points: expected O(n), space O(n). The [proof](LineFit::proof) with its O(n) coefficients is made when it is asked for.
//!
//! # Shapes
//! `points`: n of them in any order, duplicates allowed.
//!
//! # Numerics
//! The line is the exact optimum, with rational slope and intercept; [`LineFit::rounded`] rounds them.
//!
//! # Errors
//! [`LineFitError::NonFinite`] ⇔ a coordinate or a weight is NaN or infinite; [`LineFitError::NegativeWeight`] ⇔ a weight is below zero;
//! [`LineFitError::TooMany`] ⇔ 2^32 points or more.
//!
//! # Panics
//! Never.
//!
//! # Checked by
//! The kernel's brute force, and [`verify`](crate::lad::verify::verify) on every answer.
//!
//! # Example
//! ```
//! use zonotope::line_fit::{FitPoint, fit};
//! // three points on y = 2 x + 1 and one far off: least absolute deviations ignore it
//! let points = [(0.0, 1.0), (1.0, 3.0), (2.0, 5.0), (1.5, 40.0)].map(|(x, y)| FitPoint::unweighted(x, y));
//! let fit = fit(&points).unwrap();
//! assert_eq!(fit.rounded(), [2.0, 1.0]);
//! assert_eq!(fit.deviation(), 36.into());
//! ```

use thiserror::Error;

use crate::arrangement::{ExactLine, LineIndex};
use crate::collision::{Displacement, by_lad};
use crate::lad::{LadError, LadOptimum, LadProblem, Minimizer, WeightedLine, by_pruning};
use crate::numeric::Rational;
use crate::numeric::dyadic::Dyadic;
use crate::tally::Tally;

/// The seed of the kernel's sample: it decides the time, never the line.
const SEED: u64 = 0x11;

/// A point with a weight.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FitPoint {
    /// The abscissa.
    pub x: f64,
    /// The value that the line is to approximate.
    pub y: f64,
    /// The weight, not negative.
    pub weight: f64,
}

impl FitPoint {
    /// A point of weight 1.
    pub fn unweighted(x: f64, y: f64) -> Self {
        Self { x, y, weight: 1.0 }
    }
}

/// Why points are refused.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
#[non_exhaustive]
pub enum LineFitError {
    /// A coordinate or a weight is NaN or infinite.
    #[error("point {point}: {field} is {value}, not a finite number")]
    NonFinite {
        /// The point.
        point: usize,
        /// "x", "y" or "the weight".
        field: &'static str,
        /// Its value.
        value: f64,
    },
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
    points: &'p [FitPoint],
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
pub fn fit(points: &[FitPoint]) -> Result<LineFit<'_>, LineFitError> {
    fit_counted(points, &mut ())
}

/// [`fit`], counting its operations.
///
/// # Errors
/// Those of [`fit`].
pub fn fit_counted<'p>(points: &'p [FitPoint], tally: &mut impl Tally) -> Result<LineFit<'p>, LineFitError> {
    if let Some(minimizer) = at_facet(points, tally) {
        return Ok(LineFit { points, minimizer });
    }
    let problem = problem_of(points)?;
    let outcome = by_pruning::minimize_counted(&problem, SEED, tally);
    let optimum = outcome.optimum().expect("a sum of absolute values is bounded below");
    Ok(LineFit { points, minimizer: optimum.minimizer })
}

/// The two points that the best line goes through, for finite points of one positive weight that are not on one line.
fn at_facet(points: &[FitPoint], tally: &mut impl Tally) -> Option<Minimizer> {
    let weight = points.first()?.weight;
    if !(weight > 0.0 && weight.is_finite() && points.iter().all(|point| point.weight == weight)) {
        return None;
    }
    let generators: Vec<[f64; 3]> = points.iter().map(|point| [point.x, 1.0, -point.y]).collect();
    let question = Displacement::new([0.0; 3], [0.0, 0.0, 1.0], &generators).ok()?;
    let facet = by_lad::facet_counted(&question, tally);
    let is_best = facet.is_sharp() && facet.value().0 < f64::MAX;
    match *facet.basis() {
        [first, second] if is_best && points[first].x != points[second].x => {
            let index = |point| u32::try_from(point).ok().map(LineIndex);
            Some(Minimizer::Vertex(index(first)?, index(second)?))
        }
        _ => None,
    }
}

fn problem_of(points: &[FitPoint]) -> Result<LadProblem<'static>, LineFitError> {
    let line = |&FitPoint { x, y, weight }: &FitPoint| WeightedLine { normal: [x, 1.0], offset: -y, weight };
    let lines: Vec<WeightedLine> = points.iter().map(line).collect();
    LadProblem::new(&lines, [0.0, 0.0]).map_err(|error| LineFitError::of(error, points.len()))
}

impl LineFitError {
    /// The kernel's refusal in terms of points; there is no linear term to refuse.
    fn of(error: LadError, count: usize) -> Self {
        match error {
            LadError::NonFinite { line, coefficient: "offset", value } => {
                Self::NonFinite { point: line, field: "y", value: -value }
            }
            LadError::NonFinite { line, coefficient: "weight", value } => {
                Self::NonFinite { point: line, field: "the weight", value }
            }
            LadError::NonFinite { line, value, .. } => Self::NonFinite { point: line, field: "x", value },
            LadError::NegativeWeight { line, weight } => Self::NegativeWeight { point: line, weight },
            LadError::NonFiniteLinear { .. } | LadError::TooMany { .. } => Self::TooMany { count },
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
        let deviations = self.points.iter().map(|p| line_of(p).evaluate(&point).abs() * Dyadic::from_f64(p.weight));
        let total = deviations.fold(Dyadic::zero(), |sum, deviation| sum + deviation);
        total.to_rational() / point[2].to_rational()
    }

    /// The proof that no line is better; where several are as good, its own may be another one. Expected O(n).
    pub fn proof(&self) -> LineFitProof {
        let problem = problem_of(self.points).expect("the points were validated when the line was fitted");
        let outcome = by_pruning::minimize(&problem, SEED);
        let optimum = outcome.into_optimum().expect("a sum of absolute values is bounded below");
        LineFitProof { problem, optimum }
    }

    fn homogeneous(&self) -> [Dyadic; 3] {
        self.minimizer.homogeneous_point(|line| line_of(&self.points[line.position()]))
    }
}

/// The lines through a point, as a line of the plane of (slope, intercept).
fn line_of(point: &FitPoint) -> ExactLine {
    let [x, one, y] = [point.x, 1.0, -point.y].map(Dyadic::from_f64);
    ExactLine { normal: [x, one], offset: y }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::lad::{LadOutcome, brute_force, verify::verify};
    use proptest::prelude::*;

    fn points() -> impl Strategy<Value = Vec<FitPoint>> {
        (any::<bool>(), any_points()).prop_map(|(equal, mut points)| {
            points.iter_mut().filter(|_| equal).for_each(|point| point.weight = 0.5);
            points
        })
    }

    fn any_points() -> impl Strategy<Value = Vec<FitPoint>> {
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
        let point = (coordinate(), coordinate(), weight).prop_map(|(x, y, weight)| FitPoint { x, y, weight });
        proptest::collection::vec(point, 0..10)
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(500))]

        #[test]
        fn no_line_is_better(points in points()) {
            let fit = fit(&points).expect("finite");
            let LineFitProof { problem, optimum } = fit.proof();
            let truth = brute_force::minimize(&problem).expect("bounded");
            prop_assert_eq!(fit.deviation(), truth.value);
            prop_assert_eq!(optimum.exact_value(&problem), fit.deviation());
            prop_assert_eq!(verify(&problem, &LadOutcome::Optimal(optimum)), Ok(()));
            let [slope, intercept] = fit.exact();
            let exact = |v: f64| Rational::try_from(v).expect("finite");
            let sum = points.iter().fold(Rational::ZERO, |sum, p| {
                let off = &slope * exact(p.x) + &intercept - exact(p.y);
                sum + exact(p.weight) * if off < Rational::ZERO { -off } else { off }
            });
            prop_assert_eq!(sum, fit.deviation());
        }
    }

    #[test]
    fn few_points_and_one_abscissa() {
        let rounded = |points: &[(f64, f64)]| {
            let points: Vec<FitPoint> = points.iter().map(|&(x, y)| FitPoint::unweighted(x, y)).collect();
            fit(&points).expect("finite").rounded()
        };
        assert_eq!(rounded(&[]), [0.0, 0.0]);
        assert_eq!(rounded(&[(1.0, 4.0)]), [2.0, 2.0]);
        assert_eq!(rounded(&[(1.0, 4.0), (3.0, 8.0)]), [2.0, 2.0]);
        assert_eq!(rounded(&[(1.0, 0.0), (1.0, 4.0), (1.0, 9.0)]), [2.0, 2.0]);
    }

    #[test]
    fn refusals_name_the_point() {
        let bad = FitPoint { x: 0.0, y: f64::INFINITY, weight: 1.0 };
        let good = FitPoint::unweighted(0.0, 0.0);
        let refused = fit(&[good, bad]).expect_err("not finite");
        assert_eq!(refused, LineFitError::NonFinite { point: 1, field: "y", value: f64::INFINITY });
        let refused = fit(&[FitPoint { weight: -1.0, ..good }]).expect_err("negative");
        assert_eq!(refused, LineFitError::NegativeWeight { point: 0, weight: -1.0 });
        let nan = fit(&[FitPoint { x: f64::NAN, ..good }]).expect_err("not a number");
        assert!(matches!(nan, LineFitError::NonFinite { point: 0, field: "x", .. }));
    }
}
