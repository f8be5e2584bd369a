//! The support function of the generators of a question, in doubles with a bound of its error.

use crate::collision::Displacement;
use crate::numeric::bounded::{self, Bounded, BoundedVector};
use crate::zonotope::passes::bounded_sum;

/// Whether u · p > h(u), proved by one pass in doubles.
pub(crate) fn separates(question: &Displacement<'_, 3>, p: &BoundedVector, u: &[f64; 3]) -> bool {
    (bounded::dot(p, &bounded::exact(*u)) - reach(question, u)).is_positive()
}

/// h(u).
pub(crate) fn reach(question: &Displacement<'_, 3>, u: &[f64; 3]) -> Bounded {
    let [first, second] = question.runs();
    if second.is_empty() { bounded_sum(first, u) } else { bounded_sum(first, u) + bounded_sum(second, u) }
}
