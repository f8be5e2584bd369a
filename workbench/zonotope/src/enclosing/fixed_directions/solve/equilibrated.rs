//! A problem whose directions are far thinner along some axes than along others, in coordinates that are multiplied by
//! powers of two so that the directions are about as long along each axis.
//!
//! The methods in floating point solve for normals with an absolute precision, which says little of an axis along which
//! all directions are a billionth of their length. A linear map changes neither the coefficients nor which zonotopes
//! contain the points, and one by powers of two is exact in doubles; where it is not, because a number would leave
//! their range, the problem stays as it is. Directions that are thin along a line that is no axis are not changed
//! either.

use crate::enclosing::fixed_directions::answer::{DirectedZonotope, Multiplier};
use crate::enclosing::fixed_directions::problem::FixedDirections;
use crate::numeric::dyadic::Dyadic;
use crate::numeric::scaling::{binary_exponent, scale_by_power_of_two};

/// An axis is scaled where no direction's coordinate exceeds this part of its length, as a power of two.
const THIN_EXPONENT: i64 = -10;

/// Points and directions in coordinates of like sizes.
pub(in crate::enclosing::fixed_directions) struct Equilibrated<const D: usize> {
    points: Vec<[f64; D]>,
    directions: Vec<[f64; D]>,
    /// The powers of two by which the coordinates are multiplied.
    exponents: [i64; D],
}

impl<const D: usize> Equilibrated<D> {
    /// The scaled problem, or `None` where no axis is thin or a number would be rounded. O((n + k) D).
    pub(in crate::enclosing::fixed_directions) fn new(problem: &FixedDirections<'_, D>) -> Option<Self> {
        let exponents = thinness(problem.directions()).map(|thin| if thin < THIN_EXPONENT { -thin } else { 0 });
        if exponents == [0; D] {
            return None;
        }
        let scaled = |vectors: &[[f64; D]]| -> Option<Vec<[f64; D]>> {
            vectors.iter().map(|v| scaled_exactly(v, &exponents)).collect()
        };
        Some(Self { points: scaled(problem.points())?, directions: scaled(problem.directions())?, exponents })
    }

    /// The problem in the scaled coordinates, with the weights of the original one.
    pub(in crate::enclosing::fixed_directions) fn problem<'a>(
        &'a self,
        original: &FixedDirections<'a, D>,
    ) -> FixedDirections<'a, D> {
        FixedDirections::new(&self.points, &self.directions, original.weights())
            .expect("scaled coordinates are finite and weights are those of a problem")
    }

    /// An answer of the scaled problem in the coordinates of the original one; `None` where its centre is no point of
    /// doubles there. A multiplier λ takes the powers that its point takes, so that λ · p stays.
    pub(in crate::enclosing::fixed_directions) fn restored(
        &self,
        answer: DirectedZonotope<D>,
    ) -> Option<DirectedZonotope<D>> {
        let center = scaled_exactly(&answer.center, &self.exponents.map(|e| -e))?;
        let units = self.exponents.map(|e| Dyadic::new(1.into(), e).to_rational());
        let restored = |m: Multiplier<D>| Multiplier { vector: std::array::from_fn(|c| &m.vector[c] * &units[c]), ..m };
        let multipliers = answer.multipliers.into_iter().map(restored).collect();
        Some(DirectedZonotope { center, multipliers, ..answer })
    }
}

/// For each axis the greatest exponent of a direction's coordinate relative to that of its length; 0 for an axis that
/// all directions are orthogonal to.
fn thinness<const D: usize>(directions: &[[f64; D]]) -> [i64; D] {
    let mut most = [None; D];
    for v in directions {
        let exponents = v.map(|c| binary_exponent(c).map(i64::from));
        let Some(longest) = exponents.iter().flatten().max().copied() else { continue };
        for (most, exponent) in most.iter_mut().zip(exponents) {
            *most = (*most).max(exponent.map(|e| e - longest));
        }
    }
    most.map(|most| most.unwrap_or(0))
}

/// A vector with its coordinates multiplied by powers of two, if none of them is rounded.
fn scaled_exactly<const D: usize>(v: &[f64; D], exponents: &[i64; D]) -> Option<[f64; D]> {
    let scaled: [f64; D] = std::array::from_fn(|c| scale_by_power_of_two(v[c], exponents[c]));
    let is_exact = |c: usize| scaled[c].is_finite() && scale_by_power_of_two(scaled[c], -exponents[c]) == v[c];
    (0..D).all(is_exact).then_some(scaled)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn thin_axes_are_stretched_and_others_stay() {
        let directions = [[1.0, 0.0, 2f64.powi(-30)], [0.5, 0.0, -2f64.powi(-32)], [0.0, 0.0, 0.0]];
        assert_eq!(thinness(&directions), [0, 0, -30]);
        let points = [[3.0, 0.0, 2f64.powi(-31)]];
        let problem = FixedDirections::new(&points, &directions, &[1.0; 3]).expect("valid");
        let found = Equilibrated::new(&problem).expect("the last axis is thin");
        assert_eq!((found.points, found.exponents), (vec![[3.0, 0.0, 0.5]], [0, 0, 30]));
        let on_the_line = FixedDirections::new(&[[1.0]], &[[0.5]], &[1.0]).expect("valid");
        assert!(Equilibrated::new(&on_the_line).is_none());
    }

    #[test]
    fn numbers_that_would_be_rounded_leave_the_problem_as_it_is() {
        let directions = [[1.0, 2f64.powi(-30)], [0.0, 2f64.powi(-31)]];
        let points = [[0.0, 2f64.powi(1010)]];
        assert!(Equilibrated::new(&FixedDirections::new(&points, &directions, &[1.0; 2]).expect("valid")).is_none());
    }
}
