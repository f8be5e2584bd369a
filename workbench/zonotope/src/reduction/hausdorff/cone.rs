//! A cone of directions over a box on a face of a cube, with bounds on the difference of two support functions in it.
//!
//! The cone of a face of the cube [−1, 1]^D is cut into cones over boxes, at the middles of their sides, which are
//! doubles without rounding: so the parts of a cone cover it exactly. Boxes are rounder than the simplices that a
//! triangulation would have, (D − 1)! of them for a box, and a generator's sign in a box takes one product to decide.
//!
//! A generator whose product with the box has one sign is linear in the cone, and the cone's descendants need not look
//! at it again: such generators are summed up, and lists hold the others. Lists become shorter by the factor by which
//! cones become narrower.

use super::difference::{Difference, Rounding, magnitude_sum};
use crate::numeric::exact_sum::exact_sum;
use crate::numeric::linear::{add_multiple, dot};
use crate::numeric::tolerance::THIRTY_ROUNDINGS;

/// A box on the face where one coordinate is 1.
#[derive(Debug, Clone, Copy)]
struct FaceBox<const D: usize> {
    face: usize,
    low: [f64; D],
    high: [f64; D],
}

impl<const D: usize> FaceBox<D> {
    fn whole(face: usize) -> Self {
        let side = |value: f64| std::array::from_fn(|k| if k == face { 1.0 } else { value });
        Self { face, low: side(-1.0), high: side(1.0) }
    }

    /// The corner whose coordinates beside the face are the low or the high ones by the bits of a number.
    fn corner(&self, bits: usize) -> [f64; D] {
        std::array::from_fn(|k| if bits >> self.place(k) & 1 == 0 { self.low[k] } else { self.high[k] })
    }

    /// The bit of a coordinate; that of the face is beyond all others.
    fn place(&self, k: usize) -> usize {
        match k.cmp(&self.face) {
            std::cmp::Ordering::Less => k,
            std::cmp::Ordering::Equal => D,
            std::cmp::Ordering::Greater => k - 1,
        }
    }

    /// The middle, and half of the sides.
    fn middle(&self) -> ([f64; D], [f64; D]) {
        let half = |sign: f64| std::array::from_fn(|k| (self.high[k] + sign * self.low[k]) / 2.0);
        (half(1.0), half(-1.0))
    }

    /// The parts below and above the middle of the longest side, with its coordinate; `None` if doubles have no middle.
    fn halves(&self) -> Option<(usize, [Self; 2])> {
        let sides = (0..D).filter(|k| *k != self.face);
        let longest = sides.max_by(|&a, &b| {
            let side = |k: usize| self.high[k] - self.low[k];
            side(a).total_cmp(&side(b)).then(b.cmp(&a))
        })?;
        let (low, high) = (self.low[longest], self.high[longest]);
        let middle = (low + high) / 2.0;
        // the sum is exact if both terms come back
        let is_exact = 2.0 * middle - low == high && 2.0 * middle - high == low && low < middle && middle < high;
        let mut halves = [*self; 2];
        halves[0].high[longest] = middle;
        halves[1].low[longest] = middle;
        is_exact.then_some((longest, halves))
    }
}

/// A sum of generators: the signed sum of those that have one sign in the cone, and the indices of the others.
#[derive(Debug, Clone)]
struct Terms<const D: usize> {
    fixed: [f64; D],
    /// What rounding took off the fixed sum.
    tail: [f64; D],
    open: Vec<u32>,
}

impl<const D: usize> Terms<D> {
    fn all(count: usize) -> Self {
        Self { fixed: [0.0; D], tail: [0.0; D], open: (0..count as u32).collect() }
    }

    /// The terms in a smaller cone, over the box with this middle and these half sides.
    fn within(&self, vectors: &[[f64; D]], (middle, half): &([f64; D], [f64; D])) -> Self {
        let mut within = Self { fixed: self.fixed, tail: self.tail, open: Vec::with_capacity(self.open.len() / 2) };
        for &index in &self.open {
            let v = &vectors[index as usize];
            let product = dot(v, middle);
            if product.abs() < dot(&v.map(f64::abs), half) {
                within.open.push(index);
            } else {
                within.add(v, product);
            }
        }
        within
    }

    /// Adds a generator with the sign of its product.
    fn add(&mut self, v: &[f64; D], product: f64) {
        for ((sum, tail), c) in self.fixed.iter_mut().zip(&mut self.tail).zip(v) {
            let (next, rest) = exact_sum(*sum, if product < 0.0 { -c } else { *c });
            *sum = next;
            *tail += rest;
        }
    }

    /// Σ |u · v| for a direction of the cone.
    fn value(&self, vectors: &[[f64; D]], u: &[f64; D]) -> f64 {
        dot(&self.fixed, u) + (dot(&self.tail, u) + magnitude_sum(vectors, &self.open, u))
    }

    /// Σ ± v with the signs of u · v.
    fn extreme(&self, vectors: &[[f64; D]], u: &[f64; D]) -> [f64; D] {
        let mut sum = self.tail;
        for &index in &self.open {
            let v = &vectors[index as usize];
            add_multiple(&mut sum, if dot(v, u) < 0.0 { -1.0 } else { 1.0 }, v);
        }
        add_multiple(&mut sum, 1.0, &self.fixed);
        sum
    }
}

/// A cone with its bounds.
#[derive(Debug, Clone)]
pub(super) struct Cone<const D: usize> {
    part: FaceBox<D>,
    /// The support function of the farther body at the corners of the box.
    corners: Vec<f64>,
    farther: Terms<D>,
    nearer: Terms<D>,
    /// No unit vector of the cone has a greater difference.
    pub(super) upper: f64,
    /// A unit vector of the cone, up to rounding, and a bound that its difference is not below.
    pub(super) middle: [f64; D],
    pub(super) lower: f64,
    /// By how much rounding keeps the bounds of narrow cones apart.
    pub(super) doubt: f64,
    /// Whether the difference is certainly below 0 in the whole cone.
    pub(super) is_below: bool,
}

impl<const D: usize> Cone<D> {
    /// The cones of one face of the cube for each coordinate; their opposites are the others.
    pub(super) fn faces(difference: &Difference<D>, rounding: &Rounding) -> Vec<Self> {
        let (farther, nearer) = (Terms::all(difference.farther.len()), Terms::all(difference.nearer.len()));
        let over = |face: usize| {
            let part = FaceBox::whole(face);
            let value = |bits| farther.value(&difference.farther, &part.corner(bits));
            let corners = (0..1usize << (D - 1)).map(value).collect();
            Self::new(difference, part, corners, [&farther, &nearer], rounding)
        };
        (0..D).map(over).collect()
    }

    /// The cone over a box, whose terms are among given ones.
    fn new(
        difference: &Difference<D>,
        part: FaceBox<D>,
        corners: Vec<f64>,
        [farther, nearer]: [&Terms<D>; 2],
        rounding: &Rounding,
    ) -> Self {
        let center = part.middle();
        let farther = farther.within(&difference.farther, &center);
        let nearer = nearer.within(&difference.nearer, &center);
        let length = dot(&center.0, &center.0).sqrt();
        let middle = center.0.map(|c| c / length);
        let point = nearer.extreme(&difference.nearer, &middle);
        let value = farther.value(&difference.farther, &middle) - dot(&point, &middle);
        let mut largest = f64::NEG_INFINITY;
        let mut cosine = 1.0f64;
        for (bits, reach) in corners.iter().enumerate() {
            let corner = part.corner(bits);
            let length = dot(&corner, &corner).sqrt();
            largest = largest.max((reach - dot(&point, &corner)) / length);
            cosine = cosine.min(dot(&middle, &corner) / length);
        }
        // corners may be those of a cone in which all farther generators were open
        let error = rounding.of_terms(difference.farther.len() + nearer.open.len());
        // along u = Σ λ_i u_i of unit corners u_i, λ ≥ 0, the difference is at most Σ λ_i times the largest value at a
        // corner, and |u| ≥ middle · u ≥ Σ λ_i times the least cosine
        let is_below = largest < -error * THIRTY_ROUNDINGS;
        let upper = match cosine > 0.0 {
            true => (largest.max(0.0) + error) * THIRTY_ROUNDINGS / (cosine * (2.0 - THIRTY_ROUNDINGS)),
            false => f64::INFINITY,
        };
        let lower = ((value - error) * (2.0 - THIRTY_ROUNDINGS)).max(0.0);
        let doubt = 2.0 * rounding.of_terms(difference.farther.len());
        Self { part, corners, farther, nearer, upper, middle, lower, doubt, is_below }
    }

    /// How many products of a direction and a vector the cone takes: one for each open generator, and at each corner
    /// two beside half of those of the farther body.
    pub(super) fn products(&self) -> u64 {
        let (farther, nearer) = (self.farther.open.len() as u64, self.nearer.open.len() as u64);
        farther + nearer + self.corners.len() as u64 * (2 + farther / 2)
    }

    /// The two cones that the cone is cut into at the middle of the longest side; `None` if doubles have no middle.
    pub(super) fn halves(&self, difference: &Difference<D>, rounding: &Rounding) -> Option<[Self; 2]> {
        let (axis, halves) = self.part.halves()?;
        let bit = 1usize << self.part.place(axis);
        let mut between = vec![0.0; self.corners.len()];
        for bits in (0..self.corners.len()).filter(|bits| bits & bit == 0) {
            let value = self.farther.value(&difference.farther, &halves[1].corner(bits));
            (between[bits], between[bits | bit]) = (value, value);
        }
        let half = |upper: usize| {
            let is_old = |bits: usize| (bits & bit != 0) == (upper == 1);
            let corners =
                (0..self.corners.len()).map(|bits| if is_old(bits) { self.corners[bits] } else { between[bits] });
            Self::new(difference, halves[upper], corners.collect(), [&self.farther, &self.nearer], rounding)
        };
        Some([half(0), half(1)])
    }
}
