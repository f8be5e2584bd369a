//! The coefficients of three generators that make up for what all others leave, with bounds in terms of coordinates.

use crate::collision::proof::vectors::Vector;
use crate::numeric::linear::{cyclic_cross_products, dot};
use crate::numeric::tolerance::{CUBABLE_SIZES, LONG_SUM, PRODUCT_UNDERFLOW, THIRTY_ROUNDINGS, UNIT};

/// A sum less a multiple of a vector.
#[inline]
pub(in crate::collision) fn minus(sum: [f64; 3], factor: f64, v: &[f64; 3]) -> [f64; 3] {
    [sum[0] - factor * v[0], sum[1] - factor * v[1], sum[2] - factor * v[2]]
}

/// The coefficients of three vectors that make up a rest whose coordinates are off by at most `errors`: those that are
/// certainly within (−1, 1). `None` if the three may be dependent; their determinant is off by less than the part
/// `determinant_error` of the sum of the magnitudes of its terms.
#[inline]
pub(in crate::collision) fn solve(
    [a, b, c]: &[Vector; 3],
    determinant_error: f64,
    rest: &[f64; 3],
    errors: &[f64; 3],
) -> Option<[Option<f64>; 3]> {
    let normals = cyclic_cross_products(&a.value, &b.value, &c.value);
    let areas = [cross_terms(b, c), cross_terms(c, a), cross_terms(a, b)];
    let determinant = dot(&c.value, &normals[2]);
    let least = determinant.abs() - determinant_error * dot(&c.size, &areas[2]) - PRODUCT_UNDERFLOW;
    // false for NaN as well
    let is_spanning = least > CUBABLE_SIZES.start * CUBABLE_SIZES.start * CUBABLE_SIZES.start;
    if !is_spanning {
        return None;
    }
    // each term of the product of the rest with a normal goes through seven roundings, and images bring eight more
    let off = [0, 1, 2].map(|k| errors[k] + 16.0 * UNIT * rest[k].abs());
    let coefficient = |k: usize| {
        let numerator = dot(rest, &normals[k]);
        let error = dot(&off, &areas[k]) * LONG_SUM + PRODUCT_UNDERFLOW;
        let is_within = (numerator.abs() + error) * THIRTY_ROUNDINGS < least;
        is_within.then_some(numerator / determinant)
    };
    Some([coefficient(0), coefficient(1), coefficient(2)])
}

/// The sums of the magnitudes of the terms of a cross product, with room for what underflows.
#[inline]
pub(in crate::collision) fn cross_terms(Vector { size: a, .. }: &Vector, Vector { size: b, .. }: &Vector) -> [f64; 3] {
    let terms = |i: usize, j: usize| a[i] * b[j] + a[j] * b[i] + PRODUCT_UNDERFLOW;
    [terms(1, 2), terms(2, 0), terms(0, 1)]
}
