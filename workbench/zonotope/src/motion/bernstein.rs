//! Polynomials on [0, 1] by their scaled Bernstein coefficients: Σ c_k s^k (1 − s)^(n − k), that is, each Bernstein
//! coefficient times its binomial coefficient.
//!
//! A product is then a convolution without a division, and where all coefficients are positive, so is the polynomial.

use crate::numeric::linear::Ring;

/// The product of two polynomials: the coefficients of the degree that is the sum of both.
#[inline]
pub(super) fn convolution<T: Ring, const A: usize, const B: usize, const C: usize>(a: &[T; A], b: &[T; B]) -> [T; C] {
    const { assert!(C + 1 == A + B, "degrees add up") }
    std::array::from_fn(|k| {
        let first = k.saturating_sub(B - 1);
        let last = k.min(A - 1);
        let terms = (first + 1..=last).map(|i| a[i].times(&b[k - i]));
        terms.fold(a[first].times(&b[k - first]), |sum, term| sum.plus(&term))
    })
}

/// The same polynomial by the coefficients of the next degree.
#[inline]
pub(super) fn elevated<T: Ring, const A: usize, const B: usize>(a: &[T; A]) -> [T; B] {
    convolution(a, &[T::ONE, T::ONE])
}

/// The sum of two polynomials of one degree.
#[inline]
pub(super) fn sum<T: Ring, const A: usize>(a: &[T; A], b: &[T; A]) -> [T; A] {
    std::array::from_fn(|k| a[k].plus(&b[k]))
}

/// The difference of two polynomials of one degree.
#[inline]
pub(super) fn difference<T: Ring, const A: usize>(a: &[T; A], b: &[T; A]) -> [T; A] {
    std::array::from_fn(|k| a[k].minus(&b[k]))
}

/// The multiple of a polynomial.
#[inline]
pub(super) fn multiple<T: Ring, const A: usize>(factor: &T, a: &[T; A]) -> [T; A] {
    a.each_ref().map(|c| factor.times(c))
}

/// The number of times that a polynomial with a coefficient that is not positive is halved, at most.
const MOST_HALVINGS: u32 = 4;

/// The inverses of the binomial coefficients of degree 5, that of a gap (two squares of quaternions and a path): those
/// of scaled Bernstein coefficients.
pub(super) const INVERSE_BINOMIALS: [f64; 6] = [1.0, 0.2, 0.1, 0.1, 0.2, 1.0];

/// The Bernstein coefficients, not scaled.
pub(super) fn unscaled(a: &[f64; 6]) -> [f64; 6] {
    std::array::from_fn(|k| a[k] * INVERSE_BINOMIALS[k])
}

/// Whether a polynomial by its coefficients, not scaled, is above a number that is not negative on [0, 1], as the
/// coefficients of its parts tell it.
pub(super) fn is_above(a: &[f64; 6], least: f64) -> bool {
    is_above_within(a, least, MOST_HALVINGS)
}

fn is_above_within(a: &[f64; 6], least: f64, halvings: u32) -> bool {
    if a.iter().all(|c| *c > least) {
        return true;
    }
    // at its ends the polynomial is the first and the last coefficient
    if halvings == 0 || a.iter().any(|c| c.is_nan()) || a[0] <= least || a[5] <= least {
        return false;
    }
    let (mut rest, mut left, mut right) = (*a, [a[0]; 6], [a[5]; 6]);
    for step in 1..6 {
        for k in 0..6 - step {
            rest[k] = (rest[k] + rest[k + 1]) / 2.0;
        }
        (left[step], right[5 - step]) = (rest[0], rest[5 - step]);
    }
    is_above_within(&left, least, halvings - 1) && is_above_within(&right, least, halvings - 1)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The value of a polynomial at s.
    fn value<const A: usize>(coefficients: &[f64; A], s: f64) -> f64 {
        let degree = A as i32 - 1;
        (0..).zip(coefficients).map(|(k, c)| c * s.powi(k) * (1.0 - s).powi(degree - k)).sum()
    }

    #[test]
    fn a_polynomial_with_a_negative_coefficient_is_positive_by_its_halves() {
        // 1 − 4 s (1 − s) · 0.9 has the least value 0.1 at the middle
        let bump = |height: f64| -> [f64; 6] {
            let quadratic = [1.0, 2.0 - 4.0 * height, 1.0];
            unscaled(&elevated::<f64, 5, 6>(&elevated::<f64, 4, 5>(&elevated::<f64, 3, 4>(&quadratic))))
        };
        assert!(bump(0.9).iter().any(|c| *c < 0.0));
        assert!(is_above(&bump(0.9), 0.09) && !is_above(&bump(0.9), 0.11) && !is_above(&bump(1.01), 0.0));
        assert!(!is_above(&[f64::NAN; 6], 0.0));
    }

    #[test]
    fn products_and_elevations_have_the_values_of_their_factors() {
        let (a, b) = ([1.0, -4.0, 2.0], [3.0, 5.0]);
        let c: [f64; 4] = convolution(&a, &b);
        assert_eq!(c, [3.0, -7.0, -14.0, 10.0]);
        let higher: [f64; 4] = elevated(&a);
        for s in [0.0, 0.25, 0.5, 1.0] {
            assert_eq!(value(&c, s), value(&a, s) * value(&b, s));
            assert_eq!(value(&higher, s), value(&a, s));
            assert_eq!(value(&difference(&sum(&a, &a), &multiple(&3.0, &a)), s), -value(&a, s));
        }
    }
}
