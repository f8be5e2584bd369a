//! Three generators that balance a small rest, whatever it is: the basis of a proof by coefficients.

use crate::collision::Query;
use crate::collision::by_lad::early::huber_dual::WELL_WITHIN;
use crate::collision::proof::balance::well_spread::well_spread;
use crate::lad::of_generators::seam::kernel_query::KernelQuery;
use crate::lad::of_generators::span::flat::SimplePlane;
use crate::numeric::linear::{cross, dot, sum_norm};
use crate::numeric::tolerance::{CUBABLE_SIZES, LONG_SUM, PRODUCT_UNDERFLOW, UNIT};

/// Three generators whose coefficients stay within (−1, 1) when they make up for a rest of which no coordinate is
/// larger than `rest`.
///
/// Let r be that rest and a, b, c the three: the correction of the coefficient of a is r · (b × c) / a · (b × c).
#[inline]
pub(crate) fn correcting_basis(
    query: &impl KernelQuery,
    coefficients: &[f64],
    rest: f64,
    magnitude: f64,
) -> Option<Vec<usize>> {
    let n = query.len();
    if n < 3 || !CUBABLE_SIZES.contains(&magnitude) {
        return None;
    }
    let any = [0, n / 2, n - 1];
    let mut basis = if corrects(query, any, coefficients, rest) {
        any
    } else {
        well_spread(n, |i| query.vector(i).0).filter(|basis| corrects(query, *basis, coefficients, rest))?
    };
    if !basis.is_sorted() {
        basis.sort_unstable();
    }
    Some(basis.to_vec())
}

/// Two generators that balance a rest in a plane, whose normal has only coordinates 0, 1 and −1.
///
/// With the normal n for the third vector of a basis the correction of the coefficient of a is r · (b × n) / a · (b ×
/// n), and that of n is zero.
pub(crate) fn correcting_pair(
    query: &Query<'_, 3>,
    plane: &SimplePlane,
    rest: f64,
    magnitude: f64,
) -> Option<Vec<usize>> {
    let [a, b] = plane.pair.map(|i| query.generator(i));
    let volume = sum_norm(&a) * sum_norm(&b) * sum_norm(&plane.normal);
    let determinant = dot(&a, &cross(&b, &plane.normal)).abs() - 8.0 * UNIT * volume - PRODUCT_UNDERFLOW;
    let longest = sum_norm(&a).max(sum_norm(&b)) * sum_norm(&plane.normal);
    let is_moderate = CUBABLE_SIZES.contains(&magnitude) && determinant > CUBABLE_SIZES.start * CUBABLE_SIZES.start;
    let corrects = rest * longest * LONG_SUM < (1.0 - WELL_WITHIN) * determinant;
    (is_moderate && corrects).then(|| plane.pair.to_vec())
}

/// Whether the coefficients of three generators stay within (−1, 1) when they balance a rest.
#[inline(always)]
fn corrects<Q: KernelQuery>(query: &Q, basis: [usize; 3], coefficients: &[f64], rest: f64) -> bool {
    let [(a, first), (b, second), (c, third)] =
        [query.vector(basis[0]), query.vector(basis[1]), query.vector(basis[2])];
    let normal = cross(&b, &c);
    let lengths = [first, second, third];
    let volume = lengths[0] * lengths[1] * lengths[2];
    let determinant = dot(&a, &normal).abs() - Q::determinant_error() * volume - PRODUCT_UNDERFLOW;
    // false for NaN as well
    let is_spanning = determinant > CUBABLE_SIZES.start * CUBABLE_SIZES.start * CUBABLE_SIZES.start;
    if !is_spanning {
        return false;
    }
    // |b × c|_1 is at most |b|_1 |c|_1, and no coefficient is nearer to an end than WELL_WITHIN is
    let longest = lengths[0].max(lengths[1]).max(lengths[2]);
    if rest * longest * longest * LONG_SUM < (1.0 - WELL_WITHIN) * determinant {
        return true;
    }
    let normals = [normal, cross(&c, &a), cross(&a, &b)];
    (0..3).all(|k| {
        let across = sum_norm(&normals[k]) + Q::determinant_error() * volume / lengths[k] + PRODUCT_UNDERFLOW;
        coefficients[basis[k]].abs() + rest * across / determinant * LONG_SUM < 1.0
    })
}
