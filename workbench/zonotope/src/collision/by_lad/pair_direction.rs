//! The sign of v · u for an exact direction u: by pairs of doubles, and exactly where they leave a doubt.
//!
//! u is rounded once, to about 98 bits. A generator is scaled by a power of two before it is multiplied, so that those of all sizes are told alike.

use crate::numeric::approximation::Approximation;
use crate::numeric::dyadic::{Dyadic, binary_exponent, scale_by_power_of_two};
use crate::numeric::vector::ExactVector;

/// Exponents between which a vector need not be scaled.
const MODERATE: i32 = 300;

/// A direction as pairs of doubles, its largest coordinate about 1.
pub(super) struct PairDirection([Approximation; 3]);

impl PairDirection {
    pub(super) fn new(direction: &ExactVector) -> Self {
        let exponent = direction.iter().filter_map(Dyadic::binary_exponent).max().unwrap_or(0);
        Self(direction.each_ref().map(|c| Approximation::of(&c.clone().scaled(-exponent))))
    }

    /// The sign of v · u if pairs tell and it is not zero.
    pub(super) fn certain_sign(&self, v: &[f64; 3]) -> Option<i8> {
        let scaled = moderate(v)?;
        let [x, y, z] = [0, 1, 2].map(|k| self.0[k] * Approximation::exact(scaled[k]));
        (x + y + z).sign()
    }
}

/// A vector times a power of two, of moderate size; none where that rounds a coordinate, or for zero.
fn moderate(v: &[f64; 3]) -> Option<[f64; 3]> {
    let size = v.iter().fold(0.0f64, |m, c| m.max(c.abs()));
    let exponent = binary_exponent(size)?;
    if exponent.abs() < MODERATE {
        return Some(*v);
    }
    let scaled = v.map(|c| scale_by_power_of_two(c, i64::from(-exponent)));
    let is_same = |k: usize| scale_by_power_of_two(scaled[k], i64::from(exponent)) == v[k];
    (0..3).all(is_same).then_some(scaled)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numeric::vector::{cross, dot, exact};
    use proptest::prelude::*;

    fn coordinate() -> impl Strategy<Value = f64> {
        prop_oneof![
            2 => -1.0..1.0f64,
            1 => (-3i32..4).prop_map(f64::from),
            1 => any::<f64>().prop_map(|v| if v.is_finite() { v } else { f64::MAX }),
            1 => (-9i32..9).prop_map(|i| f64::from(i) * f64::from_bits(1)),
            1 => (-9i32..9).prop_map(|i| 1.0 + f64::from(i) * f64::EPSILON),
        ]
    }

    fn vector() -> impl Strategy<Value = [f64; 3]> {
        proptest::array::uniform3(coordinate())
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(2000))]

        #[test]
        fn a_sign_that_is_told_is_that_of_the_exact_product(a in vector(), b in vector(), v in vector()) {
            let direction = cross(&exact(a), &exact(b));
            let pairs = PairDirection::new(&direction);
            if let Some(sign) = pairs.certain_sign(&v) {
                prop_assert_eq!(sign, dot(&exact(v), &direction).sign() as i8);
            }
            prop_assert_eq!(pairs.certain_sign(&a), None);
        }
    }

    #[test]
    fn differences_far_below_a_double_are_told() {
        let tiny = f64::from_bits((1023 - 80) << 52);
        let x = Dyadic::from_f64(1.0) + Dyadic::from_f64(tiny);
        let pairs = PairDirection::new(&[x, Dyadic::from_f64(-1.0), Dyadic::zero()]);
        for size in [1.0, f64::from_bits(1), 1e308] {
            assert_eq!(pairs.certain_sign(&[size, size, 0.0]), Some(1));
            assert_eq!(pairs.certain_sign(&[-size, -size, 0.0]), Some(-1));
        }
        assert_eq!(pairs.certain_sign(&[0.0; 3]), None);
    }
}
