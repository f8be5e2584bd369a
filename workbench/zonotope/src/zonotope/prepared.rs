//! A body of space prepared for many questions: its generators in blocks of eight, coordinate by coordinate, beside the
//! sums that every question needs.
//!
//! A pass over rows spends more time on taking the rows apart than on the sums, and a question begins with sums that do
//! not depend on what is asked. Where a body is asked again, that is done once: in the time of some ten passes, for 24
//! bytes a generator beside the body itself, from which single generators are read. A pass over blocks has the bits of
//! the one over rows.

use super::Zonotope;
use super::pose::Pose;
use super::query::Placed;
use crate::numeric::lanes::body_sums::laid_out;
use crate::numeric::lanes::rows::LaidOut;
use crate::numeric::lanes::{absolute_sum_of, extreme_sum_of};

/// A body with what makes questions about it quicker; its methods are those of [`Zonotope`], and so are its answers.
#[derive(Debug, Clone, PartialEq)]
pub struct PreparedBody {
    body: Zonotope<3>,
    laid_out: LaidOut,
}

impl PreparedBody {
    /// Prepares a body. O(n).
    pub fn new(body: Zonotope<3>) -> Self {
        let laid_out = laid_out(body.generators());
        Self { body, laid_out }
    }

    /// The body.
    pub fn body(&self) -> &Zonotope<3> {
        &self.body
    }

    /// The body where a pose puts it, without a copy of anything: blocks serve under any pose. O(1).
    #[inline]
    pub fn at(&self, pose: &Pose) -> Placed<'_, 3, Pose> {
        self.placed().at(pose)
    }

    /// The body as it is stored. O(1).
    #[inline]
    pub fn placed(&self) -> Placed<'_> {
        self.into()
    }

    /// The bytes that are held, the generators included.
    pub fn bytes(&self) -> usize {
        size_of::<Self>() + size_of_val(self.body.generators()) + size_of_val(self.laid_out.blocks())
    }

    /// Σ |g · direction| over the generators, in doubles: what
    /// [`absolute_sum`](super::passes::absolute_sum) computes from their rows. O(n).
    pub fn absolute_sum(&self, direction: &[f64; 3]) -> f64 {
        absolute_sum_of(&self.laid_out.blocks(), direction)
    }

    /// Σ ± g with the signs of g · direction, in doubles: what [`extreme_sum`](super::passes::extreme_sum) computes
    /// from their rows. O(n).
    pub fn extreme_sum(&self, direction: &[f64; 3]) -> [f64; 3] {
        extreme_sum_of(&self.laid_out.blocks(), direction)
    }
}

impl<'a> From<&'a PreparedBody> for Placed<'a> {
    #[inline]
    fn from(prepared: &'a PreparedBody) -> Self {
        Self::from(&prepared.body).with_blocks(&prepared.laid_out)
    }
}

impl<'a> From<&'a PreparedBody> for Placed<'a, 3, Pose> {
    #[inline]
    fn from(body: &'a PreparedBody) -> Self {
        body.at(&Pose::IDENTITY)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numeric::lanes::test_vectors::vectors;
    use crate::zonotope::passes::{absolute_sum, extreme_sum};
    use proptest::prelude::*;

    properties! {
        #[test]
        fn passes_over_blocks_are_those_over_rows((generators, direction) in vectors()) {
            let prepared = PreparedBody::new(Zonotope::new([0.0; 3], generators.clone()).expect("finite"));
            let bits = |v: [f64; 3]| v.map(f64::to_bits);
            let sum = prepared.absolute_sum(&direction);
            prop_assert_eq!(sum.to_bits(), absolute_sum(&generators, &direction).to_bits());
            let point = prepared.extreme_sum(&direction);
            prop_assert_eq!(bits(point), bits(extreme_sum(&generators, &direction)));
        }
    }
}
