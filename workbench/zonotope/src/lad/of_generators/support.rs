//! The support function of the generators of a query, in doubles with a bound of its error.

use crate::numeric::bounded::{self, Bounded, BoundedVector};
use crate::numeric::linear::dot;
use crate::zonotope::passes::bounded_sum;
use crate::zonotope::query::Query;

/// Whether u · p > h(u), proved by one pass in doubles.
pub(crate) fn separates(query: &Query<'_, 3>, p: &BoundedVector, u: &[f64; 3]) -> bool {
    (dot(p, &bounded::exact(*u)) - reach(query, u)).is_positive()
}

/// h(u).
pub(crate) fn reach(query: &Query<'_, 3>, u: &[f64; 3]) -> Bounded {
    let [first, second] = query.runs();
    if second.is_empty() { bounded_sum(first, u) } else { bounded_sum(first, u) + bounded_sum(second, u) }
}
