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
    use crate::numeric::scaling::power_of_two;
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

    fn powers(exponents: [i64; 3]) -> [Dyadic; 3] {
        exponents.map(|exponent| Dyadic::one().scaled(exponent))
    }

    #[test]
    fn moderate_products_are_the_exact_ones_times_a_power_of_two() {
        let direction = [3.0, -5.0, 0.75].map(|c| Dyadic::from_f64(c).scaled(40));
        let rounded = DoubleDoubleDirection::of(&direction);
        for v in [[1.0, 2.0, 3.0], [0.0, -7.0, 0.1], [1e-80, 1e80, 0.0], [0.0; 3], [5.0, 3.0, 1e-30]] {
            let product = rounded.moderate_product(&v).expect("all sizes are moderate");
            // The power of two below the largest coordinate is 2^42.
            let off = (product.to_dyadic() - dot(&exact(v), &direction).scaled(-42)).abs();
            let (_, error) = product.parts();
            let size = v.iter().map(|c| c.abs()).sum::<f64>();
            assert!(off <= Dyadic::from_f64(error), "{v:?}");
            assert!(error <= size * power_of_two(-92) + power_of_two(-950), "{v:?}");
        }
    }

    #[test]
    fn products_are_moderate_where_all_sizes_are() {
        let v = [1.0; 3];
        for (exponent, is_moderate) in [(-299, true), (-300, false), (-301, false), (299, true), (300, false)] {
            let direction = DoubleDoubleDirection::of(&powers([0, exponent, 0]));
            assert_eq!(direction.moderate_product(&v).is_some(), is_moderate, "{exponent}");
            assert_eq!(direction.certain_sign(&v), Some(1), "{exponent}");
        }
        let direction = DoubleDoubleDirection::of(&powers([0; 3]));
        for (size, is_moderate) in [(0.0, true), (power_of_two(-300), true), (1e-300, false), (1e300, false)] {
            assert_eq!(direction.moderate_product(&[1.0, size, size]).is_some(), is_moderate, "{size:e}");
            assert_eq!(direction.certain_sign(&[1.0, size, size]), Some(1), "{size:e}");
        }
    }

    #[test]
    fn terms_beyond_the_doubles_tell_no_sign() {
        let direction = DoubleDoubleDirection::of(&[1.875, -1.0, -1.0].map(Dyadic::from_f64));
        assert_eq!(direction.certain_sign(&[f64::MAX; 3]), Some(-1));
        assert_eq!(direction.certain_sign(&[-f64::MAX; 3]), Some(1));
    }
}
