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

#[cfg(test)]
mod tests {
    use super::*;

    /// The value of a polynomial at s.
    fn value<const A: usize>(coefficients: &[f64; A], s: f64) -> f64 {
        let degree = A as i32 - 1;
        (0..).zip(coefficients).map(|(k, c)| c * s.powi(k) * (1.0 - s).powi(degree - k)).sum()
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
