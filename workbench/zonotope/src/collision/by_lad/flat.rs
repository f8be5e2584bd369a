//! The plane of a flat body, found exactly, so that a coordinate can be dropped.
//!
//! Where all generators and the displacement are orthogonal to n and n_k is not zero, nothing is lost with the coordinate k: the body in the
//! other two has the same gauge, coefficients that combine to the one combine to the other, and a direction that separates the one with 0
//! for the coordinate k separates the other.

use crate::collision::Displacement;
use crate::numeric::exact_sum::exact_sum;
use crate::numeric::vector::{ExactVector, cross, dot, exact, is_zero};

/// The plane is looked for among so many generators first.
const FEW: usize = 64;

/// A coordinate that can be dropped: not zero in a normal of a plane through the origin that holds all generators and p.
pub(super) fn spare_axis(question: &Displacement<'_, 3>, p: &ExactVector) -> Option<usize> {
    let normal = normal(question, p)?;
    let axis = (0..3).max_by_key(|&k| normal[k].clone().abs())?;
    let ratios = [0, 1, 2].map(|k| normal[k].rounded_ratio(&normal[axis]));
    let is_simple = ratios.iter().all(|r| [-1.0, 0.0, 1.0].contains(r)) && is_zero(&cross(&exact(ratios), &normal));
    let is_flat = if is_simple {
        question.generators().all(|v| is_zero_sum([0, 1, 2].map(|k| v[k] * ratios[k])))
    } else {
        question.generators().all(|v| is_orthogonal(v, &ratios) && dot(&exact(*v), &normal).is_zero())
    };
    is_flat.then_some(axis)
}

/// A normal of the plane of p and two generators that seem to span it, if p is in it.
fn normal(question: &Displacement<'_, 3>, p: &ExactVector) -> Option<ExactVector> {
    let few = || question.generators().step_by(question.len().div_ceil(FEW).max(1));
    let first = longest(few(), size).or_else(|| longest(question.generators(), size))?;
    let scaled = first.map(|c| c / size(&first));
    let across = |v: &[f64; 3]| {
        let product = [
            scaled[1] * v[2] - scaled[2] * v[1],
            scaled[2] * v[0] - scaled[0] * v[2],
            scaled[0] * v[1] - scaled[1] * v[0],
        ];
        size(&product)
    };
    let second = longest(few(), across).or_else(|| longest(question.generators(), across));
    let normal = cross(&exact(first), &second.map_or_else(|| p.clone(), exact));
    (!is_zero(&normal) && dot(&normal, p).is_zero()).then_some(normal)
}

/// The vector with the largest key, if that is positive.
fn longest<'a>(vectors: impl Iterator<Item = &'a [f64; 3]>, key: impl Fn(&[f64; 3]) -> f64) -> Option<[f64; 3]> {
    let keyed = vectors.map(|v| (key(v), v)).filter(|(key, _)| *key > 0.0 && key.is_finite());
    keyed.reduce(|best, own| if own.0 > best.0 { own } else { best }).map(|(_, v)| *v)
}

fn size(v: &[f64; 3]) -> f64 {
    v.iter().fold(0.0f64, |m, c| m.max(c.abs()))
}

/// Whether three doubles sum up to zero, exactly; not where they overflow.
fn is_zero_sum([a, b, c]: [f64; 3]) -> bool {
    let (sum, rest) = exact_sum(a, b);
    // only next to −c is the sum of all as small as a rounding, and there it is exact
    let (total, left) = exact_sum(sum, c);
    left == 0.0 && total == -rest
}

/// False only if v · n is certainly not zero, where n is rounded and its largest coordinate is 1.
fn is_orthogonal(v: &[f64; 3], n: &[f64; 3]) -> bool {
    let [x, y, z] = [v[0] * n[0], v[1] * n[1], v[2] * n[2]];
    let value = (x + y + z).abs();
    value.is_nan() || value <= 8.0 * f64::EPSILON * (x.abs() + y.abs() + z.abs()) + f64::MIN_POSITIVE
}

#[cfg(test)]
mod tests {
    use super::*;

    fn axis(generators: &[[f64; 3]], p: [f64; 3]) -> Option<usize> {
        spare_axis(&Displacement::new([0.0; 3], p, generators).expect("finite"), &exact(p))
    }

    #[test]
    fn planes_are_recognised_exactly() {
        let (tiny, huge) = (f64::from_bits(1), f64::MAX);
        assert_eq!(axis(&[[1.0, 0.0, 0.0], [0.0, 2.0, 0.0]], [3.0, 4.0, 0.0]), Some(2));
        assert_eq!(axis(&[[1.0, 0.0, 0.0], [0.0, 2.0, 0.0]], [3.0, 4.0, tiny]), None);
        assert_eq!(axis(&[[0.1, 5.0, 0.1], [0.3, 2.0, 0.3], [0.0; 3]], [7.0, 1.0, 7.0]), Some(2));
        assert_eq!(axis(&[[0.1, 5.0, 0.1], [0.3, 2.0, 0.3], [1.0, 0.0, 1.0 + f64::EPSILON]], [7.0, 1.0, 7.0]), None);
        // n = (3, −2, −1): not a direction of zeros and ones
        assert_eq!(axis(&[[1.0, 1.0, 1.0], [1.0, 0.0, 3.0], [0.0, 1.0, -2.0]], [2.0, 1.0, 4.0]), Some(0));
        assert_eq!(axis(&[[1.0, 1.0, 1.0], [1.0, 0.0, 3.0], [0.0, 1.0, -2.0 + 1e-15]], [2.0, 1.0, 4.0]), None);
        assert_eq!(axis(&[[huge, huge, 0.0], [huge, 0.0, huge]], [0.0, huge, -huge]), Some(2));
        // parallel generators, and a displacement that makes up the plane
        assert_eq!(axis(&[[1.0, 1.0, 0.0]; 3], [0.0, 0.0, 1.0]), Some(1));
        assert_eq!(axis(&[[0.0; 3]; 3], [0.0, 0.0, 1.0]), None);
    }
}
