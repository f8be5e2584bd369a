//! Separation by one pass in doubles: whether a direction u has u · p > h(u), with every rounding error bounded.

use super::seam::generators::Generators;
use crate::numeric::bounded::{self, BoundedVector};
use crate::numeric::linear::dot;

/// Whether u · p > h(u), proved by one pass in doubles.
pub(crate) fn separates<G: Generators + ?Sized>(generators: &G, p: &BoundedVector, u: &[f64; 3]) -> bool {
    (dot(p, &bounded::exact(*u)) - generators.support(u)).is_positive()
}
