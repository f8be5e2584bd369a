//! Every named constant of a rounding-error bound, with its derivation.
//!
//! None of these is a tolerance within which two values would be called equal: they bound how far a computed value may be
//! from the exact one, so that a filter knows when its sign is certain.

/// Half a unit in the last place of 1: |round(x) − x| ≤ UNIT · |x| for every normal result.
pub const UNIT: f64 = f64::EPSILON / 2.0;

/// An absolute error that covers every underflow of a computation whose data were scaled to magnitude at most 2.
///
/// One operation that underflows is off by at most 2^-1075. Scaled data carry that error into a handful of products
/// with factors of magnitude below 2^60, which stays far below 2^-960.
pub const UNDERFLOW: f64 = f64::from_bits((1023 - 960) << 52);
