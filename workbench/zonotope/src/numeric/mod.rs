//! The numeric ground: exact values, exact sums, exact signs, named tolerances.
//!
//! | file | what it decides |
//! |---|---|
//! | `approximation` | values within a known error, to about 98 bits |
//! | `bounded` | doubles with a bound on their error, for filters of a few operations |
//! | [`dyadic`] | exact numbers m·2^e, closed under +, −, ×: every double is one |
//! | `exact_product` | the product of two doubles without rounding |
//! | [`exact_sum`] | the exact sum of any number of doubles |
//! | [`orientation`] | the sign of a cross product of edges between points, exactly |
//! | `pair` | numbers of two doubles, without a bound |
//! | [`tolerance`] | every named constant of a rounding-error bound, with its derivation |
//! | `vector` | vectors of space with exact coordinates |

pub(crate) mod approximation;
pub(crate) mod bounded;
pub mod dyadic;
pub(crate) mod exact_product;
pub mod exact_sum;
pub(crate) mod lanes;
pub mod orientation;
pub(crate) mod pair;
pub(crate) mod signed_sum;
pub mod tolerance;
pub(crate) mod vector;

pub use dashu_ratio::RBig as Rational;
