//! A centre in doubles from which the directions reach the points.

use dashu_int::ops::BitTest;

use super::problem::FixedDirections;
use super::scaled::Scaled;
use super::span::{Span, rational};
use crate::numeric::Rational;
use crate::numeric::dyadic::{Dyadic, binary_exponent};

/// The nearest doubles to a centre in scaled coordinates, if they lie in the affine span of the points; else a coarser centre that does, in the worst
/// case the first point.
pub(crate) fn double_center<const D: usize>(
    problem: &FixedDirections<'_, D>,
    scaled: &Scaled<D>,
    span: &Span<D>,
    guess: &[f64; D],
) -> [f64; D] {
    let first = problem.points()[0];
    let nearest = |c: usize, shift: f64| {
        let exact = Dyadic::from_f64(first[c]) + Dyadic::from_f64(shift).scaled(scaled.exponent);
        exact.to_f64().clamp(-f64::MAX, f64::MAX)
    };
    let guess = guess.map(|c| if c.is_finite() { c } else { 0.0 });
    let mut center = first;
    for (i, &c) in scaled.coordinates.iter().enumerate() {
        center[c] = nearest(c, guess[i]);
    }
    if scaled.rank == D {
        return center;
    }
    let exact_first = first.map(rational);
    let wanted: Vec<Rational> = scaled.coordinates.iter().map(|&c| rational(center[c]) - &exact_first[c]).collect();
    let largest = first.iter().chain(&center).fold(0.0, |max: f64, c| max.max(c.abs()));
    let Some(top) = binary_exponent(largest).map(i64::from) else { return first };
    let whole = span.whole_multiples();
    let longest = whole.iter().map(|multiple| multiple.bit_len() as i64).max().unwrap_or(0);
    // Whole multiples of the basis, the finer the better, until all coordinates are doubles.
    for exponent in top - 52 - longest..=top {
        let unit = Dyadic::new(1.into(), exponent).to_rational();
        let steps = whole.iter().map(|multiple| &unit * Rational::from(multiple.clone()));
        let shift: Vec<Rational> =
            wanted.iter().zip(steps).map(|(shift, step)| Rational::from((shift / &step).round()) * step).collect();
        let lifted = span.lift(&shift);
        let exact: [Rational; D] = std::array::from_fn(|c| &exact_first[c] + &lifted[c]);
        let rounded: [f64; D] = std::array::from_fn(|c| exact[c].to_f64_fast());
        if rounded.iter().zip(&exact).all(|(r, e)| r.is_finite() && rational(*r) == *e) {
            return rounded;
        }
    }
    first
}
