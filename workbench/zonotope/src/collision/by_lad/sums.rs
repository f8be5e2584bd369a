//! Exact sums of generators with signs.

use crate::numeric::exact_sum::ExactSum;
use crate::numeric::vector::ExactVector;

/// Σ sign · v, exactly.
pub(in crate::collision) fn signed_sum(terms: impl Iterator<Item = ([f64; 3], i8)>) -> ExactVector {
    let mut sums = [ExactSum::default(), ExactSum::default(), ExactSum::default()];
    for (v, sign) in terms {
        for (sum, coordinate) in sums.iter_mut().zip(v) {
            sum.add(f64::from(sign) * coordinate);
        }
    }
    sums.map(|sum| sum.value())
}
