//! The distance of two bodies, from every parallelotope of the body: the truth, in exact arithmetic.
//!
//! # Statement
//! Input: a displacement p and generators g_i in R^D, any D ≥ 1. Output: the point x of Z = { Σ δ_i g_i : |δ_i| ≤ 1 }
//! that is nearest to p, and the square of its distance, exactly; 0 for members.
//!
//! # Source
//! None; the definition of the distance.
//!
//! # Method
//! 1. Every point of Z is one of a parallelotope: coefficients that are neither 1 nor −1 can be moved along linear
//!    dependences until they belong to independent generators.
//! 2. For each independent set of at most D generators and each choice of signs for the others, project p on the
//!    affine hull of that parallelotope. If the projection lies in the parallelotope, it is a candidate. The nearest
//!    point of Z is among them: it lies in the relative interior of a parallelotope, or of a face of one, which is one
//!    of fewer generators.
//! 3. The nearest candidate is the nearest point of Z.
//!
//! # Complexity
//! n generators: O(2^n n^D) solutions of D equations in rationals.
//!
//! # Shapes
//! generators: n × D, any order, zero and parallel ones allowed.
//!
//! # Numerics
//! Exact rationals throughout.
//!
//! # Panics
//! If there are more than 20 generators, too many to finish.
//!
//! # Checked by
//! Squares and cubes by hand.
//!
//! # Example
//! ```
//! use zonotope::collision::{Query, distance::brute_force};
//! let square = [[1.0, 0.0], [0.0, 1.0]];
//! let query = Query::new([0.0, 0.0], [4.0, 5.0], &square).unwrap();
//! assert_eq!(brute_force::nearest_point(&query).squared_distance, 25.into());
//! ```

use std::array;

use crate::numeric::Rational;
use crate::numeric::exact_linear::{inverse, rational, sum_of_products};
use crate::numeric::subsets::for_each_subset;
use crate::zonotope::query::Query;

/// As many generators as the method takes: each doubles its time.
const MOST_GENERATORS: usize = 20;

/// The nearest point of a zonotope to a displacement.
#[derive(Debug, Clone, PartialEq)]
pub struct NearestPoint<const D: usize> {
    /// The square of the distance.
    pub squared_distance: Rational,
    /// The point, as a displacement from the centre.
    pub point: [Rational; D],
}

/// The nearest point of the zonotope to the displacement of a query.
pub fn nearest_point<const D: usize>(query: &Query<'_, D>) -> NearestPoint<D> {
    assert!(query.len() <= MOST_GENERATORS, "the number of signs is a power of two");
    let p = query.exact().map(|c| c.to_rational());
    let generators: Vec<[Rational; D]> = query.generators().map(|g| g.map(rational)).collect();
    let mut best: Option<NearestPoint<D>> = None;
    for size in 0..=D {
        for_each_subset(generators.len(), size, |free| {
            let Some(projection) = Projection::of(free.iter().map(|&i| &generators[i]).collect()) else { return };
            let fixed: Vec<&[Rational; D]> =
                (0..generators.len()).filter(|i| !free.contains(i)).map(|i| &generators[i]).collect();
            for signs in 0..1u32 << fixed.len() {
                let corner = fixed.iter().enumerate().fold(array::from_fn(|_| Rational::ZERO), |sum, (place, g)| {
                    let is_minus = signs & (1 << place) != 0;
                    array::from_fn(|k: usize| if is_minus { &sum[k] - &g[k] } else { &sum[k] + &g[k] })
                });
                let Some(candidate) = projection.nearest(&corner, &p) else { continue };
                if best.as_ref().is_none_or(|best| candidate.squared_distance < best.squared_distance) {
                    best = Some(candidate);
                }
            }
        });
    }
    best.expect("the corners of the body are candidates")
}

/// The projection on the span of independent generators.
struct Projection<'a, const D: usize> {
    generators: Vec<&'a [Rational; D]>,
    /// The inverse of the matrix of their products.
    inverse: Vec<Vec<Rational>>,
}

impl<'a, const D: usize> Projection<'a, D> {
    /// `None` if the generators are dependent.
    fn of(generators: Vec<&'a [Rational; D]>) -> Option<Self> {
        let row = |a: &&[Rational; D]| generators.iter().map(|b| sum_of_products(*a, *b)).collect();
        let inverse = inverse(generators.iter().map(row).collect())?;
        Some(Self { generators, inverse })
    }

    /// The nearest point to p of the affine hull of the parallelotope around a corner, if it lies in the parallelotope.
    fn nearest(&self, corner: &[Rational; D], p: &[Rational; D]) -> Option<NearestPoint<D>> {
        let off: [Rational; D] = array::from_fn(|k| &p[k] - &corner[k]);
        let products: Vec<Rational> = self.generators.iter().map(|g| sum_of_products(*g, &off)).collect();
        let mut point = corner.clone();
        for (row, generator) in self.inverse.iter().zip(&self.generators) {
            let coefficient = sum_of_products(row, &products);
            if coefficient > Rational::ONE || coefficient < Rational::NEG_ONE {
                return None;
            }
            point = array::from_fn(|k| &point[k] + &coefficient * &generator[k]);
        }
        let left: [Rational; D] = array::from_fn(|k| &p[k] - &point[k]);
        Some(NearestPoint { squared_distance: sum_of_products(&left, &left), point })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn squared<const D: usize>(to: [f64; D], generators: &[[f64; D]]) -> Rational {
        nearest_point(&Query::new([0.0; D], to, generators).expect("finite")).squared_distance
    }

    #[test]
    fn cubes_by_hand() {
        let cube = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        let cases = [([3.0, 0.5, 0.5], 4), ([3.0, 3.0, 0.5], 8), ([-2.0, 2.0, 3.0], 6), ([1.0, 1.0, 1.0], 0)];
        for (point, expected) in cases.into_iter().chain([([0.5, 0.25, 0.0], 0)]) {
            assert_eq!(squared(point, &cube), Rational::from(expected));
        }
    }

    #[test]
    fn flat_repeated_and_missing_generators() {
        assert_eq!(squared([1.0, 2.0], &[]), Rational::from(5));
        assert_eq!(squared([3.0, 2.0], &[[1.0, 0.0], [0.0, 0.0], [-1.0, 0.0]]), Rational::from(5));
        assert_eq!(squared([3.0], &[[1.0], [0.5]]), Rational::from_parts(9.into(), 4u8.into()));
    }
}
