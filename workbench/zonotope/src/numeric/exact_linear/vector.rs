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
