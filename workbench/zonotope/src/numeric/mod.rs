//! The ground floor: exact values, exact signs, error bounds, linear algebra; nothing of it is written twice anywhere
//! else.
//!
//! | file | what it holds |
//! |---|---|
//! | `bounded` | doubles with a bound on their error, for filters of a few operations |
//! | `bounded/wide` | the same with a power of two of their own, for numbers of all sizes |
//! | `combined_sum` | sums of vectors with coefficients, to twice the digits of a double |
//! | `double_double/` | numbers of two doubles, with a bound on their error or without |
//! | [`dyadic`] | exact numbers m·2^e, closed under +, −, ×: every double is one |
//! | `exact_linear/` | vectors, spans, inverses and solutions on exact numbers |
//! | `exact_product` | the product of two doubles without rounding |
//! | [`exact_sum`] | the exact sum of any number of doubles |
//! | `lanes/` | passes over vectors: support function, extreme vertex, dot products, in sums side by side |
//! | `linear/` | dot and cross products, determinants and inverses |
//! | [`non_finite`] | the refusal of numbers that are NaN or infinite, with the place where they stand |
//! | [`orientation`] | the sign of a cross product of edges between points, exactly; of a determinant of directions |
//! | `outward` | directed rounding: the nearest double on a given side of an exact number |
//! | `reused` | lists whose memory a thread keeps for its next question |
//! | [`scaling`] | powers of two, and differences that do not overflow |
//! | `short_dyadic` | exact numbers m·2^e of at most 127 bits, without memory of their own |
//! | `signed_sum` | sums of vectors with signs, exactly, by blocks |
//! | `subsets` | subsets of one size, in order |
//! | [`tolerance`] | every named constant of a rounding-error bound, with its derivation |
//! | `weighted_median` | where weights, added up in order, reach a target |

pub(crate) mod bounded;
pub(crate) mod combined_sum;
pub(crate) mod double_double;
pub mod dyadic;
pub(crate) mod exact_linear;
pub(crate) mod exact_product;
pub mod exact_sum;
pub(crate) mod lanes;
pub(crate) mod linear;
pub mod non_finite;
pub mod orientation;
pub(crate) mod outward;
pub(crate) mod reused;
pub mod scaling;
pub(crate) mod short_dyadic;
pub(crate) mod signed_sum;
pub(crate) mod subsets;
pub mod tolerance;
pub(crate) mod weighted_median;

pub use dashu_ratio::RBig as Rational;
