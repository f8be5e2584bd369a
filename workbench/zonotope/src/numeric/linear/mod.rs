//! Small vectors and matrices over any numbers: doubles, doubles with a bound on their error, pairs of doubles, exact
//! ones.
//!
//! | file | what it computes |
//! |---|---|
//! | `ring` | what numbers must be able to do: add, subtract, multiply |
//! | `products` | dot and cross products |
//! | `minors` | determinants, and normals of hyperplanes (the cross product of d − 1 vectors of R^d) |
//! | `inverse` | inverses of matrices of doubles |
//! | `norms` | norms of vectors of space in doubles |
//!
//! Sums are taken from the first term on, in the order of the coordinates: in doubles, a result is the same wherever it
//! is computed.

mod inverse;
mod minors;
mod norms;
mod products;
mod ring;
mod symmetric;

pub(crate) use inverse::{inverse, invert};
pub(crate) use minors::{determinant, hyperplane_normal};
pub(crate) use norms::{euclidean_norm, max_norm, norm_of_any_size, sum_norm};
pub(crate) use products::{add_multiple, cross, cyclic_cross_products, dot, sum_of_products};
pub(crate) use ring::{Ring, ring_of_values};
pub(crate) use symmetric::SymmetricMatrix;
