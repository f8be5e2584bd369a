//! Polynomials on [0, 1] by scaled Bernstein coefficients: Σ c_k s^k (1 − s)^(n − k), the binomial coefficients left
//! in.
//!
//! The product is a convolution. Where the first and the last coefficient are positive and no other is negative, the
//! polynomial is positive on all of [0, 1]: at the ends it is these two, and between all terms are at least 0 and the
//! first is not.

use dashu_int::IBig;

use super::quaternion::Vector;

/// A polynomial, its degree one less than the number of coefficients.
pub(super) type Polynomial = Vec<IBig>;

pub(super) fn product(a: &[IBig], b: &[IBig]) -> Polynomial {
    let mut all = vec![IBig::ZERO; a.len() + b.len() - 1];
    for (i, a) in a.iter().enumerate() {
        for (j, b) in b.iter().enumerate() {
            all[i + j] += a * b;
        }
    }
    all
}

/// The sum of polynomials of any degrees.
pub(super) fn sum(parts: &[Polynomial]) -> Polynomial {
    let length = parts.iter().map(Vec::len).max().unwrap_or(1);
    let mut all = vec![IBig::ZERO; length];
    for part in parts {
        let mut raised = part.clone();
        while raised.len() < length {
            raised = product(&raised, &[IBig::ONE, IBig::ONE]);
        }
        all.iter_mut().zip(raised).for_each(|(sum, c)| *sum += c);
    }
    all
}

/// Sums of what a bilinear form makes of the coefficients of two polynomials: the polynomial that it makes of both.
pub(super) fn combined<A, B, C>(
    a: &[A],
    b: &[B],
    zero: C,
    term: impl Fn(&A, &B) -> C,
    add: impl Fn(&C, &C) -> C,
) -> Vec<C>
where
    C: Clone,
{
    let mut all = vec![zero; a.len() + b.len() - 1];
    for (i, a) in a.iter().enumerate() {
        for (j, b) in b.iter().enumerate() {
            all[i + j] = add(&all[i + j], &term(a, b));
        }
    }
    all
}

/// u · v of two vectors whose coordinates are polynomials.
pub(super) fn dot(u: &[Vector], v: &[Vector]) -> Polynomial {
    combined(u, v, IBig::ZERO, super::quaternion::dot, |a, b| a + b)
}

/// Whether the coefficients show that the polynomial is positive on [0, 1].
pub(super) fn is_positive(polynomial: &[IBig]) -> bool {
    let ends = [polynomial.first(), polynomial.last()];
    ends.iter().all(|end| end.is_some_and(|c| *c > IBig::ZERO)) && polynomial.iter().all(|c| *c >= IBig::ZERO)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(numbers: &[i32]) -> Polynomial {
        numbers.iter().copied().map(IBig::from).collect()
    }

    #[test]
    fn arithmetic_by_hand() {
        assert_eq!(product(&of(&[1, -4, 2]), &of(&[3, 5])), of(&[3, -7, -14, 10]));
        // 1 of degree 2 is s² + 2 s (1 − s) + (1 − s)².
        assert_eq!(sum(&[of(&[1]), of(&[0, 3, 0])]), of(&[1, 5, 1]));
        assert!(is_positive(&of(&[1, 0, 2])) && is_positive(&of(&[5])));
        for touching in [&[0, 1, 2][..], &[1, -1, 2], &[1, 1, 0], &[0]] {
            assert!(!is_positive(&of(touching)), "{touching:?}");
        }
    }
}
