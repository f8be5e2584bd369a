//! Σ c v over vectors with coefficients of at most 1 in magnitude, to about twice the digits of a double, in one pass.
//!
//! Each factor is cut into a head of 26 bits and a tail of 27, so that what rounding a product leaves behind is known
//! (Dekker), and so is what rounding a sum does (Knuth). These small parts are added as they are. A coefficient of a
//! basis that is near 0 is known to the last digit by a sum as precise as that, where one with a tenth of the digits
//! more than a double would leave it to exact arithmetic on all vectors.

use std::array;

use wide::f64x2;

use super::double_double::BoundedDoubleDouble;
use super::exact_sum::exact_sum;
use super::tolerance::{COMBINED_SUM, PRODUCT_UNDERFLOW};

/// Vectors whose small parts are added up before they join those of the others, so that few roundings take part.
const BLOCK: usize = 64;

/// The bits of a double but for the last 27 of its significand.
const HEAD: f64 = f64::from_bits(u64::MAX << 27);

/// The sum over one coordinate, and Σ |c v|.
#[derive(Clone, Copy, Default)]
struct Sum {
    head: f64,
    tail: f64,
    /// What rounding the tail leaves behind.
    rest: f64,
    magnitude: f64,
}

impl Sum {
    fn add(&mut self, lanes: &Lanes) {
        for part in lanes.head.to_array() {
            let (head, rest) = exact_sum(self.head, part);
            self.head = head;
            self.add_small(rest);
        }
        self.add_small(lanes.tail.to_array().iter().sum());
        self.magnitude += lanes.magnitude.to_array().iter().sum::<f64>();
    }

    fn add_small(&mut self, small: f64) {
        let (tail, rest) = exact_sum(self.tail, small);
        self.tail = tail;
        self.rest += rest;
    }
}

/// Sums of two vectors side by side, one coordinate.
#[derive(Clone, Copy, Default)]
struct Lanes {
    head: f64x2,
    tail: f64x2,
    magnitude: f64x2,
}

impl Lanes {
    #[inline(always)]
    fn read(&mut self, v: f64x2, coefficient: f64x2, coefficient_head: f64x2) {
        let v_head = v & f64x2::splat(HEAD);
        let (v_tail, coefficient_tail) = (v - v_head, coefficient - coefficient_head);
        let product = coefficient * v;
        let of_heads = (coefficient_head * v_head - product) + coefficient_head * v_tail + coefficient_tail * v_head;
        let small = of_heads + coefficient_tail * v_tail;
        let sum = self.head + product;
        let product_in_sum = sum - self.head;
        let rest = (self.head - (sum - product_in_sum)) + (product - product_in_sum);
        self.head = sum;
        self.tail += small + rest;
        self.magnitude += product.abs();
    }
}

/// Σ c v of as many vectors as coefficients, none of which exceeds 1 in magnitude. O(n).
pub(crate) fn combined_sum<const D: usize>(vectors: &[[f64; D]], coefficients: &[f64]) -> [BoundedDoubleDouble; D] {
    let mut sums = [Sum::default(); D];
    for (vectors, coefficients) in vectors.chunks(BLOCK).zip(coefficients.chunks(BLOCK)) {
        let mut lanes = [Lanes::default(); D];
        let mut read = |[v, w]: [[f64; D]; 2], pair: [f64; 2]| {
            let coefficient = f64x2::new(pair);
            let head = coefficient & f64x2::splat(HEAD);
            for (k, lanes) in lanes.iter_mut().enumerate() {
                lanes.read(f64x2::new([v[k], w[k]]), coefficient, head);
            }
        };
        let ((pairs, last), (places, last_place)) = (vectors.as_chunks::<2>(), coefficients.as_chunks::<2>());
        for (pair, place) in pairs.iter().zip(places) {
            read(*pair, *place);
        }
        if let ([last], [place]) = (last, last_place) {
            read([*last, [0.0; D]], [*place, 0.0]);
        }
        for (sum, lanes) in sums.iter_mut().zip(&lanes) {
            sum.add(lanes);
        }
    }
    let count = vectors.len() as f64;
    array::from_fn(|k| {
        let Sum { head, tail, rest, magnitude } = sums[k];
        BoundedDoubleDouble::of_parts(head, tail + rest, COMBINED_SUM * magnitude + count * PRODUCT_UNDERFLOW)
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numeric::dyadic::Dyadic;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn sums_keep_their_bounds(
            terms in proptest::collection::vec((proptest::array::uniform3(-1e3..1e3f64), -1.0..1.0f64), 0..300),
            exponent in -900..900i32,
        ) {
            let size = crate::numeric::scaling::power_of_two(exponent);
            let vectors: Vec<[f64; 3]> = terms.iter().map(|(v, _)| v.map(|c| c * size)).collect();
            let coefficients: Vec<f64> = terms.iter().map(|(_, c)| *c).collect();
            let sums = combined_sum(&vectors, &coefficients);
            for k in 0..3 {
                let exact = vectors.iter().zip(&coefficients).fold(Dyadic::zero(), |sum, (v, c)| {
                    sum + Dyadic::from_f64(v[k]) * Dyadic::from_f64(*c)
                });
                let (pair, error) = sums[k].parts();
                let off = (exact - Dyadic::from_f64(pair.high) - Dyadic::from_f64(pair.low)).abs();
                prop_assert!(off <= Dyadic::from_f64(error), "{error}");
                let magnitude: f64 = vectors.iter().zip(&coefficients).map(|(v, c)| (c * v[k]).abs()).sum();
                prop_assert!(error <= 1e-27 * magnitude + 1e-268, "{error} {magnitude}");
            }
        }
    }

    #[test]
    fn overflow_leaves_nothing_known() {
        let [sum] = combined_sum(&[[f64::MAX]; 3], &[1.0; 3]);
        assert!(sum.sign().is_none());
    }
}
