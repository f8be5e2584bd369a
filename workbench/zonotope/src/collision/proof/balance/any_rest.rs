//! Three generators that absorb a small rest of which only the size is known: the basis of a proof whose coefficients
//! are known but for rounding.

use super::choice::{sampled, well_spread};
use super::triple::Triple;
use crate::lad::of_generators::span::flat::SimplePlane;
use crate::numeric::bounded::{self, Bounded, BoundedVector};
use crate::zonotope::query::Query;

/// Three generators whose coefficients stay within (−1, 1) when they absorb a rest of which no coordinate is larger
/// than `rest`; in increasing order.
#[inline]
pub(crate) fn basis_for_any(
    count: usize,
    generator: impl Fn(usize) -> BoundedVector,
    coefficients: &[f64],
    rest: f64,
) -> Option<Vec<usize>> {
    let absorbs = |basis: [usize; 3]| absorb_any(&basis.map(&generator), basis.map(|i| coefficients[i]), rest);
    let ends = (count >= 3).then(|| [0, count / 2, count - 1])?;
    let mut basis = if absorbs(ends) {
        ends
    } else {
        well_spread(sampled(count), |i| generator(i).map(|c| c.value)).filter(|basis| absorbs(*basis))?
    };
    if !basis.is_sorted() {
        basis.sort_unstable();
    }
    Some(basis.to_vec())
}

/// The same for two generators and a rest in their plane, whose normal has only coordinates 0, 1 and −1.
pub(crate) fn pair_for_any(
    query: &Query<'_, 3>,
    plane: &SimplePlane,
    coefficients: &[f64],
    rest: f64,
) -> Option<Vec<usize>> {
    let [first, second] = plane.pair;
    let vectors = [query.generator(first), query.generator(second), plane.normal].map(bounded::exact);
    absorb_any(&vectors, [coefficients[first], coefficients[second], 0.0], rest).then(|| plane.pair.to_vec())
}

/// Whether three coefficients stay within (−1, 1) when their vectors absorb any rest of a size.
#[inline(always)]
fn absorb_any(vectors: &[BoundedVector; 3], coefficients: [f64; 3], rest: f64) -> bool {
    let changes = Triple::new(vectors).bounded_coefficients(&[Bounded { value: 0.0, error: rest }; 3]);
    // false for NaN as well
    coefficients.iter().zip(changes).all(|(c, change)| c.abs() + change.magnitude() < 1.0)
}
