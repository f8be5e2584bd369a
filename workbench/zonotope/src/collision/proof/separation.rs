//! Separating directions: that of a rounded optimum, where it leaves room for every rounding error, else doubles near
//! an exact direction.

use crate::collision::Separation;
use crate::collision::proof::direction_of_doubles::Beyond;
use crate::lad::of_generators::certify::rounded_optimum::RoundedOptimum;
use crate::lad::of_generators::seam::kernel_query::KernelQuery;
use crate::numeric::bounded::{Bounded, BoundedVector};
use crate::numeric::double_double::BoundedDoubleDouble;
use crate::numeric::dyadic::Dyadic;
use crate::numeric::exact_linear::{ExactVector, cross, difference, dot, negated};
use crate::tally::Rung;
use crate::zonotope::location::Proof;

/// The direction of the facet in doubles: rounding it by e takes at most e · (Σ |v|_1 + |p|_1) off the gap, |v|_1 < 2
/// |v|.
pub(in crate::collision) fn in_doubles(optimum: &RoundedOptimum, p: &BoundedVector) -> Option<Proof> {
    let error = optimum.direction.iter().fold(0.0f64, |m, c| m.max(c.error));
    let size: f64 = p.iter().map(|c| c.magnitude()).sum();
    let gap = optimum.along - optimum.support();
    let lost = Bounded::exact(error) * (Bounded::exact(4.0 * optimum.magnitude) + Bounded::exact(2.0 * size));
    let direction = optimum.direction.map(|c| c.value);
    (gap - lost).is_positive().then(|| Proof::outside(direction, Rung::RoundedDirection))
}

/// The rung of a direction that is proved without rounding.
pub(in crate::collision) fn exact_rung(separation: &Separation<3>) -> Rung {
    match separation {
        Separation::Rounded(_) => Rung::DirectionOfDoubles,
        Separation::Exact(_) => Rung::RationalDirection,
    }
}

/// The proof from an exact direction u with u · p > h(u); `basis` has the generators to which u is known to be
/// orthogonal, `sum` is that of all others with the signs of their products with u.
pub(crate) fn separation(
    query: &dyn KernelQuery,
    p: &ExactVector,
    direction: &ExactVector,
    basis: &[usize],
    sum: &ExactVector,
) -> Separation<3> {
    let normal = match *basis {
        [first, second] => {
            let [first, second] = [first, second].map(|b| query.exact_generator(b));
            let normal = cross(&first, &second);
            // the same direction in smaller numbers: of integers, perhaps, that are doubles
            if dot(&normal, p).sign().is_lt() { negated(normal) } else { normal }
        }
        _ => direction.clone(),
    };
    let exponent = normal.iter().filter_map(Dyadic::binary_exponent).max().unwrap_or(0);
    let mut spanning = [[BoundedDoubleDouble::exact(0.0); 3]; 2];
    for (vector, &index) in spanning.iter_mut().zip(basis) {
        *vector = query.exact_generator(index).each_ref().map(BoundedDoubleDouble::of);
    }
    let beyond = Beyond {
        normal: normal.map(|c| BoundedDoubleDouble::of(&c.scaled(-exponent))),
        rest: difference(p, sum).each_ref().map(BoundedDoubleDouble::of),
        spanning,
    };
    match beyond.direction_of_doubles(query) {
        Some(direction) => Separation::Rounded(direction),
        None => Separation::Exact(Box::new(direction.clone().map(|v| v.to_rational()))),
    }
}
