//! A direction of doubles that separates, near the exact normal of a facet that the displacement is beyond.
//!
//! Near the boundary rounding the normal u costs more than the gap: the two generators of the facet, which u is
//! orthogonal to, are not orthogonal to a rounded u. Multiples of u are rounded differently, and so are neighbours of a
//! rounded one, so several directions are tried. Let S be the sum of all other generators with the signs of their
//! products with u. No direction w separates unless w · (p − S) exceeds |w · v| of the two, which takes O(1) and turns
//! nearly all down; what is left is tried with all generators.

use crate::lad::of_generators::seam::direction_signs::DirectionSigns;
use crate::lad::of_generators::seam::kernel_query::KernelQuery;
use crate::numeric::double_double::BoundedDoubleDouble;
use crate::numeric::exact_linear::{self, exact};
use crate::numeric::linear::dot;

/// Multiples of the direction that are rounded in turn: each multiple has its coordinates rounded differently.
const MULTIPLES: [f64; 8] = [1.0, 1.1, 1.3, 1.5, 1.7, 1.2, 1.4, 1.6];

/// A vector in pairs of doubles.
pub(crate) type Pairs = [BoundedDoubleDouble; 3];

/// The facet of at most two generators, seen from a displacement beyond it.
pub(crate) struct Beyond {
    /// The normal u with u · p > 0.
    pub(crate) normal: Pairs,
    /// p − S.
    pub(crate) rest: Pairs,
    /// The generators of the facet; zero where there are fewer than two.
    pub(crate) spanning: [Pairs; 2],
}

impl Beyond {
    /// A direction of doubles near the normal that separates, if one is found. O(n) for each that is likely to.
    pub(crate) fn direction_of_doubles(&self, query: &dyn KernelQuery) -> Option<[f64; 3]> {
        let size = self.normal.iter().fold(0.0f64, |m, c| m.max(c.high.abs()));
        let largest = BoundedDoubleDouble::exact(size);
        let [x, y, z] = self.normal.map(|c| (c / largest).high);
        let multiples = MULTIPLES.map(|factor| self.normal.map(|c| (c * BoundedDoubleDouble::exact(factor)).high));
        let candidates = multiples.into_iter().chain([[x, y, z]]).chain(neighbours([x, y, z]));
        candidates.filter(|w| self.is_likely(*w)).find(|w| separates(query, *w))
    }

    /// Whether w · (p − S) may exceed the reach of the facet's generators.
    fn is_likely(&self, w: [f64; 3]) -> bool {
        let w = w.map(BoundedDoubleDouble::exact);
        let [first, second] = self.spanning.map(|v| dot(&v, &w).abs());
        let gap = dot(&self.rest, &w) - first - second;
        gap.high > 0.0 || gap.sign().is_none()
    }
}

/// The directions in which one or more coordinates are moved to a neighbouring double.
fn neighbours(u: [f64; 3]) -> impl Iterator<Item = [f64; 3]> {
    let step = |value: f64, step: i32| match step {
        0 => value,
        1 => value.next_up(),
        _ => value.next_down(),
    };
    (0..27).filter(|&code| code != 13).map(move |code| {
        let steps = [code % 3 - 1, code / 3 % 3 - 1, code / 9 - 1];
        [0, 1, 2].map(|i| step(u[i], steps[i]))
    })
}

/// Whether w · p > h(w): as pairs of doubles tell, or else exactly. O(n).
fn separates(query: &dyn KernelQuery, w: [f64; 3]) -> bool {
    seems_to_separate(query, w).unwrap_or_else(|| separates_exactly(query, w))
}

/// Whether w · p > h(w), where pairs of doubles tell. O(n).
fn seems_to_separate(query: &dyn KernelQuery, w: [f64; 3]) -> Option<bool> {
    let w = w.map(BoundedDoubleDouble::exact);
    let mut reach = BoundedDoubleDouble::exact(0.0);
    for part in query.parts() {
        let own = part.pair_pulled(&w);
        let product = |v: &[f64; 3]| dot(&v.map(BoundedDoubleDouble::exact), &own);
        reach = part.rows.list().iter().fold(reach, |sum, v| sum + product(v).abs());
    }
    (dot(&query.displacement_pairs(), &w) - reach).sign().map(|sign| sign > 0)
}

/// Whether w · p > h(w), exactly. O(n).
fn separates_exactly(query: &dyn KernelQuery, w: [f64; 3]) -> bool {
    if !w.iter().all(|c| c.is_finite()) {
        return false;
    }
    let direction = exact(w);
    let sum = query.signed_sum(&DirectionSigns::new(query, &direction).all(&direction));
    exact_linear::dot(&exact_linear::difference(&query.exact(), &sum), &direction).sign().is_gt()
}
