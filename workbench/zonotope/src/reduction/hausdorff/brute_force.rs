//! The Hausdorff distance of two zonotopes, from the definition in rationals: the truth the other method is held to.
//!
//! # Statement
//! Input: two zonotopes in R^D. Output of [`squared_excess`]: the square of the largest distance of a point of the
//! first from the second. Of [`squared_hausdorff`]: the square of the Hausdorff distance. Bodies without generators,
//! flat bodies, zero and parallel generators are ordinary input.
//!
//! # Source
//! max h_A(u) − h_B(u) over unit vectors u, on each face of the arrangement of the hyperplanes orthogonal to all
//! generators.
//!
//! # Method
//! 1. On a face of the arrangement the difference of the support functions is linear, l · u with l = Σ ± a − Σ ± b. If
//!    a unit vector in the face is a maximum, it is the projection of l on the span of the face, up to its length: the
//!    subspace orthogonal to the generators that vanish there, D − 1 at most of which are independent.
//! 2. So for all signs and all sets of at most D − 1 generators, project l on the subspace orthogonal to the set, and
//!    take the difference of the support functions there. No value exceeds the maximum, and one attains it.
//!
//! # Complexity
//! O(2^m m^(D − 1) (m + D²) D) rational operations for m generators and the displacement.
//!
//! # Shapes
//! `generators`: half-segments, any order; m up to about 9.
//!
//! # Numerics
//! Everything is exact.
//!
//! # Panics
//! If there are more than 20 generators in all.
//!
//! # Checked by
//! Hand-worked examples; its simplicity.
//!
//! # Example
//! ```
//! use dashu_ratio::RBig;
//! use zonotope::{Zonotope, reduction::hausdorff::brute_force::squared_hausdorff};
//! let square = Zonotope::new([0.0, 0.0], vec![[1.0, 0.0], [0.0, 1.0]])?;
//! let diamond = Zonotope::new([0.0, 0.0], vec![[0.5, 0.5], [0.5, -0.5]])?;
//! // the corner (1, 1) is 1/√2 from the diamond's edge x + y = 1
//! assert_eq!(squared_hausdorff(&square, &diamond), RBig::from_parts(1.into(), 2u8.into()));
//! # Ok::<(), zonotope::ZonotopeError>(())
//! ```

use crate::numeric::Rational;
use crate::numeric::exact_linear::{rational, solve, sum_of_products};
use crate::numeric::subsets::for_each_subset;
use crate::zonotope::Zonotope;

/// The square of the largest distance of a point of `body` from `other`.
pub fn squared_excess<const D: usize>(body: &Zonotope<D>, other: &Zonotope<D>) -> Rational {
    let vectors = |body: &Zonotope<D>| -> Vec<Vec<Rational>> {
        body.generators().iter().map(|g| g.map(rational).to_vec()).collect()
    };
    let displacement = (0..D).map(|k| rational(body.center()[k]) - rational(other.center()[k])).collect();
    let farther = [vectors(body), vec![displacement]].concat();
    let signed: Vec<(Vec<Rational>, bool)> = farther
        .into_iter()
        .map(|v| (v, true))
        .chain(vectors(other).into_iter().map(|v| (v, false)))
        .filter(|(v, _)| v.iter().any(|c| *c != Rational::ZERO))
        .collect();
    assert!(signed.len() <= 20, "the signs of {} generators are too many", signed.len());
    let mut largest = Rational::ZERO;
    for size in 0..D.min(signed.len() + 1) {
        for_each_subset(signed.len(), size, |chosen| {
            let Some(projection) = Projection::orthogonal_to(chosen.iter().map(|&index| &signed[index].0)) else {
                return;
            };
            for signs in 0..1u32 << signed.len() {
                let direction = projection.of(&signed_sum(&signed, signs, D));
                let square = sum_of_products(&direction, &direction);
                let value = difference(&signed, &direction);
                if value > Rational::ZERO && &value * &value > &largest * &square {
                    largest = &value * &value / square;
                }
            }
        });
    }
    largest
}

/// The square of the Hausdorff distance.
pub fn squared_hausdorff<const D: usize>(a: &Zonotope<D>, b: &Zonotope<D>) -> Rational {
    squared_excess(a, b).max(squared_excess(b, a))
}

/// Σ ± v, with the opposite sign for those that count against.
fn signed_sum(signed: &[(Vec<Rational>, bool)], signs: u32, dimension: usize) -> Vec<Rational> {
    let mut sum = vec![Rational::ZERO; dimension];
    for (index, (v, counts_for)) in signed.iter().enumerate() {
        let is_plus = (signs >> index & 1 == 0) == *counts_for;
        for (sum, c) in sum.iter_mut().zip(v) {
            if is_plus { *sum += c } else { *sum -= c }
        }
    }
    sum
}

/// The difference of the support functions.
fn difference(signed: &[(Vec<Rational>, bool)], direction: &[Rational]) -> Rational {
    signed.iter().fold(Rational::ZERO, |sum, (v, counts_for)| {
        let product = sum_of_products(v, direction);
        if (product > Rational::ZERO) == *counts_for { sum + product } else { sum - product }
    })
}

/// The projection on the subspace orthogonal to independent vectors.
struct Projection<'a> {
    normals: Vec<&'a Vec<Rational>>,
    /// The products of the normals with each other, by columns.
    products: Vec<Vec<Rational>>,
}

impl<'a> Projection<'a> {
    /// `None` if the vectors are dependent: fewer of them have the same subspace.
    fn orthogonal_to(normals: impl Iterator<Item = &'a Vec<Rational>>) -> Option<Self> {
        let normals: Vec<&Vec<Rational>> = normals.collect();
        let products: Vec<Vec<Rational>> =
            normals.iter().map(|a| normals.iter().map(|b| sum_of_products(a, b)).collect()).collect();
        let is_regular = crate::numeric::exact_linear::inverse(products.clone()).is_some();
        is_regular.then_some(Self { normals, products })
    }

    fn of(&self, vector: &[Rational]) -> Vec<Rational> {
        let along: Vec<Rational> = self.normals.iter().map(|n| sum_of_products(n, vector)).collect();
        let shares = solve(&self.products, &along).expect("the normals are independent, so their products are regular");
        let mut left = vector.to_vec();
        for (normal, share) in self.normals.iter().zip(shares) {
            left.iter_mut().zip(normal.iter()).for_each(|(c, n)| *c -= &share * n);
        }
        left
    }
}
