//! Bounds of sines, cosines, chords and products with them. The functions of libm are within one unit in the last place
//! of the exact ones, so that the second double beyond a value is a bound.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use crate::numeric::bounded::Bounded;

/// An angle that has all rotations of the given one below it, and no others but of less than 1e-300: not above a turn
/// but for rounding, and 0 or so large that half of it is a normal double.
pub(in super::super) fn covering(angle: f64) -> f64 {
    if angle == 0.0 { 0.0 } else { angle.clamp(1e-300, TAU.next_up()) }
}

/// A number not below sin(x), for x from 0 to π/2.
fn sine_above(x: f64) -> f64 {
    libm::sin(x).next_up().next_up().min(x).min(1.0)
}

/// A number not below the sine of any angle from 0 to x.
pub(in super::super) fn largest_sine(x: f64) -> f64 {
    if x >= FRAC_PI_2 { 1.0 } else { sine_above(x) }
}

/// A number not above the cosine of any angle from 0 to x.
pub(in super::super) fn least_cosine(x: f64) -> f64 {
    if x >= PI { -1.0 } else { libm::cos(x).next_down().next_down().max(-1.0) }
}

/// A number not below the distance of two points of the unit circle that are at most an angle apart.
pub(in super::super) fn chord_above(angle: f64) -> f64 {
    2.0 * largest_sine(angle / 2.0)
}

/// A bound of the product of two numbers that are not negative: the double above the rounded one, which may be 0 where
/// the product underflows, and 0 where a factor is 0.
pub(in super::super) fn product_above(a: f64, b: f64) -> f64 {
    if a == 0.0 || b == 0.0 { 0.0 } else { (a * b).next_up() }
}

/// The cosine and the sine.
pub(in super::super) fn cosine_and_sine(angle: f64) -> [Bounded; 2] {
    let (sine, cosine) = (libm::sin(angle), libm::cos(angle));
    [cosine, sine].map(|value| Bounded { value, error: 2.0 * f64::EPSILON * value.abs() })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bounds_are_on_their_sides_and_near() {
        for i in 0..=1000 {
            let x = f64::from(i) * PI / 1000.0;
            let (sine, cosine) = (libm::sin(x.min(FRAC_PI_2)), libm::cos(x));
            assert!((sine..sine + 1e-15).contains(&largest_sine(x)), "{x}");
            let below = least_cosine(x);
            assert!(below < cosine.max(f64::EPSILON - 1.0) && below > cosine - 1e-15, "{x}");
        }
        assert_eq!((chord_above(0.0), chord_above(4.0), chord_above(1e300)), (0.0, 2.0, 2.0));
        assert_eq!((covering(0.0), covering(5e-324), covering(100.0)), (0.0, 1e-300, TAU.next_up()));
    }
}
