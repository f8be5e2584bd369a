//! A convex function that is nowhere less than the difference of two support functions: a bound from above that tells
//! bodies which are nearly equal.
//!
//! For a generator b of the farther body and the nearer generators v that are given to it, |u · b| is at most the sum
//! of |u · r| and all |u · v|, with r = b − Σ ± v, so the difference is at most Σ |u · r|. Every nearer generator goes
//! to the farther one whose direction is nearest to its own. Where each b is nearly the sum of its own, this is nearly
//! the difference itself.
//!
//! What is left is far smaller than the generators then, and rounding them would hide it: it is summed exactly, and
//! rounded once, to doubles of its own size. O(n k) products and O(n) exact sums.

use std::array;

use super::exact_difference::ExactDifference;
use crate::numeric::dyadic::Dyadic;
use crate::numeric::linear::dot;

/// The generators r of the bound for one side, as a body without another.
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
