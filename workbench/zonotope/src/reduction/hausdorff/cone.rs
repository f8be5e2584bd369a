//! A cone of directions spanned by D corners, with bounds on the difference of two support functions in it.
//!
//! The corners lie on the octahedron Σ |x_k| = 1 and are cut at the middles of their edges, which are vectors of
//! doubles without rounding: so the cones that a cone is cut into cover it exactly.
//!
//! A generator whose product with all corners has one sign is linear in the cone, and its cone's descendants need not
//! look at it again: such generators are summed up, and lists hold the others. Lists become shorter by the factor by
//! which cones become narrower.

use super::difference::{Difference, magnitude_sum};
use crate::numeric::linear::{add_multiple, dot};
use crate::numeric::tolerance::THIRTY_ROUNDINGS;

/// A corner.
#[derive(Debug, Clone, Copy)]
struct Corner<const D: usize> {
    at: [f64; D],
    length: f64,
    /// The support function of the farther body.
    farther: f64,
}

/// A sum of generators: the signed sum of those that have one sign in the cone, and the indices of the others.
#[derive(Debug, Clone)]
struct Terms<const D: usize> {
    fixed: [f64; D],
    open: Vec<u32>,
}

impl<const D: usize> Terms<D> {
    fn all(count: usize) -> Self {
        Self { fixed: [0.0; D], open: (0..count as u32).collect() }
    }

    /// The terms in a smaller cone.
    fn within(&self, vectors: &[[f64; D]], corners: &[Corner<D>; D]) -> Self {
        let mut fixed = self.fixed;
        let mut open = Vec::with_capacity(self.open.len() / 2);
        for &index in &self.open {
            let v = &vectors[index as usize];
            let products = corners.each_ref().map(|corner| dot(v, &corner.at));
            if products.iter().all(|p| *p >= 0.0) {
                add_multiple(&mut fixed, 1.0, v);
            } else if products.iter().all(|p| *p <= 0.0) {
                add_multiple(&mut fixed, -1.0, v);
            } else {
                open.push(index);
            }
        }
        Self { fixed, open }
    }

    /// Σ |u · v| for a direction of the cone.
    fn value(&self, vectors: &[[f64; D]], u: &[f64; D]) -> f64 {
        dot(&self.fixed, u) + magnitude_sum(vectors, &self.open, u)
    }

    /// Σ ± v with the signs of u · v.
    fn extreme(&self, vectors: &[[f64; D]], u: &[f64; D]) -> [f64; D] {
        let mut sum = self.fixed;
        for &index in &self.open {
            let v = &vectors[index as usize];
            add_multiple(&mut sum, if dot(v, u) < 0.0 { -1.0 } else { 1.0 }, v);
        }
        sum
    }
}

/// A cone with its bounds.
#[derive(Debug, Clone)]
pub(super) struct Cone<const D: usize> {
    corners: [Corner<D>; D],
    farther: Terms<D>,
    nearer: Terms<D>,
    /// No unit vector of the cone has a greater difference.
    pub(super) upper: f64,
    /// A unit vector of the cone, up to rounding, and a bound that its difference is not below.
    pub(super) middle: [f64; D],
    pub(super) lower: f64,
}

impl<const D: usize> Cone<D> {
    /// The cones of half of the orthants, whose opposites are the others.
    pub(super) fn orthants(difference: &Difference<D>, rounding: f64) -> Vec<Self> {
        let (farther, nearer) = (Terms::all(difference.farther.len()), Terms::all(difference.nearer.len()));
        let of_signs = |signs: usize| {
            let corners = std::array::from_fn(|k| {
                let mut at = [0.0; D];
                at[k] = if signs >> k & 1 == 0 { 1.0 } else { -1.0 };
                corner(at, difference, &farther)
            });
            Self::new(difference, corners, &farther, &nearer, rounding)
        };
        (0..1usize << D.saturating_sub(1)).map(of_signs).collect()
    }

    /// The cone of corners, whose terms are among given ones.
    fn new(
        difference: &Difference<D>,
        corners: [Corner<D>; D],
        farther: &Terms<D>,
        nearer: &Terms<D>,
        rounding: f64,
    ) -> Self {
        let farther = farther.within(&difference.farther, &corners);
        let nearer = nearer.within(&difference.nearer, &corners);
        let mut middle = [0.0; D];
        corners.iter().for_each(|corner| add_multiple(&mut middle, 1.0 / corner.length, &corner.at));
        let length = dot(&middle, &middle).sqrt();
        middle = middle.map(|c| c / length);
        let point = nearer.extreme(&difference.nearer, &middle);
        let value = farther.value(&difference.farther, &middle) - dot(&point, &middle);
        let mut largest = f64::NEG_INFINITY;
        let mut cosine = 1.0f64;
        for corner in &corners {
            largest = largest.max((corner.farther - dot(&point, &corner.at)) / corner.length);
            cosine = cosine.min(dot(&middle, &corner.at) / corner.length);
        }
        // along u = Σ λ_i u_i of unit corners u_i, λ ≥ 0, the difference is at most Σ λ_i times the largest value at a
        // corner, and |u| ≥ middle · u ≥ Σ λ_i times the least cosine
        let upper = (largest.max(0.0) + 2.0 * rounding) * THIRTY_ROUNDINGS / (cosine * (2.0 - THIRTY_ROUNDINGS));
        let lower = (value - 2.0 * rounding) * (2.0 - THIRTY_ROUNDINGS);
        Self { corners, farther, nearer, upper, middle, lower: lower.max(0.0) }
    }

    /// How many generators were looked at for the cone, up to those that its halves need not look at.
    pub(super) fn reads(&self) -> u64 {
        (self.farther.open.len() + self.nearer.open.len()) as u64 + 1
    }

    /// The two cones that the cone is cut into at the middle of its longest edge; `None` if doubles have no middle.
    pub(super) fn halves(&self, difference: &Difference<D>, rounding: f64) -> Option<[Self; 2]> {
        let mut longest = (f64::INFINITY, 0, 0);
        for i in 0..D {
            for j in i + 1..D {
                let (a, b) = (&self.corners[i], &self.corners[j]);
                let cosine = dot(&a.at, &b.at) / (a.length * b.length);
                if cosine < longest.0 {
                    longest = (cosine, i, j);
                }
            }
        }
        let (_, i, j) = longest;
        let (a, b) = (&self.corners[i].at, &self.corners[j].at);
        let at: [f64; D] = std::array::from_fn(|k| (a[k] + b[k]) / 2.0);
        // a half of what is not 0 is exact here, and the sum is if both terms come back
        let is_exact = |k: usize| 2.0 * at[k] - a[k] == b[k] && 2.0 * at[k] - b[k] == a[k];
        if i == j || !(0..D).all(is_exact) || at == *a || at == *b {
            return None;
        }
        let middle = corner(at, difference, &self.farther);
        let half = |replaced: usize| {
            let mut corners = self.corners;
            corners[replaced] = middle;
            Self::new(difference, corners, &self.farther, &self.nearer, rounding)
        };
        Some([half(i), half(j)])
    }
}

fn corner<const D: usize>(at: [f64; D], difference: &Difference<D>, farther: &Terms<D>) -> Corner<D> {
    Corner { at, length: dot(&at, &at).sqrt(), farther: farther.value(&difference.farther, &at) }
}
