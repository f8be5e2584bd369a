//! The difference of the support functions of two centred zonotopes, in coordinates of ordinary size.

use std::array;

use super::exact_difference::ExactDifference;
use crate::numeric::dyadic::Dyadic;
use crate::numeric::lanes::Extents;
use crate::numeric::linear::dot;
use crate::numeric::scaling::PowerOfTwo;
use crate::numeric::tolerance::{LONG_SUM, PRODUCT_UNDERFLOW, UNIT};

/// Roundings of a sum beside one for each term: products, signs, the ends of sums, in up to ten dimensions.
const FURTHER_ADDITIONS: f64 = 64.0;

/// A bound for the rounding errors of a sum by its terms.
#[derive(Debug, Clone, Copy)]
pub(super) struct Rounding {
    /// u times the sum of all |v|_1.
    of_addition: f64,
    /// What is far smaller than the largest generator may be lost to underflow.
    underflow: f64,
}

impl Rounding {
    /// For the difference of two sums of ± u · v along a direction with |u_k| ≤ 1, divided by |u|, over all generators,
    /// all but a number of which come as one vector, summed to twice the digits of a double.
    ///
    /// Each addition of a single term is off by u times the sum of all |v|_1; so are, at most, the products of D terms,
    /// all together and D times, what the sign of a product near 0 costs, the displacement that was rounded before, and
    /// the sums in pairs.
    pub(super) fn of_terms(&self, terms: usize) -> f64 {
        self.of_addition * (terms as f64 + FURTHER_ADDITIONS) + self.underflow
    }
}

/// u ↦ Σ |u · a| − Σ |u · b|.
#[derive(Debug, Clone)]
pub(super) struct Difference<const D: usize> {
    /// The generators that count for it.
    pub(super) farther: Vec<[f64; D]>,
    /// Those that count against it.
    pub(super) nearer: Vec<[f64; D]>,
}

/// Two bodies times one power of two, so that the largest coordinate is about 1.
pub(super) struct ScaledBodies<const D: usize> {
    generators: [Vec<[f64; D]>; 2],
    displacement: [f64; D],
    exponent: i64,
}

impl<const D: usize> ScaledBodies<D> {
    pub(super) fn new(difference: &ExactDifference<D>) -> Self {
        let exponent = -difference.binary_exponent().unwrap_or(0);
        let rounded = |v: &[Dyadic; D]| v.each_ref().map(|c| c.clone().scaled(exponent).to_f64());
        let generators = difference.generators.each_ref().map(|list| list.iter().map(rounded).collect());
        Self { generators, displacement: rounded(&difference.displacement), exponent }
    }

    /// h_A − h_B for even and h_B − h_A for odd `side`, with the displacement among the farther generators.
    pub(super) fn difference(&self, side: usize) -> Difference<D> {
        let mut farther = self.generators[side].clone();
        if self.displacement != [0.0; D] {
            farther.push(self.displacement);
        }
        Difference { farther, nearer: self.generators[1 - side].clone() }
    }

    /// A length in the units of the input in those of the doubles, not below it.
    pub(super) fn scaled_above(&self, length: f64) -> f64 {
        let value = PowerOfTwo::new(self.exponent).apply(length);
        if value < f64::MIN_POSITIVE && length > 0.0 { value.next_up() } else { value }
    }

    /// A length in the units of the input, not above it.
    pub(super) fn unscaled_below(&self, length: f64) -> f64 {
        let value = PowerOfTwo::new(-self.exponent).apply(length);
        if value < f64::MIN_POSITIVE { value.next_down().max(0.0) } else { value.min(f64::MAX) }
    }

    /// A length in the units of the input, not below it.
    pub(super) fn unscaled_above(&self, length: f64) -> f64 {
        let value = PowerOfTwo::new(-self.exponent).apply(length);
        if value < f64::MIN_POSITIVE && length > 0.0 { value.next_up() } else { value }
    }
}

impl<const D: usize> Difference<D> {
    /// What bounds the rounding errors of sums of products ± u · v over the generators.
    pub(super) fn rounding(&self) -> Rounding {
        let count = (self.farther.len() + self.nearer.len()) as f64;
        let magnitude: f64 = [&self.farther, &self.nearer].iter().flat_map(|list| Extents::new(list).sums()).sum();
        Rounding { of_addition: UNIT * magnitude * LONG_SUM, underflow: count * PRODUCT_UNDERFLOW }
    }

    /// Whether nothing is left of it.
    pub(super) fn is_zero(&self) -> bool {
        self.farther.is_empty() && self.nearer.is_empty()
    }
}

/// The generators of a convex function that is nowhere less than the difference for one side, as a body without
/// another: a bound from above that tells bodies which are nearly equal.
///
/// For a generator b of the farther body and the nearer generators v that are given to it, |u · b| is at most the sum
/// of |u · r| and all |u · v|, with r = b − Σ ± v, so the difference is at most Σ |u · r|. Every nearer generator goes
/// to the farther one whose direction is nearest to its own. Where each b is nearly the sum of its own, this is nearly
/// the difference itself. What is left is far smaller than the generators then, and rounding them would hide it: it is
/// summed exactly, to be rounded once. O(n k) products and O(n) exact sums.
pub(super) fn convex_bound<const D: usize>(exact: &ExactDifference<D>, side: usize) -> ExactDifference<D> {
    let exponent = -exact.binary_exponent().unwrap_or(0);
    let rounded = |v: &[Dyadic; D]| v.each_ref().map(|c| c.clone().scaled(exponent).to_f64());
    let mut left = exact.generators[side].clone();
    left.push(exact.displacement.clone());
    let unit = |b: &[Dyadic; D]| {
        let b = rounded(b);
        let length = dot(&b, &b).sqrt();
        b.map(|c| if length > 0.0 { c / length } else { 0.0 })
    };
    let units: Vec<[f64; D]> = left.iter().map(unit).collect();
    for v in &exact.generators[1 - side] {
        let (along, mut nearest, mut product) = (rounded(v), None, 0.0f64);
        for (index, u) in units.iter().enumerate() {
            let cosine = dot(u, &along);
            if cosine.abs() > product.abs() {
                (nearest, product) = (Some(index), cosine);
            }
        }
        if let Some(index) = nearest {
            let turned = |k: usize| if product < 0.0 { v[k].clone() } else { -v[k].clone() };
            left[index] = array::from_fn(|k| &left[index][k] + &turned(k));
        }
    }
    left.retain(|r| !r.iter().all(Dyadic::is_zero));
    ExactDifference { generators: [left, Vec::new()], displacement: array::from_fn(|_| Dyadic::zero()) }
}

/// Σ |u · v| over the vectors of some indices.
pub(super) fn magnitude_sum<const D: usize>(vectors: &[[f64; D]], indices: &[u32], u: &[f64; D]) -> f64 {
    indices.iter().map(|&index| dot(&vectors[index as usize], u).abs()).sum()
}
