//! A centre in doubles from which the directions reach the points.

use super::problem::FixedDirections;
use super::scaled::Scaled;
use super::span::{Span, rational};
use crate::numeric::Rational;
use crate::numeric::dyadic::{Dyadic, binary_exponent, scale_by_power_of_two};

/// How many bits of the coordinates are kept, one attempt after the other, until the other coordinates are doubles too.
const BITS: [i64; 10] = [53, 50, 46, 42, 38, 34, 30, 20, 10, 4];

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
    for bits in BITS {
        let pivots: Vec<f64> = scaled.coordinates.iter().map(|&c| with_bits(center[c], bits)).collect();
        let shift: Vec<Rational> =
            scaled.coordinates.iter().zip(&pivots).map(|(&c, &p)| rational(p) - &exact_first[c]).collect();
        let lifted = span.lift(&shift);
        let exact: [Rational; D] = std::array::from_fn(|c| &exact_first[c] + &lifted[c]);
        let rounded: [f64; D] = std::array::from_fn(|c| exact[c].to_f64_fast());
        if rounded.iter().zip(&exact).all(|(r, e)| r.is_finite() && rational(*r) == *e) {
            return rounded;
        }
    }
    first
}

/// The nearest number with so many bits.
fn with_bits(value: f64, bits: i64) -> f64 {
    let Some(exponent) = binary_exponent(value) else { return value };
    let shift = bits - 1 - i64::from(exponent);
    let scaled = scale_by_power_of_two(value, shift);
    if bits < 53 && scaled.is_finite() { scale_by_power_of_two(scaled.round(), -shift) } else { value }
}
