//! The sign of v · u for an exact direction u, in numbers of two doubles: they tell it for nearly every vector that is
//! not orthogonal to u.
//!
//! Each coordinate of u is rounded once, to about 98 bits with an exponent of its own, and so is each product. So the
//! sizes of coordinates and vectors may be any distance apart. The product of v with the first doubles alone, which
//! takes a thirtieth of the time, comes first: it is far enough from 0 for most vectors.

use super::BoundedDoubleDouble;
use crate::numeric::dyadic::Dyadic;
use crate::numeric::scaling::{binary_exponent, scale_by_power_of_two};
use crate::numeric::tolerance::{PAIRABLE_EXPONENT, PAIRABLE_SIZES, PRODUCT_OF_ROUNDED_VECTORS, PRODUCT_UNDERFLOW};

/// An exact direction of space, rounded to two doubles a coordinate.
pub(crate) struct DoubleDoubleDirection {
    /// Each coordinate divided by the power of two below it, and the exponent of that power; `None` for a zero.
    terms: [Option<(BoundedDoubleDouble, i64)>; 3],
    /// The coordinates themselves, scaled by the same power of two, if they are of moderate size.
    moderate: Option<[BoundedDoubleDouble; 3]>,
}

impl DoubleDoubleDirection {
    /// The rounded coordinates of an exact direction.
    pub(crate) fn of(direction: &[Dyadic; 3]) -> Self {
        let terms = direction.each_ref().map(|c| {
            let exponent = c.binary_exponent()?;
            Some((BoundedDoubleDouble::of(&c.clone().scaled(-exponent)), exponent))
        });
        let largest = terms.iter().flatten().map(|(_, exponent)| *exponent).max().unwrap_or(0);
        let is_moderate = terms.iter().flatten().all(|(_, exponent)| largest - exponent < PAIRABLE_EXPONENT);
        let scaled = |term: Option<(BoundedDoubleDouble, i64)>| {
            term.map_or(BoundedDoubleDouble::exact(0.0), |(coordinate, exponent)| coordinate.scaled(exponent - largest))
        };
        Self { terms, moderate: is_moderate.then(|| terms.map(scaled)) }
    }

    /// The sign of v · u, if two doubles a coordinate tell it and it is not zero.
    pub(crate) fn certain_sign(&self, v: &[f64; 3]) -> Option<i8> {
        if let Some(direction) = &self.moderate {
            let [x, y, z] = [0, 1, 2].map(|k| direction[k].high * v[k]);
            let (value, size) = (x + y + z, x.abs() + y.abs() + z.abs());
            if value.abs() > PRODUCT_OF_ROUNDED_VECTORS * size + PRODUCT_UNDERFLOW {
                return Some(if value > 0.0 { 1 } else { -1 });
            }
        }
        if let Some(product) = self.moderate_product(v) {
            return product.sign();
        }
        let terms = [0, 1, 2].map(|k| {
            let ((coordinate, own), exponent) = (self.terms[k]?, i64::from(binary_exponent(v[k])?));
            Some((coordinate * BoundedDoubleDouble::exact(scale_by_power_of_two(v[k], -exponent)), own + exponent))
        });
        let largest = terms.iter().flatten().map(|(_, exponent)| *exponent).max()?;
        let sum = terms
            .into_iter()
            .flatten()
            .fold(BoundedDoubleDouble::exact(0.0), |sum, (term, exponent)| sum + term.scaled(exponent - largest));
        sum.sign()
    }

    /// v · u, scaled by a power of two that is the same for all v, where all sizes are moderate.
    pub(crate) fn moderate_product(&self, v: &[f64; 3]) -> Option<BoundedDoubleDouble> {
        let is_moderate = |c: &f64| *c == 0.0 || PAIRABLE_SIZES.contains(&c.abs());
        let direction = self.moderate.as_ref().filter(|_| v.iter().all(is_moderate))?;
        let [x, y, z] = [0, 1, 2].map(|k| direction[k] * BoundedDoubleDouble::exact(v[k]));
        Some(x + y + z)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numeric::exact_linear::{cross, dot, exact};
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

    properties! {
        #![proptest_config(crate::property_cases::config(2000))]

        #[test]
        fn a_sign_that_is_told_is_that_of_the_exact_product(a in vector(), b in vector(), v in vector()) {
            let direction = cross(&exact(a), &exact(b));
            let rounded = DoubleDoubleDirection::of(&direction);
            if let Some(sign) = rounded.certain_sign(&v) {
                prop_assert_eq!(sign, dot(&exact(v), &direction).sign() as i8);
            }
            prop_assert_eq!(rounded.certain_sign(&a), None);
        }
    }

    #[test]
    fn differences_far_below_a_double_are_told() {
        let tiny = f64::from_bits((1023 - 80) << 52);
        let x = Dyadic::from_f64(1.0) + Dyadic::from_f64(tiny);
        let rounded = DoubleDoubleDirection::of(&[x, Dyadic::from_f64(-1.0), Dyadic::zero()]);
        for size in [1.0, f64::from_bits(1), 1e308] {
            assert_eq!(rounded.certain_sign(&[size, size, 0.0]), Some(1));
            assert_eq!(rounded.certain_sign(&[-size, -size, 0.0]), Some(-1));
        }
        assert_eq!(rounded.certain_sign(&[0.0; 3]), None);
    }
}
