//! Proptest strategies for doubles, from plain ones to the ends of the range.

use proptest::prelude::*;

/// A number of ordinary size.
pub fn plain() -> BoxedStrategy<f64> {
    (-1.0..1.0f64).boxed()
}

/// A small integer.
pub fn lattice() -> BoxedStrategy<f64> {
    (-4..=4i32).prop_map(f64::from).boxed()
}

/// An integer of at most so much in magnitude.
pub fn integer(reach: i32) -> impl Strategy<Value = f64> + Clone {
    (-reach..=reach).prop_map(f64::from)
}

/// A factor that leads to the ends of the range of doubles, or none.
pub fn extreme_scale() -> impl Strategy<Value = f64> + Clone {
    prop_oneof![Just(1.0), Just(1e-300), Just(1e300), Just(1e-5), Just(f64::from_bits(1)), Just(1e150)]
}

/// A power of two between 1e-300 and 1e300, roughly.
pub fn scale() -> BoxedStrategy<f64> {
    (-996..=996i32).prop_map(power_of_two).boxed()
}

/// Zero, or a number of any magnitude between 1e-300 and 1e300.
pub fn any_magnitude() -> BoxedStrategy<f64> {
    prop_oneof![
        1 => Just(0.0),
        12 => (plain(), scale()).prop_map(|(mantissa, scale)| mantissa * scale),
    ]
    .boxed()
}

/// 2^`exponent`, for exponents of normal doubles.
pub fn power_of_two(exponent: i32) -> f64 {
    libm::ldexp(1.0, exponent)
}

/// `value` moved by `steps` units in the last place.
pub fn moved_by_ulps(value: f64, steps: i32) -> f64 {
    (0..steps.abs()).fold(value, |value, _| if steps > 0 { value.next_up() } else { value.next_down() })
}

/// `value` moved by `steps` units in the last place away from zero; `value` itself where that leaves the range.
pub fn nudged(value: f64, steps: i64) -> f64 {
    let moved = f64::from_bits(value.to_bits().wrapping_add_signed(steps));
    if moved.is_finite() { moved } else { value }
}
