//! The circle of directions along a cut: where generators turn, and the gradient of the reduced support function
//! between two turns.
//!
//! On a part of the dual plane the support function is h(u) = s · u + Σ |v · u|, the sum over the generators whose
//! lines cross the part, s the sum of the others. Along the circle of directions of a cut the gradient of this function
//! changes by 2 v where v turns. The circle is divided into 2 k gaps by the k generators, the gap 0 at the start of the
//! upper half. On the lower half the same generators turn back in the same order: the gradients there are 2 s minus
//! those of the opposite gaps.

use crate::collision::prepared::by_cutting::filtered::{Filtered, Vector, sign_of_determinant};
use crate::collision::prepared::by_cutting::structure::boundary::Normal;
use crate::collision::prepared::by_cutting::structure::tree::{Cut, Place, SUM_STEP, Tree};
use crate::numeric::double_double::Precision;

/// The directions along a cut.
pub(crate) struct Circle<'t> {
    tree: &'t Tree,
    cut: &'t Cut,
    generators: &'t [[f64; 3]],
    pub(crate) normal: Normal,
    pub(crate) turning: &'t [Place],
    pub(crate) along: &'t [Place],
}

impl<'t> Circle<'t> {
    pub(crate) fn of(tree: &'t Tree, cut: &'t Cut, generators: &'t [[f64; 3]]) -> Self {
        let [turning, along] = tree.places_of(cut);
        let normal = cut.boundary.normal(generators);
        Self { tree, cut, generators, normal, turning, along }
    }

    /// How many generators turn along the circle.
    pub(crate) fn len(&self) -> usize {
        self.turning.len()
    }

    /// A direction that tells the halves of the circle.
    pub(crate) fn reference(&self) -> [f64; 3] {
        self.cut.boundary.reference()
    }

    /// The generator that turns at a place of the upper half, such that it is negative before.
    pub(crate) fn turned(&self, place: usize) -> [f64; 3] {
        self.turning[place].vector(self.generators)
    }

    /// The gradient in a gap, from 0 to 2 k.
    pub(crate) fn gradient(&self, gap: usize) -> Gradient<'_> {
        Gradient { circle: self, gap }
    }

    /// How many generators are read for the gradient in a gap.
    pub(crate) fn steps_to(&self, gap: usize) -> usize {
        let upper = if gap > self.len() { gap - self.len() } else { gap };
        upper % SUM_STEP
    }

    /// The gradient in a gap by numbers of a kind: the kept sum at or before it, and the generators from there on.
    fn sum_of_gap<N: Precision>(&self, gap: usize) -> [N; 3] {
        let kept = |sum: usize| self.tree.sums.over::<N>(sum);
        let is_lower = gap > self.len();
        let upper = if is_lower { gap - self.len() } else { gap };
        let mut gradient = kept(self.cut.first_gradient + upper / SUM_STEP);
        for place in upper - upper % SUM_STEP..upper {
            let v = self.turned(place).map(N::of_double);
            for (sum, c) in gradient.iter_mut().zip(&v) {
                *sum = sum.plus(c).plus(c);
            }
        }
        if is_lower {
            for (sum, c) in gradient.iter_mut().zip(&kept(self.cut.others)) {
                *sum = c.plus(c).minus(sum);
            }
        }
        gradient
    }

    /// The generators that turn together with the one at a place of the upper half.
    pub(crate) fn turning_with(&self, place: usize) -> std::ops::Range<usize> {
        let (n, own) = (Filtered::new(&self.normal), Filtered::new(self.turned(place)));
        let is_with = |other: &usize| sign_of_determinant(&Filtered::new(self.turned(*other)), &n, &own).is_eq();
        let before = (0..place).rev().take_while(is_with).count();
        let behind = (place + 1..self.len()).take_while(is_with).count();
        place - before..place + 1 + behind
    }
}

/// The gradient of the reduced function in a gap of a circle.
pub(crate) struct Gradient<'c> {
    circle: &'c Circle<'c>,
    gap: usize,
}

impl Vector for Gradient<'_> {
    fn over<N: Precision>(&self) -> [N; 3] {
        self.circle.sum_of_gap(self.gap)
    }
}
