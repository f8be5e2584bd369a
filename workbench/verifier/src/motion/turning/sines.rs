//! Sines and cosines of rational angles in whole numbers, within a stated error.
//!
//! An angle is reduced by quarter turns, with so many places of π that the number of turns does not matter, and the
//! rest goes into the series of Taylor. All rounding is of one unit at most, counted below.

use dashu_int::IBig;
use dashu_int::ops::{DivEuclid, RemEuclid};

/// The places after the point of sines and cosines.
pub(super) const SINE_PLACES: usize = 176;

/// Sines and cosines are within so many units of 2^-[`SINE_PLACES`].
///
/// The rest of the angle is off by 2 units. A term of a series is off by 3 units from three roundings, and by what the
/// term before it was off, which r² / (k (k + 1)) makes a quarter of at most: by 4 units in all. There are 22 terms,
/// and those that follow are less than 0.8^44 / 44!, no unit. 2 + 22 · 4 is less than 128.
#[cfg(test)]
pub(super) const SINE_ERROR: u32 = 128;

/// The number of terms of a series.
const TERMS: u32 = 22;

/// The bits of π beyond those that the places and the size of the angle take.
const SPARE: usize = 16;

/// A quarter turn, for angles below a power of two.
#[derive(Debug, Clone)]
pub(super) struct QuarterTurn {
    /// π / 2 in units of 2^-places, within 2 of these.
    units: IBig,
    places: usize,
}

impl QuarterTurn {
    /// A quarter turn for angles below 2^`bits`.
    pub(super) fn for_angles_below(bits: usize) -> Self {
        let places = SINE_PLACES + bits + SPARE;
        // Machin: π / 4 = 4 atan(1 / 5) − atan(1 / 239). Fewer than 2^28 roundings in units that are 2^-32 as large.
        let fine = IBig::ONE << (places + 32);
        let quarter = IBig::from(4) * arc_tangent(&fine, 5) - arc_tangent(&fine, 239);
        Self { units: quarter >> 31_usize, places }
    }

    /// Sine and cosine of the angle numerator / 2^shift.
    pub(super) fn sine_and_cosine(&self, numerator: &IBig, shift: usize) -> [IBig; 2] {
        let angle =
            if shift > self.places { numerator >> (shift - self.places) } else { numerator << (self.places - shift) };
        let two = IBig::from(2);
        let turns = (&angle * &two + &self.units).div_euclid(&self.units * &two);
        // Off by 1 and 2 for each turn, fewer than 2^bits: less than a unit of the sines.
        let rest = (angle - &turns * &self.units) >> (self.places - SINE_PLACES);
        let [sine, cosine] = [series(&rest, &rest, 1), series(&rest, &(IBig::ONE << SINE_PLACES), 0)];
        let quarters = turns.rem_euclid(IBig::from(4));
        match u8::try_from(quarters).unwrap_or_default() {
            0 => [sine, cosine],
            1 => [cosine, -sine],
            2 => [-sine, -cosine],
            _ => [-cosine, sine],
        }
    }
}

/// Σ ± first · r^(2 j) / ((degree + 1) … (degree + 2 j)).
fn series(rest: &IBig, first: &IBig, degree: u32) -> IBig {
    let mut term = first.clone();
    let mut sum = first.clone();
    for j in 0..TERMS {
        let k = degree + 2 * j + 1;
        term = (&term * rest) >> SINE_PLACES;
        term = (&term * rest) >> SINE_PLACES;
        term = -(term / IBig::from(k * (k + 1)));
        sum += &term;
    }
    sum
}

/// atan(1 / n) in units of 1 / one.
fn arc_tangent(one: &IBig, n: u32) -> IBig {
    let square = IBig::from(n * n);
    let mut power = one / IBig::from(n);
    let (mut sum, mut k) = (IBig::ZERO, 1_u32);
    while power != IBig::ZERO {
        let term = &power / IBig::from(k);
        sum = if k % 4 == 1 { sum + term } else { sum - term };
        power = -(-power / &square);
        k += 2;
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sines_agree_with_those_of_doubles() {
        let quarter = QuarterTurn::for_angles_below(12);
        let unit = 2f64.powi(-(SINE_PLACES as i32));
        for (angle, sine, cosine) in [
            (0, 0.0, 1.0),
            (1, 0.8414709848078965, 0.5403023058681398),
            (2, 0.9092974268256817, -0.4161468365471424),
            (3, 0.1411200080598672, -0.9899924966004454),
            (100, -0.5063656411097588, 0.8623188722876839),
        ] {
            for sign in [1, -1] {
                let found = quarter.sine_and_cosine(&IBig::from(8 * sign * angle), 3);
                let [s, c] = found.map(|x| x.to_f64().value() * unit);
                assert!((s - f64::from(sign) * sine).abs() < 1e-14 && (c - cosine).abs() < 1e-14, "{angle}");
            }
        }
    }

    #[test]
    fn squares_add_up_to_one_and_doubled_angles_agree() {
        let quarter = QuarterTurn::for_angles_below(1030);
        let one = IBig::ONE << (2 * SINE_PLACES);
        let error = IBig::from(8 * SINE_ERROR) << SINE_PLACES;
        let is_near = |a: &IBig, b: &IBig| (a - b) < error && (b - a) < error;
        for numerator in [IBig::from(1), IBig::from(-77), (IBig::from(3) << 1000) + IBig::ONE, IBig::from(1) << 1020] {
            let [s, c] = quarter.sine_and_cosine(&numerator, 7);
            assert!(is_near(&(&s * &s + &c * &c), &one), "{numerator}");
            let [doubled, cosine] = quarter.sine_and_cosine(&numerator, 6);
            assert!(is_near(&(IBig::from(2) * &s * &c), &(doubled << SINE_PLACES)), "{numerator}");
            assert!(is_near(&(&c * &c - &s * &s), &(cosine << SINE_PLACES)), "{numerator}");
        }
    }

    #[test]
    fn half_a_turn_is_pi() {
        // The first places of π, in hexadecimal.
        let pi = IBig::from_str_radix("3243f6a8885a308d313198a2e03707344a4093822299f31d", 16).expect("digits");
        let quarter = QuarterTurn::for_angles_below(64);
        let off = (quarter.units >> (quarter.places - 189)) - pi;
        assert!(off <= IBig::from(2) && off >= IBig::from(-2));
    }

    #[test]
    fn a_quarter_turn_has_places_for_the_sines_the_angle_and_some_to_spare() {
        for bits in [1, 12, 64] {
            assert_eq!(QuarterTurn::for_angles_below(bits).places, SINE_PLACES + SPARE + bits);
        }
    }

    #[test]
    fn an_angle_may_have_more_places_than_a_quarter_turn() {
        let quarter = QuarterTurn::for_angles_below(4);
        for numerator in [1, -1, 13] {
            let found = quarter.sine_and_cosine(&(IBig::from(numerator) << 999_usize), 1000);
            assert_eq!(found, quarter.sine_and_cosine(&IBig::from(numerator), 1), "{numerator}");
        }
    }
}
