//! The proof of a member in doubles, from a vertex that doubles proved.
//!
//! All generators have ±c, c near 1 / λ, but for three that balance the rest: the two of the vertex and a third, off
//! the facet's plane. Where the point is at an edge of its facet, the coefficients of the two are at the ends of
//! their range. Then the third generator is one that moves both inwards as its own coefficient leaves its end, which
//! it may do as far as c can grow towards 1.
//!
//! The signs that cells fixed are those of products with the direction of the vertex where that is in all of these
//! cells, and then the proof has constant size.

use crate::collision::proof::balance::well_spread::well_spread;
use crate::collision::{SignRule, Witness};
use crate::lad::of_generators::cells::nested::NestedCells;
use crate::lad::of_generators::certify::rounded_optimum::RoundedOptimum;
use crate::lad::of_generators::seam::kernel_query::KernelQuery;
use crate::numeric::bounded::{Bounded, BoundedVector, approximate, cross, exact};
use crate::numeric::linear::{cyclic_cross_products, dot, max_norm};
use crate::numeric::scaling::{binary_exponent, scale_by_power_of_two};
use crate::numeric::tolerance::UNIT;
use crate::tally::Rung;
use crate::zonotope::location::Coefficients;

/// The number of generators that are tried as the third.
const THIRD_CANDIDATES: usize = 32;

/// A margin of this part of 1 − 1 / λ is good enough to stop looking for a better third generator.
const MARGIN_SHARE: f64 = 0.25;

/// The part of its range by which the third generator moves away from its end.
const THIRD_ROOM: f64 = 0.5;

/// A generator that may be the third, with what its coefficient is computed from.
#[derive(Debug, Clone, Copy)]
struct Third {
    index: usize,
    vector: [f64; 3],
    sign: f64,
    /// The cross products of the three generators, in which coefficients are read off.
    normals: [[f64; 3]; 3],
    /// 1 over the determinant of the three; infinite where the third is in the plane of the others.
    inverse: f64,
}

/// Three generators and the factor of all others.
#[derive(Debug, Clone, Copy)]
struct Attempt {
    third: usize,
    sign: f64,
    factor: f64,
    /// The distance of the largest of the three coefficients from 1, nearly.
    margin: f64,
}

impl Third {
    fn new(optimum: &RoundedOptimum, index: usize, vector: [f64; 3], sign: f64) -> Self {
        let [a, b] = &optimum.vectors;
        let normals = cyclic_cross_products(a, b, &vector);
        Self { index, vector, sign, normals, inverse: 1.0 / dot(&vector, &normals[2]) }
    }

    /// The attempt with a factor, and its margin.
    fn attempt(&self, optimum: &RoundedOptimum, p: &BoundedVector, factor: f64) -> Attempt {
        let rest = |k: usize| p[k].value - (optimum.sum[k].value - self.sign * self.vector[k]) * factor;
        let rest = [rest(0), rest(1), rest(2)];
        let size = |k: usize| (dot(&rest, &self.normals[k]) * self.inverse).abs();
        let largest = size(0).max(size(1)).max(size(2));
        // none where the third is in the plane of the others
        let margin = if self.inverse.is_finite() { 1.0 - largest } else { 0.0 };
        Attempt { third: self.index, sign: self.sign, factor, margin }
    }
}

/// The proof of a member whose gauge is less than 1.
pub(crate) fn witness(
    query: &dyn KernelQuery,
    optimum: &RoundedOptimum,
    cells: &NestedCells,
    p: &BoundedVector,
) -> Option<(Coefficients, Rung)> {
    let inverse = (optimum.along.value / optimum.reach.value).min(1.0);
    let n = query.len();
    let last = optimum.cell();
    let is_shared = |i: &usize| optimum.shares.binary_search_by_key(i, |(index, _)| *index).is_ok();
    let picks =
        (0..n).step_by(n.div_ceil(THIRD_CANDIDATES).max(1)).filter(|i| !optimum.basis.contains(i) && !is_shared(i));
    // far enough from the ends: no other pick is much better, unless rounding forbids this one
    let mut enough = MARGIN_SHARE * (1.0 - inverse);
    let mut best = Attempt { third: 0, sign: 0.0, factor: 0.0, margin: 0.0 };
    for index in picks {
        let third = Third::new(optimum, index, query.generator(index), cells.sign(query, &last, index));
        let height = third.sign * dot(&third.vector, &optimum.direction.map(|c| c.value)) / optimum.reach.value;
        let moved = (inverse * (1.0 + THIRD_ROOM * height)).min(1.0);
        for factor in [moved, inverse, 1.0] {
            let own = third.attempt(optimum, p, factor);
            if own.margin > best.margin {
                best = own;
            }
        }
        if best.margin > enough && enough > 0.0 {
            if let Some(found) = prove(query, optimum, cells, p, best) {
                return Some((found, Rung::RoundedCoefficients));
            }
            enough = 0.0;
        }
    }
    let proved = if best.margin > 0.0 { prove(query, optimum, cells, p, best) } else { None };
    match proved {
        Some(coefficients) => Some((coefficients, Rung::RoundedCoefficients)),
        None => Some((prove_by_others(query, optimum, cells, p, inverse)?.into(), Rung::WellSpreadBasis)),
    }
}

/// The proof by an attempt, if rounding leaves no doubt of it.
fn prove(
    query: &dyn KernelQuery,
    optimum: &RoundedOptimum,
    cells: &NestedCells,
    p: &BoundedVector,
    attempt: Attempt,
) -> Option<Coefficients> {
    let Attempt { third, sign, factor, .. } = attempt;
    let [a, b] = optimum.bounded_vectors();
    let c = approximate(query.generator(third), query.relative_error());
    // the coefficients of those that share are rounded
    let rounded = Bounded { value: 0.0, error: 2.0 * (UNIT * optimum.shared + f64::MIN_POSITIVE) };
    let (sign, share) = (Bounded::exact(sign), Bounded::exact(factor));
    let rest = |k: usize| p[k] - (optimum.sum[k] - c[k] * sign) * share + rounded;
    let own = solve(&[a, b, c], &[rest(0), rest(1), rest(2)])?;
    let basis = [optimum.basis[0], optimum.basis[1], third];
    if let Some(direction) = direction_of_signs(query, optimum, cells, p) {
        return Some(Coefficients::BySigns(SignRule { direction, factor, basis, own }));
    }
    let mut coefficients = cells.coefficients(query, &optimum.cell(), factor);
    for &(index, share) in &optimum.shares {
        coefficients[index] = share * factor;
    }
    Some(Witness::with_basis(coefficients, basis, own).into())
}

/// A direction whose products with the generators have the signs that the cells and the vertex gave them, if that is
/// certain; its largest coordinate is about 1, so that no product with a generator that was fixed underflows.
fn direction_of_signs(
    query: &dyn KernelQuery,
    optimum: &RoundedOptimum,
    cells: &NestedCells,
    p: &BoundedVector,
) -> Option<[f64; 3]> {
    let direction = optimum.direction.map(|c| c.value);
    let exponent = binary_exponent(max_norm(&direction))?;
    let direction = direction.map(|c| scale_by_power_of_two(c, -i64::from(exponent)));
    let bounded = exact(direction);
    let is_in_all = || cells.steps().iter().all(|step| step.cell.contains(&bounded, p));
    (query.has_signs_of_products() && optimum.shares.is_empty() && is_in_all()).then_some(direction)
}

/// The proof where the two of the vertex are nearly parallel: three others, well spread, make up for the rest.
fn prove_by_others(
    query: &dyn KernelQuery,
    optimum: &RoundedOptimum,
    cells: &NestedCells,
    p: &BoundedVector,
    factor: f64,
) -> Option<Witness> {
    let basis = well_spread(query.len(), |i| query.generator(i))?;
    let is_other = |i: &usize| !optimum.basis.contains(i) && optimum.shares.iter().all(|(index, _)| index != i);
    basis.iter().all(is_other).then_some(())?;
    let signs = basis.map(|i| cells.sign(query, &optimum.cell(), i));
    let vectors = basis.map(|i| approximate(query.generator(i), query.relative_error()));
    let pair = optimum.bounded_vectors();
    let parts = optimum.rest.coefficients;
    // the coefficients of those that share, and of the two of the vertex, are rounded
    let size = optimum.shared + optimum.vectors.as_flattened().iter().map(|c| c.abs()).sum::<f64>();
    let rounded = Bounded { value: 0.0, error: 2.0 * (UNIT * size + f64::MIN_POSITIVE) };
    let rest = [0, 1, 2].map(|k| {
        let ends = pair[0][k] * Bounded::exact(parts[0]) + pair[1][k] * Bounded::exact(parts[1]);
        let own = (0..3).map(|i| vectors[i][k] * Bounded::exact(-signs[i]));
        let off = own.fold(optimum.sum[k] + ends, |sum, term| sum + term);
        p[k] - off * Bounded::exact(factor) + rounded
    });
    let own = solve(&vectors, &rest)?;
    let mut coefficients = cells.coefficients(query, &optimum.cell(), factor);
    let shares = optimum.shares.iter().copied().chain(optimum.basis.into_iter().zip(parts));
    for (index, share) in shares {
        coefficients[index] = share * factor;
    }
    Some(Witness::with_basis(coefficients, basis, own))
}

/// The coefficients of three vectors that make up what is left, if all are certainly within (−1, 1).
fn solve([a, b, c]: &[BoundedVector; 3], rest: &BoundedVector) -> Option<[f64; 3]> {
    let normals = [cross(b, c), cross(c, a), cross(a, b)];
    let determinant = dot(c, &normals[2]);
    let negative = determinant.sign()? < 0;
    let determinant = if negative { determinant.negated() } else { determinant };
    // three of each written out: the question about a box is half as long as a call for each of them
    let [first, second, third] = [dot(rest, &normals[0]), dot(rest, &normals[1]), dot(rest, &normals[2])];
    let is_within = first.is_within(determinant) && second.is_within(determinant) && third.is_within(determinant);
    let scale = if negative { -determinant.value } else { determinant.value };
    is_within.then_some([first.value / scale, second.value / scale, third.value / scale])
}

#[cfg(test)]
mod tests;
