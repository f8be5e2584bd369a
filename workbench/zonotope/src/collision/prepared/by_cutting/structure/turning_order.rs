//! The generators of a part in the order in which they turn along a cut.
//!
//! The directions of a plane n^⊥ are a circle. As a direction u goes round it in the sense of u × n, a generator v that
//! is not parallel to n changes sides twice, from negative to positive at n × v, which is in the upper half of the
//! circle for either v or −v. Turned so, v comes before w just when w · (n × v) < 0. Generators that turn at the end of
//! the upper half, where lines parallel to the cut cross it at infinity, come last.

use std::cmp::Ordering;

use super::boundary::Boundary;
use super::tree::Place;
use crate::collision::prepared::by_cutting::filtered::{Filtered, Vector, are_parallel, sign_of_determinant};
use crate::numeric::bounded::{self, BoundedVector};
use crate::numeric::exact_linear::{ExactVector, cross, dot, exact};
use crate::numeric::linear;
use crate::tally::{Operation, Tally};

/// A generator that turns along a cut.
struct Turning {
    index: u32,
    is_reversed: bool,
    /// The generator, turned.
    vector: [f64; 3],
    /// Whether it turns at the end of the upper half.
    is_last: bool,
    /// Where it turns.
    direction: BoundedVector,
}

/// The places of the generators that turn along a cut, in their order, and of those parallel to its normal.
/// O(k log k) for k generators.
pub(crate) fn turning_order(
    boundary: Boundary,
    generators: &[[f64; 3]],
    crossing: &[u32],
    tally: &mut impl Tally,
) -> [Vec<Place>; 2] {
    let normal = boundary.normal(generators);
    let n = Filtered::new(normal.exact());
    let rounded: BoundedVector = normal.over();
    let reference = Filtered::new(boundary.reference());
    let (mut turning, mut along) = (Vec::with_capacity(crossing.len()), Vec::new());
    for &index in crossing {
        let vector = generators[index as usize];
        let v = Filtered::new(vector);
        let side = sign_of_determinant(&reference, &n, &v);
        if side.is_eq() && are_parallel(&n, &v) {
            along.push(Place::new(index, false));
            continue;
        }
        let is_last = side.is_eq();
        let is_reversed =
            if is_last { is_positive_in_upper_half(&normal.exact(), boundary, vector) } else { side.is_lt() };
        let vector = if is_reversed { vector.map(|c| -c) } else { vector };
        let direction = linear::cross(&rounded, &bounded::exact(vector));
        turning.push(Turning { index, is_reversed, vector, is_last, direction });
    }
    let mut comparisons = 0;
    turning.sort_unstable_by(|a, b| {
        comparisons += 1;
        a.is_last.cmp(&b.is_last).then_with(|| order(&n, a, b)).then(a.index.cmp(&b.index))
    });
    tally.add(Operation::Comparison, comparisons);
    [turning.iter().map(|own| Place::new(own.index, own.is_reversed)).collect(), along]
}

/// Which of two generators turns first.
fn order(n: &Filtered<ExactVector>, a: &Turning, b: &Turning) -> Ordering {
    if a.is_last {
        return Ordering::Equal;
    }
    match linear::dot(&a.direction, &bounded::exact(b.vector)).sign() {
        Some(sign) => sign.cmp(&0),
        None => sign_of_determinant(&Filtered::new(b.vector), n, &Filtered::new(a.vector)),
    }
}

/// Whether a generator that turns at both ends of the upper half is positive there, exactly.
fn is_positive_in_upper_half(normal: &ExactVector, boundary: Boundary, vector: [f64; 3]) -> bool {
    let inner = cross(normal, &cross(&exact(boundary.reference()), normal));
    dot(&inner, &exact(vector)).sign().is_gt()
}
