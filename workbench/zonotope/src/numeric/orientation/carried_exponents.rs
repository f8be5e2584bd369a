//! The sign of a determinant of vectors whose coordinates differ by hundreds of orders of magnitude.
//!
//! # Method
//! Each coordinate is taken apart into a number in [1, 2) and a power of two. The six products of the determinant are
//! products of the numbers and sums of the exponents, so none of them leaves the doubles, and they are summed in terms
//! of the largest power of two among them.
//!
//! # Why this way
//! One scale for each vector is not enough here, as the products of its small coordinates underflow, and long integers
//! would have as many digits as the exponents are apart: a hundred times the time.

use std::cmp::Ordering;

use crate::numeric::scaling::{binary_exponent, scale_by_power_of_two};
use crate::numeric::tolerance::DETERMINANT_3X3;

/// The positions of the factors of each product of det(a, b, c), and its sign.
const PRODUCTS: [([usize; 3], f64); 6] =
    [([0, 1, 2], 1.0), ([0, 2, 1], -1.0), ([1, 2, 0], 1.0), ([1, 0, 2], -1.0), ([2, 0, 1], 1.0), ([2, 1, 0], -1.0)];

/// The sign of det(a, b, c) for any finite vectors, if products with a few roundings each decide it.
///
/// A product is rounded twice and summed with five others, seven roundings for each of them. The largest product has
/// magnitude 1 at least, so that those below 2^-1000, which are left out, are far less than the roundings.
pub(super) fn determinant_sign(a: &[f64; 3], b: &[f64; 3], c: &[f64; 3]) -> Option<Ordering> {
    let parts = [a, b, c].map(|vector| vector.map(taken_apart));
    let product = |(at, sign): ([usize; 3], f64)| {
        let [(x, i), (y, j), (z, k)] = [parts[0][at[0]], parts[1][at[1]], parts[2][at[2]]];
        (sign * x * y * z, i + j + k)
    };
    let products = PRODUCTS.map(product);
    let largest = products.iter().filter(|(number, _)| *number != 0.0).map(|(_, exponent)| *exponent).max();
    let Some(largest) = largest else { return Some(Ordering::Equal) };
    let [mut sum, mut magnitude] = [0.0; 2];
    for (number, exponent) in products {
        let below = exponent - largest;
        if below >= -1000 && number != 0.0 {
            let term = scale_by_power_of_two(number, i64::from(below));
            sum += term;
            magnitude += f64::abs(term);
        }
    }
    (f64::abs(sum) > 2.0 * DETERMINANT_3X3 * magnitude).then(|| sum.total_cmp(&0.0))
}

/// A number in [1, 2), or 0, and the exponent of the power of two that it is multiplied with.
fn taken_apart(value: f64) -> (f64, i32) {
    binary_exponent(value).map_or((0.0, 0), |exponent| (scale_by_power_of_two(value, -i64::from(exponent)), exponent))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numeric::exact_linear::{cross, dot, exact};
    use proptest::prelude::*;

    fn vector() -> impl Strategy<Value = [f64; 3]> {
        let coordinate = || any::<u64>().prop_map(f64::from_bits).prop_filter("finite", |value| value.is_finite());
        [coordinate(), coordinate(), coordinate()]
    }

    properties! {
        #![proptest_config(crate::property_cases::config(2_000))]

        #[test]
        fn a_sign_that_is_told_is_that_of_exact_arithmetic(a in vector(), b in vector(), c in vector(), k in -3i32..4) {
            let near: [f64; 3] = std::array::from_fn(|i| a[i] + f64::from(k) * b[i]);
            for c in [c, near] {
                if c.iter().all(|x| x.is_finite()) && let Some(sign) = determinant_sign(&a, &b, &c) {
                    prop_assert_eq!(sign, dot(&exact(a), &cross(&exact(b), &exact(c))).sign());
                }
            }
        }

        #[test]
        fn vectors_drawn_from_all_doubles_are_decided(a in vector(), b in vector(), c in vector()) {
            prop_assert!(determinant_sign(&a, &b, &c).is_some());
        }
    }

    #[test]
    fn vanishing_products_are_a_sign_of_zero() {
        let vector = [1e300, 0.0, 0.0];
        assert_eq!(determinant_sign(&vector, &vector, &vector), Some(Ordering::Equal));
    }

    #[test]
    fn a_sum_decides_where_it_is_larger_than_its_bound() {
        let size = 2f64.powi(1000);
        let sign = |p: f64, q: f64| determinant_sign(&[size, 0.0, 0.0], &[0.0, p, 1.0], &[0.0, q, 1.0]);
        let unit = 2f64.powi(-49);
        let (p, q) = (1.0 + unit, 1.0 - unit);
        assert_eq!((p - q, p + q), (2.0 * unit, 2.0));
        assert_eq!([sign(p, q), sign(q, p), sign(1.0, 1.0)], [None; 3]);
        assert_eq!([sign(p.next_up(), q), sign(q, p.next_up())], [Some(Ordering::Greater), Some(Ordering::Less)]);
    }
}
