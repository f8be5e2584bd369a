//! Numbers that a growing polytope is made of: doubles and pairs of doubles with bounds on their errors, and exact
//! ones.

use std::cmp::Ordering;

use crate::collision::distance::answer::rounded_length;
use crate::numeric::bounded::Bounded;
use crate::numeric::double_double::BoundedDoubleDouble;
use crate::numeric::double_double::Precision;
use crate::numeric::dyadic::Dyadic;
use crate::numeric::exact_linear::rounded_direction;
use crate::numeric::linear::{dot, euclidean_norm};
use crate::numeric::tolerance::{SHORTEST_LENGTH, THIRTY_ROUNDINGS};

/// A number whose sign and whose quotient by a length are told within bounds.
pub(super) trait Number: Precision {
    /// The magnitude, or more where the sign is in doubt.
    fn magnitude(&self) -> Self;

    /// Whether the exact value is greater than 0 beyond doubt.
    fn is_certainly_positive(&self) -> bool {
        self.certain_sign().is_some_and(Ordering::is_gt)
    }

    /// Whether the exact value is less than 0 beyond doubt.
    fn is_certainly_negative(&self) -> bool {
        self.certain_sign().is_some_and(Ordering::is_lt)
    }

    /// Bounds of a value over the Euclidean length of a vector; infinite ones where nothing is known.
    fn over_length(value: &Self, vector: &[Self; 3]) -> [f64; 2];

    /// The number in one double.
    fn rounded(&self) -> f64;

    /// The direction of a vector in doubles, of ordinary size.
    fn direction(vector: &[Self; 3]) -> [f64; 3];
}

impl Number for Bounded {
    fn magnitude(&self) -> Self {
        if self.value < 0.0 { self.negated() } else { *self }
    }

    fn over_length(value: &Self, vector: &[Self; 3]) -> [f64; 2] {
        let reach = value.error * THIRTY_ROUNDINGS;
        quotient([value.value - reach, value.value + reach], vector)
    }

    fn rounded(&self) -> f64 {
        self.value
    }

    fn direction(vector: &[Self; 3]) -> [f64; 3] {
        of_ordinary_size(vector.map(|c| c.value))
    }
}

impl Number for BoundedDoubleDouble {
    fn magnitude(&self) -> Self {
        self.abs()
    }

    fn over_length(value: &Self, vector: &[Self; 3]) -> [f64; 2] {
        let (low, high) = value.interval();
        quotient([low, high], &vector.each_ref().map(BoundedDoubleDouble::rounded))
    }

    fn rounded(&self) -> f64 {
        self.high
    }

    fn direction(vector: &[Self; 3]) -> [f64; 3] {
        of_ordinary_size(vector.map(|c| c.high))
    }
}

impl Number for Dyadic {
    fn magnitude(&self) -> Self {
        self.clone().abs()
    }

    fn over_length(value: &Self, vector: &[Self; 3]) -> [f64; 2] {
        let square = dot(vector, vector);
        if square.is_zero() {
            return [f64::NEG_INFINITY, f64::INFINITY];
        }
        if value.is_zero() {
            return [0.0; 2];
        }
        // the rounded length is within two units in the last place
        let length = rounded_length(value, &square);
        let bounds = [length.next_down().next_down(), length.next_up().next_up()];
        if value.sign().is_lt() { [-bounds[1], -bounds[0]] } else { bounds }
    }

    fn rounded(&self) -> f64 {
        self.to_f64()
    }

    fn direction(vector: &[Self; 3]) -> [f64; 3] {
        rounded_direction(vector)
    }
}

/// A vector of doubles over its largest coordinate; as it is where that is 0 or not finite.
fn of_ordinary_size(vector: [f64; 3]) -> [f64; 3] {
    let largest = vector.iter().fold(0.0f64, |largest, c| largest.max(c.abs()));
    let scaled = vector.map(|c| c / largest);
    if scaled.iter().all(|c| c.is_finite()) { scaled } else { vector }
}

/// Bounds of a value between two doubles over the length of a vector.
fn quotient([low, high]: [f64; 2], vector: &[Bounded; 3]) -> [f64; 2] {
    let length = euclidean_norm(&vector.map(|c| c.value));
    let error = euclidean_norm(&vector.map(|c| c.error));
    let slack = THIRTY_ROUNDINGS - 1.0;
    let (shortest, longest) = ((length - error) * (1.0 - slack) - error * slack, (length + error) * THIRTY_ROUNDINGS);
    let divided = |value: f64, positive: f64, negative: f64| {
        if value >= 0.0 { value / positive } else { value / negative }
    };
    // a length whose square underflows is not known
    if shortest.is_nan() || shortest < SHORTEST_LENGTH || low.is_nan() || high.is_nan() {
        return [f64::NEG_INFINITY, f64::INFINITY];
    }
    [divided(low, longest, shortest).next_down(), divided(high, shortest, longest).next_up()]
}
