//! Vectors of space with exact coordinates.

use crate::numeric::Rational;
use crate::numeric::dyadic::Dyadic;

/// An exact vector.
pub(crate) type ExactVector = [Dyadic; 3];

/// The exact value of a vector of doubles.
pub(crate) fn exact<const D: usize>(v: [f64; D]) -> [Dyadic; D] {
    v.map(Dyadic::from_f64)
}

/// The exact value of a double, as a fraction.
pub(crate) fn rational(value: f64) -> Rational {
    Dyadic::from_f64(value).to_rational()
}

/// −a.
pub(crate) fn negated(a: ExactVector) -> ExactVector {
    a.map(|v| -v)
}

/// a + b.
pub(crate) fn sum([a, b, c]: &ExactVector, [d, e, f]: &ExactVector) -> ExactVector {
    [a + d, b + e, c + f]
}

/// a − b.
pub(crate) fn difference([a, b, c]: &ExactVector, [d, e, f]: &ExactVector) -> ExactVector {
    [a - d, b - e, c - f]
}

/// factor · a.
pub(crate) fn multiple(factor: &Dyadic, [a, b, c]: &ExactVector) -> ExactVector {
    [factor * a, factor * b, factor * c]
}

/// Whether a is zero.
pub(crate) fn is_zero(a: &ExactVector) -> bool {
    a.iter().all(Dyadic::is_zero)
}

/// The direction of a as doubles, scaled by a power of two so that its largest coordinate has magnitude in [1, 2].
pub(crate) fn rounded_direction(a: &ExactVector) -> [f64; 3] {
    let exponent = a.iter().filter_map(Dyadic::binary_exponent).max().unwrap_or(0);
    [0, 1, 2].map(|i| a[i].clone().scaled(-exponent).to_f64())
}

/// A vector of exact numbers as doubles, if each of them is one.
pub(crate) fn doubles<const D: usize>(exact: &[Dyadic; D]) -> Option<[f64; D]> {
    let rounded = exact.each_ref().map(Dyadic::to_f64);
    let is_double = |c: usize| rounded[c].is_finite() && Dyadic::from_f64(rounded[c]) == exact[c];
    (0..D).all(is_double).then_some(rounded)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn vectors_worked_out_by_hand() {
        let (a, b) = (exact([1.0, -2.0, 4.0]), exact([3.0, 5.0, -7.0]));
        assert_eq!(negated(a.clone()), exact([-1.0, 2.0, -4.0]));
        assert_eq!(sum(&a, &b), exact([4.0, 3.0, -3.0]));
        assert_eq!(difference(&a, &b), exact([-2.0, -7.0, 11.0]));
        assert_eq!(multiple(&Dyadic::from_f64(3.0), &a), exact([3.0, -6.0, 12.0]));
        assert_eq!(rational(-0.75), Rational::from_parts((-3).into(), 4u8.into()));
        assert_eq!(
            [[0.0, 0.0, 0.0], [0.0, 1.0, 0.0], [1.0, 1.0, 1.0]].map(|v| is_zero(&exact(v))),
            [true, false, false]
        );
    }

    #[test]
    fn directions_are_rounded_at_size_one_whatever_size_they_have() {
        let a = exact([-3.0, 0.5, 0.0]);
        for exponent in [-3000, 0, 3000] {
            let scaled = a.clone().map(|v| v.scaled(exponent));
            assert_eq!(rounded_direction(&scaled), [-1.5, 0.25, 0.0]);
        }
        assert_eq!(rounded_direction(&exact([0.0; 3])), [0.0; 3]);
    }

    #[test]
    fn vectors_are_doubles_where_each_coordinate_is_one() {
        let v = [1.0, f64::from_bits(1), -f64::MAX];
        assert_eq!(doubles(&exact(v)), Some(v));
        let [one, bit] = [0, -60].map(|exponent| Dyadic::one().scaled(exponent));
        assert_eq!(doubles(&[one.clone(), one.clone() + bit]), None);
        assert_eq!(doubles(&[one.clone(), one.scaled(1024)]), None);
    }
}
