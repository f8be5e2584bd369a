//! Shorthand for exact rationals.

use dashu_ratio::RBig;

/// The integer `value`.
pub(crate) fn integer(value: i64) -> RBig {
    RBig::from(value)
}

/// The fraction `numerator / denominator`.
pub(crate) fn fraction(numerator: i64, denominator: i64) -> RBig {
    RBig::from(numerator) / RBig::from(denominator)
}

/// The exact value of a finite double.
pub(crate) fn exactly(value: f64) -> RBig {
    RBig::try_from(value).expect("the library's coordinates are finite")
}
