//! The three enclosing problems by their default methods, one function each; all answers have the shape [`Enclosing`].
//!
//! Who wants another method, other weights or a count of the operations takes the `Method` of the problem's module.

use super::answer::Enclosing;
use super::fixed_directions::{self, DirectionsProof, Enclosure, FixedDirections, FixedDirectionsError};
use super::min_area_zonogon::{self, MinAreaError, MinAreaZonogon};
use super::min_total_length::{self, MinLengthError, MinLengthZonotope, few_generators};
use crate::seed::DEFAULT_SEED;

/// The zonogon of least area around points of the plane: [`min_area_zonogon`] by its default method.
///
/// # Errors
/// When there are no points, too many, or one is not finite.
///
/// # Example
/// ```
/// let answer = zonotope::enclosing::min_area(&[[0.0, 0.0], [2.0, 0.0], [0.0, 2.0]])?;
/// assert_eq!((answer.value, answer.lower_bound), (4.0, 4.0)); // nothing smaller holds the triangle
/// # Ok::<(), zonotope::enclosing::min_area_zonogon::MinAreaError>(())
/// ```
pub fn min_area(points: &[[f64; 2]]) -> Result<MinAreaZonogon, MinAreaError> {
    min_area_zonogon::Method::default().solve(points, DEFAULT_SEED, &mut ())
}

/// The zonotope of least total length around points whose generators point along given directions: [`fixed_directions`]
/// by its default method, each direction weighted by its length.
///
/// That the directions do not span the differences of the points is an ordinary outcome and no error: no such zonotope
/// exists, and [`Enclosure::Infeasible`] carries the proof.
///
/// # Errors
/// When there are no points, a number is not finite, or the answer leaves the range of doubles.
///
/// # Example
/// ```
/// // around a right triangle, along its legs: a square of half-lengths 1 and 1
/// let triangle = [[0.0, 0.0], [2.0, 0.0], [0.0, 2.0]];
/// let answer = zonotope::enclosing::along_directions(&triangle, &[[3.0, 0.0], [0.0, 1.0]])?;
/// let square = answer.optimal().expect("the directions span the plane");
/// assert_eq!(square.body.center(), [1.0, 1.0]);
/// assert!(square.lower_bound <= 2.0 && 2.0 <= square.value && square.value - square.lower_bound < 1e-12);
/// # Ok::<(), zonotope::enclosing::fixed_directions::FixedDirectionsError>(())
/// ```
#[inline(never)]
pub fn along_directions<const D: usize>(
    points: &[[f64; D]],
    directions: &[[f64; D]],
) -> Result<Enclosure<D, Enclosing<D, DirectionsProof<D>>>, FixedDirectionsError> {
    let lengths: Vec<f64> = directions.iter().map(length).collect();
    let problem = FixedDirections::new(points, directions, &lengths)?;
    fixed_directions::Method::default().solve(&problem, &mut ())?.in_doubles(&problem)
}

/// A zonotope of few generators around points whose total length is within 1 + ε of the least, over all directions:
/// [`min_total_length`] by its default method, then [`few_generators`](min_total_length::few_generators).
///
/// # Errors
/// When there are no points, one is not finite, ε is not between 0 and 1, or the length leaves the range of doubles.
///
/// # Example
/// ```
/// // a diamond is a zonotope: two generators of half-length sqrt(1/2)
/// let diamond = [[1.0, 0.0], [-1.0, 0.0], [0.0, 1.0], [0.0, -1.0]];
/// let answer = zonotope::enclosing::min_length(&diamond, 1e-9)?;
/// assert!((answer.value - 2f64.sqrt()).abs() < 1e-8 && answer.ratio() <= 1.0 + 1e-9);
/// assert_eq!(answer.body.generators().len(), 2);
/// # Ok::<(), zonotope::enclosing::min_total_length::MinLengthError>(())
/// ```
#[inline(never)]
pub fn min_length<const D: usize>(points: &[[f64; D]], epsilon: f64) -> Result<MinLengthZonotope<D>, MinLengthError> {
    let answer = min_total_length::Method::default().solve(points, epsilon, &mut ())?;
    Ok(few_generators::fewest(points, answer, epsilon))
}

/// The shortest zonotope found around points with at most `count` generators, with a lower bound of all total lengths
/// that is within 1 + ε of the least; the ratio of the two is proven, and may be larger than 1 + ε.
///
/// # Errors
/// Those of [`min_length`], and when so few generators do not span what the points do.
///
/// # Example
/// ```
/// // around a regular octahedron: a parallelepiped
/// let [x, y, z] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
/// let octahedron = [x, y, z, x.map(|c: f64| -c), y.map(|c: f64| -c), z.map(|c: f64| -c)];
/// let answer = zonotope::enclosing::min_length_of_few(&octahedron, 1e-3, 3)?;
/// assert_eq!(answer.body.generators().len(), 3);
/// assert!(answer.lower_bound <= answer.value && answer.value < 3.0 + 1e-9);
/// # Ok::<(), zonotope::enclosing::min_total_length::MinLengthError>(())
/// ```
#[inline(never)]
pub fn min_length_of_few<const D: usize>(
    points: &[[f64; D]],
    epsilon: f64,
    count: usize,
) -> Result<MinLengthZonotope<D>, MinLengthError> {
    let answer = min_total_length::Method::default().solve(points, epsilon, &mut ())?;
    few_generators::shortest_of_few(points, answer, epsilon, count)
}

/// The length of a vector, whose squares neither overflow nor vanish. A direction that is not finite is left to the
/// problem to refuse, by its own coordinate and not by its length.
fn length<const D: usize>(v: &[f64; D]) -> f64 {
    let largest = v.iter().fold(0.0f64, |largest, c| largest.max(c.abs()));
    let square = |c: &f64| (c / largest) * (c / largest);
    if largest == 0.0 { 0.0 } else { largest * v.iter().map(square).sum::<f64>().sqrt() }
}

#[cfg(test)]
mod tests {
    use super::*;

    const SCATTERED: [[f64; 3]; 5] =
        [[0.1, 0.7, -0.3], [1.3, -0.2, 0.9], [-0.6, 0.4, 1.1], [0.8, 0.8, 0.8], [-1.0, -0.1, 0.2]];

    #[test]
    fn bodies_along_directions_contain_the_points_and_cost_what_they_say() {
        let directions = [[0.1, 0.2, 0.3], [0.7, -0.1, 0.0], [0.0, 0.3, -0.9], [1.0, 1.0, 1.0]];
        let answer = along_directions(&SCATTERED, &directions).expect("the numbers are finite");
        let best = answer.optimal().expect("the directions span space");
        assert!(SCATTERED.iter().all(|&point| best.body.contains(point) == Ok(true)));
        assert!(best.lower_bound <= best.value && best.relative_gap() < 1e-12);
        let weighted: f64 = directions.iter().zip(&best.proof.coefficients).map(|(v, c)| length(v) * c).sum();
        assert!((weighted - best.value).abs() < 1e-12);
        // over all directions nothing is longer
        let free = min_length(&SCATTERED, 1e-6).expect("the numbers are finite");
        assert!(free.lower_bound <= best.value && SCATTERED.iter().all(|&p| free.body.contains(p) == Ok(true)));
        assert_eq!(free.effort.rounds, free.effort.progress.len());
    }

    #[test]
    fn directions_that_span_too_little_are_an_outcome() {
        let answer = along_directions(&SCATTERED, &[[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]).expect("finite");
        let Enclosure::Infeasible(proof) = answer else { panic!("two directions do not span space") };
        assert_eq!(proof.points.map(|point| point < SCATTERED.len()), [true; 2]);
    }

    #[test]
    fn what_is_not_finite_is_refused_by_name() {
        let refused = along_directions(&[[0.0, 0.0]], &[[1.0, f64::NAN]]).expect_err("NaN is no coordinate");
        assert_eq!(refused.to_string(), "direction 0, coordinate 1 is NaN, not a finite number");
        let refused = min_area(&[[0.0, 0.0], [f64::INFINITY, 0.0]]).expect_err("infinity is no coordinate");
        assert_eq!(refused.to_string(), "point 1, coordinate 0 is inf, not a finite number");
        let refused = min_length(&[[0.0; 2], [f64::NAN, 0.0]], 0.5).expect_err("NaN is no coordinate");
        assert_eq!(refused.to_string(), "point 1, coordinate 0 is NaN, not a finite number");
    }
}
