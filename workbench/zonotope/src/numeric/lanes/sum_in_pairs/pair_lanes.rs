//! Sums over many vectors to about twice the digits of a double: eight side by side, block after block.
//!
//! The rest that rounding a product leaves is known (Dekker), and so is that of a sum (Knuth). These small
//! parts are added up as they are within a block, where they are few; what joining the blocks leaves behind is kept.

use fearless_simd::{Simd, f64x8, prelude::*, u64x8};

use super::super::number::sum_and_rest;
use super::super::octet::total;
use crate::numeric::double_double::BoundedDoubleDouble;
use crate::numeric::exact_sum::exact_sum;
use crate::numeric::tolerance::{COMBINED_SUM, PRODUCT_UNDERFLOW};

/// Vectors whose small parts are added up before they join those of the others, so that few roundings take part: 32
/// in each lane.
pub(crate) const BLOCK: usize = 256;

/// The bits of a double but for the last 27 of its significand.
const HEAD: u64 = u64::MAX << 27;

/// The sum over one coordinate, and Σ |c v|.
#[derive(Clone, Copy, Default)]
pub(crate) struct Sum {
    head: f64,
    tail: f64,
    /// The rest that rounding the tail leaves.
    rest: f64,
    magnitude: f64,
}

impl Sum {
    /// Takes in a block's sum as two doubles, and its Σ |c v|.
    #[inline(always)]
    pub(crate) fn add(&mut self, [head, tail, magnitude]: [f64; 3]) {
        let (head, rest) = exact_sum(self.head, head);
        self.head = head;
        self.add_small(rest);
        self.add_small(tail);
        self.magnitude += magnitude;
    }

    #[inline(always)]
    fn add_small(&mut self, small: f64) {
        let (tail, rest) = exact_sum(self.tail, small);
        self.tail = tail;
        self.rest += rest;
    }

    pub(crate) fn in_pairs(&self, count: f64) -> BoundedDoubleDouble {
        let error = COMBINED_SUM * self.magnitude + count * PRODUCT_UNDERFLOW;
        BoundedDoubleDouble::of_parts(self.head, self.tail, error) + BoundedDoubleDouble::exact(self.rest)
    }
}

/// Sums of eight vectors side by side, one coordinate.
#[derive(Clone, Copy)]
pub(crate) struct Lanes<S: Simd> {
    head: f64x8<S>,
    tail: f64x8<S>,
    magnitude: f64x8<S>,
}

impl<S: Simd> Lanes<S> {
    #[inline(always)]
    pub(crate) fn new(simd: S) -> Self {
        let zero = f64x8::splat(simd, 0.0);
        Self { head: zero, tail: zero, magnitude: zero }
    }

    /// Takes in numbers, with what they lack.
    #[inline(always)]
    fn add(&mut self, number: f64x8<S>, small: f64x8<S>) {
        let (head, rest) = sum_and_rest(self.head, number);
        self.head = head;
        self.tail += small + rest;
        self.magnitude += number.abs();
    }

    /// Takes in numbers that lack nothing.
    #[inline(always)]
    pub(crate) fn add_exact(&mut self, number: f64x8<S>) {
        let (head, rest) = sum_and_rest(self.head, number);
        self.head = head;
        self.tail += rest;
        self.magnitude += number.abs();
    }

    /// Takes in products.
    #[inline(always)]
    pub(crate) fn add_products(&mut self, simd: S, v: f64x8<S>, coefficient: f64x8<S>) {
        let (v_head, coefficient_head) = (head_of(simd, v), head_of(simd, coefficient));
        let (v_tail, coefficient_tail) = (v - v_head, coefficient - coefficient_head);
        let product = coefficient * v;
        let of_heads = (coefficient_head * v_head - product) + coefficient_head * v_tail + coefficient_tail * v_head;
        self.add(product, of_heads + coefficient_tail * v_tail);
    }

    /// The lanes joined by halves: the sum as two doubles, and that of magnitudes.
    #[inline(always)]
    pub(crate) fn joined(&self) -> [f64; 3] {
        let ((a, b), (s, t)) = (self.head.split(), self.tail.split());
        let (four, rest) = sum_and_rest(a, b);
        let ((a, b), (s, t)) = (four.split(), ((s + t) + rest).split());
        let (two, rest) = sum_and_rest(a, b);
        let tails = (s + t) + rest;
        let (head, rest) = exact_sum(two[0], two[1]);
        [head, (tails[0] + tails[1]) + rest, total(self.magnitude)]
    }
}

/// The first 26 bits of a number.
#[inline(always)]
fn head_of<S: Simd>(simd: S, number: f64x8<S>) -> f64x8<S> {
    (number.bitcast::<u64x8<S>>() & u64x8::splat(simd, HEAD)).bitcast()
}
