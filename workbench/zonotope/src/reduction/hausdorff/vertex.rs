//! A vertex of a body with what rounded numbers tell of its distance, in the order in which vertices are looked at.

use std::array;
use std::cmp::Ordering;

use super::nearest_point::Coefficient;
use crate::numeric::double_double::DoubleDouble;
use crate::numeric::dyadic::Dyadic;
use crate::numeric::linear::Ring;

/// A vertex with what rounded numbers tell of it.
pub(super) struct Vertex {
    pub(super) signs: Vec<Ordering>,
    /// The coefficients of a near point of the other body.
    pub(super) near: Vec<Coefficient<f64>>,
    /// The vertex is no farther than this.
    pub(super) upper: f64,
    /// Whether pairs of doubles have found the near point.
    pub(super) is_refined: bool,
}

impl PartialEq for Vertex {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other).is_eq()
    }
}

impl Eq for Vertex {}

impl PartialOrd for Vertex {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Vertex {
    fn cmp(&self, other: &Self) -> Ordering {
        self.upper.total_cmp(&other.upper).then_with(|| other.signs.cmp(&self.signs))
    }
}

/// The end of a coefficient, or the one that it is nearer to.
pub(super) fn is_positive(coefficient: &Coefficient<f64>) -> bool {
    match coefficient {
        Coefficient::AtEnd(is_positive) => *is_positive,
        Coefficient::Free(value) => *value > 0.0,
    }
}

/// A vertex of one side, relative to the centre of the other body.
pub(super) fn vertex<N: Ring, const D: usize>(
    generators: &[[N; D]],
    displacement: &[N; D],
    side: usize,
    signs: &[Ordering],
) -> [N; D] {
    let center = array::from_fn(|k| if side == 0 { displacement[k].clone() } else { N::ZERO.minus(&displacement[k]) });
    generators.iter().zip(signs).fold(center, |sum: [N; D], (g, sign)| {
        array::from_fn(|k| if sign.is_lt() { sum[k].minus(&g[k]) } else { sum[k].plus(&g[k]) })
    })
}

/// An exact number as a pair of doubles, rounded.
pub(super) fn pair(exact: &Dyadic) -> DoubleDouble {
    let high = exact.to_f64();
    if !high.is_finite() {
        return DoubleDouble::from(high);
    }
    DoubleDouble::ordered_sum(high, (exact - &Dyadic::from_f64(high)).to_f64())
}
