//! A vertex of a reduced problem, proved to be the optimum by bounds on every rounding error.
//!
//! Let u = ± v_a × v_b with u · p > 0, and g the sum of all other generators with the signs of v · u. Then
//! g + δ_a v_a + δ_b v_b = λ p with λ = g · u / p · u, δ_a = −g · (v_b × p) / p · (v_a × v_b), δ_b = −g · (p × v_a) / p · (v_a × v_b); u is
//! optimal, and the only optimum, if both are within (−1, 1).

use super::reduced::{End, Reduced};
use super::smooth::Columns;
use crate::numeric::bounded::{Bounded, BoundedVector, cross, dot, exact};

/// The optimum and what is known of it.
#[derive(Debug)]
pub(super) struct Certain {
    /// a and b, by their index in the question.
    pub(super) basis: [usize; 2],
    pub(super) vectors: [[f64; 3]; 2],
    /// Whether u is −(v_a × v_b).
    pub(super) reversed: bool,
    pub(super) direction: BoundedVector,
    /// g, without a and b.
    pub(super) sum: BoundedVector,
    /// g · u.
    pub(super) reach: Bounded,
    /// p · u.
    pub(super) along: Bounded,
    /// Σ |v|_1, rounded.
    pub(super) magnitude: f64,
    /// The signs of generators that are not known to be those of their dot products with the first cell's centre.
    pub(super) overrides: Vec<(u32, i8)>,
}

impl Certain {
    /// Checks a vertex, given by the positions of two lines in a reduced problem.
    pub(super) fn at(reduced: &Reduced, columns: &Columns, p: &BoundedVector, [first, second]: [usize; 2]) -> End {
        let vectors = [reduced.vectors[first], reduced.vectors[second]];
        let [a, b] = vectors.map(exact);
        let product = cross(&a, &b);
        let Some(sign) = dot(&product, p).sign() else { return End::Doubt };
        let reversed = sign < 0;
        let direction = if reversed { product.map(Bounded::negated) } else { product };
        if !reduced.cells.iter().all(|cell| cell.contains(&direction, p)) {
            return End::Astray(columns.meet(first, second));
        }
        let mut sum = reduced.fixed.bounded();
        let mut magnitude = reduced.fixed.magnitude;
        let mut overrides = Vec::with_capacity(reduced.overrides.len() + reduced.vectors.len());
        overrides.extend_from_slice(&reduced.overrides);
        for (i, v) in reduced.vectors.iter().enumerate() {
            magnitude += v[0].abs() + v[1].abs() + v[2].abs();
            if i == first || i == second {
                overrides.push((reduced.indices[i], 0));
                continue;
            }
            let Some(sign) = dot(&exact(*v), &direction).sign() else { return End::Doubt };
            let factor = f64::from(sign);
            for (total, c) in sum.iter_mut().zip(v) {
                *total = *total + Bounded::exact(factor * c);
            }
            overrides.push((reduced.indices[i], sign));
        }
        let along = dot(&direction, p);
        let across = [dot(&sum, &cross(&b, p)), dot(&sum, &cross(p, &a))];
        if !across.iter().all(|value| value.is_within(along)) {
            return End::Doubt;
        }
        let reach = dot(&sum, &direction);
        if !reach.is_positive() {
            return End::Doubt;
        }
        let basis = [first, second].map(|i| reduced.indices[i] as usize);
        End::Certain(Box::new(Self { basis, vectors, reversed, direction, sum, reach, along, magnitude, overrides }))
    }
}
