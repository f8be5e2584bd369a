//! Dot products and cross products.

use super::Ring;

/// a · b.
#[inline(always)]
pub(crate) fn dot<T: Ring, const D: usize>(a: &[T; D], b: &[T; D]) -> T {
    if D == 0 {
        return T::ZERO;
    }
    let mut sum = a[0].times(&b[0]);
    for k in 1..D {
        sum = sum.plus(&a[k].times(&b[k]));
    }
    sum
}

/// Σ a_k b_k over as many terms as both have; 0 for none.
pub(crate) fn sum_of_products<T: Ring>(a: &[T], b: &[T]) -> T {
    let mut sum: Option<T> = None;
    for (a, b) in a.iter().zip(b) {
        if !(a.is_exactly_zero() || b.is_exactly_zero()) {
            let term = a.times(b);
            sum = Some(sum.map_or_else(|| term.clone(), |sum| sum.plus(&term)));
        }
    }
    sum.unwrap_or(T::ZERO)
}

/// Adds a multiple of one vector to another, over as many coordinates as both have.
#[inline]
pub(crate) fn add_multiple(sum: &mut [f64], factor: f64, vector: &[f64]) {
    sum.iter_mut().zip(vector).for_each(|(s, v)| *s += factor * v);
}

/// A vector of space less a multiple of another one.
#[inline(always)]
pub(crate) fn less_multiple(a: [f64; 3], factor: f64, b: &[f64; 3]) -> [f64; 3] {
    [a[0] - factor * b[0], a[1] - factor * b[1], a[2] - factor * b[2]]
}

/// a × b.
#[inline(always)]
pub(crate) fn cross<T: Ring>(a: &[T; 3], b: &[T; 3]) -> [T; 3] {
    let minor = |i: usize, j: usize| a[i].times(&b[j]).minus(&a[j].times(&b[i]));
    [minor(1, 2), minor(2, 0), minor(0, 1)]
}

/// b × c, c × a and a × b: each is orthogonal to two of the vectors, and its product with the third is det(a, b, c).
/// Divided by that determinant they are the rows of the inverse of the matrix with columns a, b, c.
#[inline(always)]
pub(crate) fn cyclic_cross_products<T: Ring>(a: &[T; 3], b: &[T; 3], c: &[T; 3]) -> [[T; 3]; 3] {
    [cross(b, c), cross(c, a), cross(a, b)]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numeric::Rational;
    use crate::numeric::dyadic::Dyadic;

    #[test]
    fn products_by_hand_over_doubles_and_exact_numbers() {
        let (a, b, c) = ([1.0, 2.0, 3.0], [4.0, 5.0, 6.0], [7.0, 8.0, 10.0]);
        assert_eq!((dot(&a, &b), cross(&a, &b)), (32.0, [-3.0, 6.0, -3.0]));
        for (dual, vector) in cyclic_cross_products(&a, &b, &c).iter().zip([a, b, c]) {
            assert_eq!(dot(dual, &vector), -3.0);
        }
        let exact = |v: [f64; 3]| v.map(Dyadic::from_f64);
        assert_eq!(cross(&exact(a), &exact(b)), exact([-3.0, 6.0, -3.0]));
        assert_eq!(sum_of_products(&exact(a), &exact(c)), Dyadic::from_f64(53.0));
        assert_eq!(sum_of_products::<Rational>(&[], &[]), Rational::ZERO);
    }
}
