//! Linear algebra on exact numbers: what decides ranks, spans and solutions without rounding.
//!
//! | file | what it computes |
//! |---|---|
//! | `vector` | vectors of space with exact coordinates |
//! | `fixed_point` | long sums of doubles and of products, in words that stay where they are |
//! | `elimination` | inverses, solutions and dependences, in rationals |
//! | `simplex` | linear programs in rationals |
//! | `root` | square roots of exact fractions, which lengths are, rounded down, up and to the nearest double |
//! | `span` | the span of vectors: rank, coordinates that tell its vectors apart, directions orthogonal to it |
//!
//! Dot and cross products, determinants and normals are those of [`linear`](super::linear), over exact numbers.

mod elimination;
mod fixed_point;
pub(crate) mod root;
pub(crate) mod simplex;
mod span;
mod vector;

pub(crate) use elimination::{dependence, inverse, solve};
pub(crate) use fixed_point::{BitRange, FixedPoint};
pub(crate) use span::Span;
pub(crate) use vector::{
    ExactVector, difference, doubles, exact, is_zero, multiple, negated, rational, rounded_direction, sum,
};

pub(crate) use super::linear::{cross, cyclic_cross_products, determinant, dot, hyperplane_normal, sum_of_products};
