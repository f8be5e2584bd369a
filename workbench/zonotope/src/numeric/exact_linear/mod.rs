//! Linear algebra on exact numbers: what decides ranks, spans and solutions without rounding.
//!
//! | file | what it computes |
//! |---|---|
//! | `vector` | vectors of space with exact coordinates |
//! | `elimination` | inverses, solutions and dependences, in rationals |
//! | `simplex` | linear programs in rationals |
//! | `root` | square roots of exact fractions, which lengths are, rounded down, up and to the nearest double |
//! | `span` | the span of vectors: rank, coordinates that tell its vectors apart, directions orthogonal to it |
//!
//! Dot and cross products, determinants and normals are those of [`linear`](super::linear), over exact numbers.

mod elimination;
pub(crate) mod root;
pub(crate) mod simplex;
mod span;
mod vector;

pub(crate) use elimination::{dependence, inverse, solve};
pub(crate) use span::Span;
pub(crate) use vector::{
    ExactVector, difference, doubles, exact, is_zero, multiple, negated, rational, rounded_direction, sum,
};

pub(crate) use super::linear::{cross, determinant, dot, hyperplane_normal, sum_of_products};
