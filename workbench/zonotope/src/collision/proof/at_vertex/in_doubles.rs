//! The proof of a location by the facet that two generators span, of which nothing is known beforehand.
//!
//! Let u = ± v_a × v_b with u · p > 0, and s_i the sign of v_i · u. If u · p > Σ |v_i · u|, then u separates, whatever
//! the two generators are. If not, and the ray along p leaves the body through the facet of the two, the coefficients
//! f s_i with f = u · p / Σ |v_i · u| combine to p but for what the two of the facet and a third make up for. Both
//! proofs stand by themselves. So a search need not certify that its vertex is the optimum before a location is proved
//! from it, which takes longer than the proof: where the vertex is not the optimum, or rounding leaves a doubt,
//! there is no answer.
//!
//! Every bound is in terms of coordinates and not of lengths: a body that is thin along an axis is as good as another.

use fearless_simd::{Simd, dispatch};

use super::contact::touching;
use super::in_pairs::location_in_pairs;
use crate::collision::proof::sign_rule;
use crate::collision::proof::vectors::{SumErrors, Vectors, first_of_largest, minus};
use crate::lad::of_generators::guess::facet_coefficients::facet_coefficients;
use crate::lad::of_generators::guess::near_rows::NearRows;
use crate::lad::of_generators::seam::kernel_query::KernelQuery;
use crate::lad::of_generators::seam::part::Part;
use crate::numeric::bounded::{self, Bounded, BoundedVector};
use crate::numeric::lanes::level::level;
use crate::numeric::lanes::number::{Number, Units, product};
use crate::numeric::lanes::octet::{splat, total, totals};
use crate::numeric::lanes::rows::Rows;
use crate::numeric::linear::{cross, dot, max_norm, sum_norm};
use crate::numeric::reused::Reused;
use crate::numeric::tolerance::{FACET_ROUNDING, LONG_SUM, PRODUCT_UNDERFLOW, UNIT};
use crate::tally::Rung;
use crate::zonotope::location::{Coefficients, Proof, SignRule, Witness};

/// The number of generators that are looked at for the third of a basis where the two of the facet make up for
/// everything in its plane.
const THIRD_CANDIDATES: usize = 8;

/// Generators shorter than this part of the mean length are short.
const SHORT_PAIR: f64 = 0.125;

/// The number of roundings by which the gauge of a point on the boundary may seem to differ from 1.
const LIKELY_CONTACT: f64 = 8.0;

/// Sums over generators with the signs of their products with a direction, in lanes or not.
struct Signed<T> {
    /// Σ s v.
    sum: [T; 3],
    /// Σ |v · u|.
    reach: T,
    /// Σ |v|, coordinate by coordinate.
    sizes: [T; 3],
}

impl<T: Number> Signed<T> {
    #[inline(always)]
    fn new(units: &Units<T>) -> Self {
        Self { sum: [units.zero; 3], reach: units.zero, sizes: [units.zero; 3] }
    }

    /// Takes generators in.
    #[inline(always)]
    fn read(&mut self, units: &Units<T>, v: &[T; 3], u: &[T; 3]) {
        let along = product(v, u);
        let sign = units.one.signed_as(along);
        self.reach += along.magnitude();
        for ((sum, size), c) in self.sum.iter_mut().zip(&mut self.sizes).zip(v) {
            *sum += sign * *c;
            *size += c.magnitude();
        }
    }
}

/// The sums over all generators.
struct Sums {
    /// Σ s v.
    sum: [f64; 3],
    /// Σ |v · u|.
    reach: f64,
    /// At least Σ |v|, coordinate by coordinate.
    sizes: [f64; 3],
    /// Σ |v| · |u|, and what stands for it where u is rounded as it is pulled back into a frame.
    terms: f64,
}

impl Sums {
    /// The sums. At rest one pass takes both runs.
    #[inline]
    fn of(parts: &[Part<'_>; 2], u: &[f64; 3]) -> Self {
        let [first, second] = parts;
        if first.frame.is_none() && second.frame.is_none() {
            return Self::of_rows([first.rows, second.rows], u);
        }
        let (own, others) = (Self::of_part(first, u), Self::of_part(second, u));
        let both = |a: [f64; 3], b: [f64; 3]| [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
        Self {
            sum: both(own.sum, others.sum),
            reach: own.reach + others.reach,
            sizes: both(own.sizes, others.sizes),
            terms: own.terms + others.terms,
        }
    }

    fn of_part(part: &Part<'_>, u: &[f64; 3]) -> Self {
        let runs = [part.rows, Rows::NONE];
        let Some(frame) = part.frame else { return Self::of_rows(runs, u) };
        let rows = Self::of_rows(runs, &frame.pulled(u));
        Self {
            sum: frame.image(&rows.sum),
            reach: rows.reach,
            sizes: part.image_of_sizes(&rows.sizes),
            terms: rows.terms + sum_norm(&rows.sizes) * frame.pulled_size(u),
        }
    }

    #[inline(always)]
    fn of_rows(runs: [Rows<'_>; 2], u: &[f64; 3]) -> Self {
        let Signed { sum, reach, sizes } = dispatch!(level(), simd => signed(simd, runs, u));
        Self { sum, reach, sizes, terms: dot(&sizes, &u.map(f64::abs)) }
    }
}

/// The sums over rows.
#[inline(always)]
fn signed<S: Simd>(simd: S, runs: [Rows<'_>; 2], u: &[f64; 3]) -> Signed<f64> {
    let (wide, units) = (splat(simd, u), Units::wide(simd));
    let (mut lanes, mut few) = (Signed::new(&units), Signed::new(&Units::SINGLE));
    for run in runs {
        let (octets, rest) = run.octets().whole_and_rest();
        for k in 0..octets.len() {
            lanes.read(&units, &octets.load(simd, k), &wide);
        }
        for v in rest {
            few.read(&Units::SINGLE, v, u);
        }
    }
    let (sum, sizes) = (totals(&lanes.sum), totals(&lanes.sizes));
    Signed {
        sum: [sum[0] + few.sum[0], sum[1] + few.sum[1], sum[2] + few.sum[2]],
        reach: total(lanes.reach) + few.reach,
        sizes: [sizes[0] + few.sizes[0], sizes[1] + few.sizes[1], sizes[2] + few.sizes[2]],
    }
}

/// The location of p, with its proof, if the facet of two generators decides it. O(n).
///
/// Of generators under a matrix, a sum is carried over in one more product, and each generator that is taken off it is
/// rounded: fifteen roundings of each term more, for which the count of additions has room, as eight lanes add side by
/// side.
pub(crate) fn location_by_pair(query: &dyn KernelQuery, p: &BoundedVector, pair: [usize; 2]) -> Option<Proof> {
    let vectors = Vectors::of(query)?;
    let n = vectors.len();
    let [a, b] = pair.map(|i| vectors.value(i));
    let (product, own) = (cross(&a, &b), [p[0].value, p[1].value, p[2].value]);
    let reversed = dot(&product, &own) < 0.0;
    let u = if reversed { [-product[0], -product[1], -product[2]] } else { product };
    let sums = Sums::of(&vectors.parts, &u);
    // a term of the pass goes through at most n / 2 + 16 additions, and a product of two vectors through three
    // roundings more
    let roundings = UNIT * (n / 2 + 16) as f64;
    let error = (roundings * sums.reach + 4.0 * UNIT * sums.terms) * LONG_SUM + n as f64 * PRODUCT_UNDERFLOW;
    let (along, reach) = (dot(p, &bounded::exact(u)), Bounded { value: sums.reach, error });
    if (along - reach).is_positive() {
        return Some(Proof::outside(u, Rung::RoundedDirection));
    }
    let factor = along.value / sums.reach;
    if !factor.is_finite() {
        return None;
    }
    let is_below = (reach - along).is_positive();
    let errors = SumErrors { p, sizes: [0, 1, 2].map(|k| sums.sizes[k] + own[k].abs()), count: n };
    let facet = Facet { vectors: &vectors, p: own, pair, u, sum: sums.sum, factor, errors: &errors };
    if is_below {
        let proof = facet.combined_by_pair();
        if proof.is_some() || facet.is_elsewhere(query) {
            return proof;
        }
    }
    let mut signs = Reused::with_capacity(n);
    sign_rule::write(&vectors.parts, &u, 1.0, &mut signs);
    if is_below && let Some(proof) = facet.combined_by_shares(&mut signs) {
        return Some(proof);
    }
    let exactly = |signs: &mut [f64]| touching(query, &vectors, pair, &u, reversed, signs, &errors);
    let in_pairs = |signs: &[f64]| location_in_pairs(query, &vectors, pair, &u, reversed, signs);
    if (along.value - reach.value).abs() < LIKELY_CONTACT * UNIT * sums.reach {
        exactly(&mut signs).or_else(|| in_pairs(&signs))
    } else {
        in_pairs(&signs).or_else(|| exactly(&mut signs))
    }
}

/// A facet that p may be below, with the sum of all generators with their signs.
struct Facet<'a> {
    vectors: &'a Vectors<'a>,
    p: [f64; 3],
    pair: [usize; 2],
    u: [f64; 3],
    sum: [f64; 3],
    /// The factor of the generators that are not in the basis.
    factor: f64,
    /// The error of what is left for the basis.
    errors: &'a SumErrors<'a>,
}

impl Facet<'_> {
    /// The proof in which the two of the facet make up for everything in its plane.
    #[inline]
    fn combined_by_pair(&self) -> Option<Proof> {
        let third = self.third(THIRD_CANDIDATES)?;
        let [a, b] = self.pair;
        let sign = |i| sign_rule::sign(&self.vectors.parts, &self.u, i);
        let left = self.without([a, b, third].into_iter(), sign);
        let own = self.own(third, left, &self.errors.after(0))?;
        let rule = SignRule { direction: self.u, factor: self.factor, basis: [a, b, third], own };
        Some(Proof::inside(Coefficients::BySigns(rule), Rung::RoundedCoefficients))
    }

    /// Whether the ray certainly leaves the body through another facet: no other generator is in the plane of the two,
    /// and they cannot make up for what is in it. Two short generators say nothing, as three long ones may make up for
    /// them.
    fn is_elsewhere(&self, query: &dyn KernelQuery) -> bool {
        let least = SHORT_PAIR * sum_norm(&self.errors.sizes) / self.vectors.len() as f64;
        if self.pair.iter().any(|&i| sum_norm(&self.vectors.value(i)) < least) {
            return false;
        }
        let Some(third) = self.third(THIRD_CANDIDATES) else { return false };
        let [a, b] = self.pair;
        let left = self.without([a, b, third].into_iter(), |i| sign_rule::sign(&self.vectors.parts, &self.u, i));
        let rest = [0, 1, 2].map(|k| self.p[k] - self.factor * left[k]);
        self.vectors.are_beyond([a, b, third], &rest, &self.errors.after(0))
            && NearRows::of(query, &self.u, 2.0 * FACET_ROUNDING * max_norm(&self.u)).indices.len() <= self.pair.len()
    }

    /// The proof in which all generators of the facet share what is to be made up for in its plane.
    fn combined_by_shares(&self, signs: &mut [f64]) -> Option<Proof> {
        let [a, b] = self.pair.map(|i| self.vectors.value(i));
        let terms = |v: &[f64; 3]| (v[0] * self.u[0]).abs() + (v[1] * self.u[1]).abs() + (v[2] * self.u[2]).abs();
        let of_facet = |v: &[f64; 3]| dot(v, &self.u).abs() <= FACET_ROUNDING * terms(v);
        let members: Reused<usize> = (0..self.vectors.len()).filter(|&i| of_facet(&self.vectors.value(i))).collect();
        if members.len() <= self.pair.len() || self.pair.iter().any(|i| !members.contains(i)) {
            return None;
        }
        let left = self.without(members.iter().copied(), |i| signs[i]);
        let duals = [cross(&b, &self.p), cross(&self.p, &a)];
        let own = [dot(&a, &duals[0]), dot(&b, &duals[1])];
        let plane = |v: &[f64; 3]| [dot(v, &duals[0]) / own[0], dot(v, &duals[1]) / own[1]];
        let in_plane: Reused<[f64; 2]> = members.iter().map(|&i| plane(&self.vectors.value(i))).collect();
        let shares = facet_coefficients(&in_plane, plane(&left).map(|c| -c)).ok()?;
        let third = self.third(self.vectors.len()).filter(|third| !members.contains(third))?;
        let mut left = minus(left, signs[third], &self.vectors.value(third));
        for (&i, &share) in members.iter().zip(&shares) {
            signs[i] = share;
            if !self.pair.contains(&i) {
                left = minus(left, -share, &self.vectors.value(i));
            }
        }
        let own = self.own(third, left, &self.errors.after(2 * members.len()))?;
        let coefficients = signs.iter().map(|share| self.factor * share).collect();
        let witness = Witness::with_basis(coefficients, [self.pair[0], self.pair[1], third], own);
        Some(Proof::inside(witness, Rung::RoundedCoefficients))
    }

    /// The generator that is farthest from the facet's plane among some candidates.
    #[inline]
    fn third(&self, candidates: usize) -> Option<usize> {
        let n = self.vectors.len();
        let places = (0..n).step_by(n.div_ceil(candidates)).filter(|i| !self.pair.contains(i));
        first_of_largest(places.map(|i| (dot(&self.vectors.value(i), &self.u).abs(), i)))
    }

    /// The signed sum without some generators.
    #[inline]
    fn without(&self, generators: impl Iterator<Item = usize>, sign: impl Fn(usize) -> f64) -> [f64; 3] {
        generators.fold(self.sum, |sum, i| minus(sum, sign(i), &self.vectors.value(i)))
    }

    /// The coefficients of the two of the facet and a third generator, if they are in (−1, 1), where `left` is the sum
    /// of all generators off the basis with their signs or shares, off by at most `errors`.
    #[inline]
    fn own(&self, third: usize, left: [f64; 3], errors: &[f64; 3]) -> Option<[f64; 3]> {
        let basis = [self.pair[0], self.pair[1], third];
        let rest = [0, 1, 2].map(|k| self.p[k] - self.factor * left[k]);
        let own = self.vectors.coefficients(basis, &rest, errors)?;
        let [Some(first), Some(second), Some(last)] = own else { return None };
        Some([first, second, last])
    }
}

#[cfg(test)]
mod tests;
