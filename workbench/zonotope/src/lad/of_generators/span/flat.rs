//! The plane of a flat body, found exactly, so that a coordinate can be dropped.
//!
//! If all generators and the displacement are orthogonal to n and n_k is not zero, the coordinate k holds no
//! information: the body in the other two coordinates has the same gauge, coefficients that combine to the
//! displacement in one combine to it in the other, and a direction that separates in the other two coordinates
//! separates in space with 0 for the coordinate k.

use fearless_simd::{Simd, dispatch, f64x8, prelude::*};

use crate::numeric::exact_linear::{self, ExactVector, dot, exact, is_zero};
use crate::numeric::lanes::level::level;
use crate::numeric::lanes::number::Number;
use crate::numeric::lanes::octet::{LANES, splat, total};
use crate::numeric::lanes::octets::Octets;
use crate::numeric::linear::{cross, max_norm};
use crate::zonotope::query::Query;

/// The number of generators among which the plane is looked for first.
const PLANE_SAMPLE: usize = 64;

/// The number of generators among which a simple plane is looked for.
const SIMPLE_PLANE_SAMPLE: usize = 16;

/// A plane through the origin that holds all generators and both points, and whose normal has only coordinates 0, 1
/// and −1.
pub(crate) struct SimplePlane {
    pub(crate) normal: [f64; 3],
    /// Two generators that span the plane, the first before the second.
    pub(crate) pair: [usize; 2],
}

impl SimplePlane {
    /// The plane, if there is one; found from a few generators and checked with all. O(n).
    pub(crate) fn of(query: &Query<'_, 3>) -> Option<Self> {
        let step = query.len().div_ceil(SIMPLE_PLANE_SAMPLE).max(1);
        let best = |key: &dyn Fn(&[f64; 3]) -> f64| {
            let mut best = (0.0, 0);
            for i in (0..query.len()).step_by(step) {
                let own = key(&query.generator(i));
                if own > best.0 {
                    best = (own, i);
                }
            }
            (best.0 > 0.0).then_some(best.1)
        };
        let first = best(&|v| max_norm(v))?;
        let a = query.generator(first);
        let second = best(&|v| max_norm(&cross(&a, v)))?;
        let normal = cross(&a, &query.generator(second));
        let half = max_norm(&normal) / 2.0;
        let simple = normal.map(|c| f64::from(i8::from(c > half) - i8::from(c < -half)));
        let points = [query.from(), query.to()];
        let [own, others] = query.runs();
        // products beyond the range of doubles leave nothing of the normal
        let is_flat = max_norm(&simple) > 0.0
            && is_orthogonal_to_all(&points, &simple)
            && is_orthogonal_to_all(own, &simple)
            && is_orthogonal_to_all(others, &simple);
        is_flat.then(|| Self { normal: simple, pair: [first.min(second), first.max(second)] })
    }

    /// The vector with 0 for the dropped coordinate whose products with vectors of the plane are those of y.
    pub(crate) fn projected(&self, y: &[f64; 3]) -> [f64; 3] {
        let axis = self.axis();
        // a coordinate of the normal is its own inverse, or zero
        let factor = y[axis] * self.normal[axis];
        [0, 1, 2].map(|k| if k == axis { 0.0 } else { y[k] - factor * self.normal[k] })
    }

    /// A coordinate that can be dropped.
    pub(crate) fn axis(&self) -> usize {
        self.normal.iter().rposition(|c| *c != 0.0).unwrap_or(0)
    }
}

/// Whether all products with a vector of zeros and ones are zero, exactly.
fn is_orthogonal_to_all(vectors: &[[f64; 3]], simple: &[f64; 3]) -> bool {
    if vectors.len() <= LANES {
        return vectors.iter().all(|v| off_the_plane(v, simple) == 0.0);
    }
    dispatch!(level(), simd => all_off_the_plane(simd, vectors, simple)) == 0.0
}

/// The sum of what all vectors have [off the plane](off_the_plane).
#[inline(always)]
fn all_off_the_plane<S: Simd>(simd: S, vectors: &[[f64; 3]], simple: &[f64; 3]) -> f64 {
    let (wide, octets) = (splat(simd, simple), Octets::new(vectors, &[]));
    let mut off = f64x8::splat(simd, 0.0);
    for k in 0..octets.len() {
        off += off_the_plane(&octets.load(simd, k), &wide);
    }
    total(off)
}

/// A magnitude that is zero if and only if the product of a vector with one of zeros and ones is.
#[inline(always)]
fn off_the_plane<T: Number>(v: &[T; 3], simple: &[T; 3]) -> T {
    let [a, b, c] = [v[0] * simple[0], v[1] * simple[1], v[2] * simple[2]];
    // a + b + c is zero only if the rounded a + b is −c and a + b is not rounded
    let sum = a + b;
    let b_in_sum = sum - a;
    let rest = (a - (sum - b_in_sum)) + (b - b_in_sum);
    rest.magnitude() + (sum + c).magnitude()
}

/// A coordinate that can be dropped, being not zero in the normal of a plane through the origin that holds all
/// generators and p.
pub(crate) fn spare_axis(query: &Query<'_, 3>, p: &ExactVector) -> Option<usize> {
    // a simple plane is found and checked in doubles, in a twentieth of the time
    if let Some(plane) = SimplePlane::of(query) {
        return Some(plane.axis());
    }
    let normal = normal(query, p)?;
    let axis = (0..3).max_by_key(|&k| normal[k].clone().abs())?;
    let ratios = [0, 1, 2].map(|k| normal[k].rounded_ratio(&normal[axis]));
    let is_simple =
        ratios.iter().all(|r| [-1.0, 0.0, 1.0].contains(r)) && is_zero(&exact_linear::cross(&exact(ratios), &normal));
    let is_flat = if is_simple {
        query.runs().iter().all(|run| is_orthogonal_to_all(run, &ratios))
    } else {
        query.generators().all(|v| is_orthogonal(v, &ratios) && dot(&exact(*v), &normal).is_zero())
    };
    is_flat.then_some(axis)
}

/// A normal of the plane of p and two generators that seem to span it, if p is in it.
fn normal(query: &Query<'_, 3>, p: &ExactVector) -> Option<ExactVector> {
    let few = || query.generators().step_by(query.len().div_ceil(PLANE_SAMPLE).max(1));
    let first = longest(few(), max_norm).or_else(|| longest(query.generators(), max_norm))?;
    let scaled = first.map(|c| c / max_norm(&first));
    let off = |v: &[f64; 3]| max_norm(&cross(&scaled, v));
    let second = longest(few(), off).or_else(|| longest(query.generators(), off));
    let normal = exact_linear::cross(&exact(first), &second.map_or_else(|| p.clone(), exact));
    (!is_zero(&normal) && dot(&normal, p).is_zero()).then_some(normal)
}

/// The vector with the largest key, if that is positive.
fn longest<'a>(vectors: impl Iterator<Item = &'a [f64; 3]>, key: impl Fn(&[f64; 3]) -> f64) -> Option<[f64; 3]> {
    let keyed = vectors.map(|v| (key(v), v)).filter(|(key, _)| *key > 0.0 && key.is_finite());
    keyed.reduce(|best, own| if own.0 > best.0 { own } else { best }).map(|(_, v)| *v)
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
        spare_axis(&Query::new([0.0; 3], p, generators).expect("finite"), &exact(p))
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
