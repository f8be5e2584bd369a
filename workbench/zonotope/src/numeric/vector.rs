//! Vectors of space with exact coordinates.

use super::dyadic::Dyadic;

/// An exact vector.
pub(crate) type ExactVector = [Dyadic; 3];

/// The exact value of a vector of doubles.
pub(crate) fn exact(v: [f64; 3]) -> ExactVector {
    v.map(Dyadic::from_f64)
}

/// a · b.
pub(crate) fn dot([a, b, c]: &ExactVector, [d, e, f]: &ExactVector) -> Dyadic {
    a * d + b * e + c * f
}

/// a × b.
pub(crate) fn cross([a, b, c]: &ExactVector, [d, e, f]: &ExactVector) -> ExactVector {
    [b * f - c * e, c * d - a * f, a * e - b * d]
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
