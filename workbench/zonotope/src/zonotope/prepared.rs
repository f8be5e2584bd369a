//! A body of space prepared for many passes: its generators in blocks of eight, coordinate by coordinate.
//!
//! A pass over rows spends more time on taking the rows apart than on the sums. Where one body is asked in many
//! directions, as a support map is, that is done once: four passes' time, and 24 bytes a generator. The results are the
//! same, to the last bit, as those of the passes over the rows.

use fearless_simd::dispatch;

use super::Zonotope;
use crate::numeric::lanes::blocks::{Block, blocks_of};
use crate::numeric::lanes::level::level;
use crate::numeric::lanes::{absolute_sum_of, extreme_sum_of};

/// A body with its generators as passes want them.
#[derive(Debug, Clone, PartialEq)]
pub struct PreparedBody {
    center: [f64; 3],
    blocks: Vec<Block>,
    len: usize,
}

impl PreparedBody {
    /// Prepares a body. O(n).
    pub fn new(body: &Zonotope<3>) -> Self {
        Self { center: body.center(), ..Self::of_generators(body.generators()) }
    }

    /// Prepares generators of a body around the origin. O(n).
    pub fn of_generators(generators: &[[f64; 3]]) -> Self {
        let blocks = dispatch!(level(), simd => blocks_of(simd, generators));
        Self { center: [0.0; 3], blocks, len: generators.len() }
    }

    /// The centre.
    pub fn center(&self) -> [f64; 3] {
        self.center
    }

    /// How many generators there are.
    pub fn len(&self) -> usize {
        self.len
    }

    /// Whether there are no generators: the body is its centre.
    pub fn is_empty(&self) -> bool {
        self.len == 0
    }

    /// Σ |g · direction| over the generators, in doubles: what
    /// [`absolute_sum`](super::passes::absolute_sum) computes from their rows. O(n).
    pub fn absolute_sum(&self, direction: &[f64; 3]) -> f64 {
        absolute_sum_of(&self.blocks.as_slice(), direction)
    }

    /// Σ ± g with the signs of g · direction, in doubles: what [`extreme_sum`](super::passes::extreme_sum) computes
    /// from their rows. O(n).
    pub fn extreme_sum(&self, direction: &[f64; 3]) -> [f64; 3] {
        extreme_sum_of(&self.blocks.as_slice(), direction)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numeric::lanes::test_vectors::vectors;
    use crate::zonotope::passes::{absolute_sum, extreme_sum};
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn passes_over_blocks_are_those_over_rows((generators, direction) in vectors()) {
            let prepared = PreparedBody::of_generators(&generators);
            prop_assert_eq!(prepared.len(), generators.len());
            let bits = |v: [f64; 3]| v.map(f64::to_bits);
            let sum = prepared.absolute_sum(&direction);
            prop_assert_eq!(sum.to_bits(), absolute_sum(&generators, &direction).to_bits());
            let point = prepared.extreme_sum(&direction);
            prop_assert_eq!(bits(point), bits(extreme_sum(&generators, &direction)));
        }
    }

    #[test]
    fn the_centre_stays() {
        let body = Zonotope::new([1.0, 2.0, 3.0], vec![[1.0, 0.0, 0.0]]).expect("finite");
        let prepared = PreparedBody::new(&body);
        assert_eq!((prepared.center(), prepared.len(), prepared.is_empty()), ([1.0, 2.0, 3.0], 1, false));
        assert!(PreparedBody::of_generators(&[]).is_empty());
    }
}
