//! An axis: logarithmic or linear, with round numbers as ticks and light grid lines between them.

use plotters::coord::ranged1d::{KeyPointHint, KeyPointWeight, NoDefaultFormatting, Ranged, ValueFormatter};
use std::ops::Range;

/// The layout of values along an axis.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Scale {
    /// Equal ratios take equal lengths.
    Logarithmic,
    /// Equal differences take equal lengths.
    Linear,
}

/// From a little below the smallest value to a little above the largest.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Axis {
    scale: Scale,
    /// The ends: decimal logarithms on a logarithmic axis.
    ends: [f64; 2],
}

/// Room at each end, as a part of the whole.
const ROOM: f64 = 0.04;
/// An axis of at most this many decades has 1, 2 and 5 times each power of ten as ticks; a longer one the powers alone.
const SHORT_DECADES: f64 = 2.5;
/// Up to this many decades the multiples of powers of ten have grid lines of their own.
const MOST_DECADES_WITH_LIGHT_LINES: usize = 6;
/// The least length of an axis, in decades or in units.
const LEAST_LENGTH: f64 = 1.0;
/// A linear axis has at most this many ticks.
const MOST_LINEAR_TICKS: f64 = 8.0;

impl Axis {
    /// The axis around values, which are positive if it is logarithmic; none if there are none.
    pub(super) fn around(scale: Scale, values: impl Iterator<Item = f64>) -> Option<Self> {
        let places = values.map(|value| place(scale, value));
        let (low, high) = places.fold(None, |ends: Option<(f64, f64)>, place| {
            Some(ends.map_or((place, place), |(low, high)| (low.min(place), high.max(place))))
        })?;
        let lacking = (LEAST_LENGTH - (high - low)).max(0.0) / 2.0;
        let room = ROOM * (high - low).max(LEAST_LENGTH);
        Some(Self { scale, ends: [low - lacking - room, high + lacking + room] })
    }

    fn length(&self) -> f64 {
        self.ends[1] - self.ends[0]
    }

    fn holds(&self, value: f64) -> bool {
        (self.ends[0]..=self.ends[1]).contains(&place(self.scale, value))
    }

    fn is_short(&self) -> bool {
        self.length() <= SHORT_DECADES
    }

    /// These multiples of the powers of ten, as far as they are on the axis.
    fn multiples(&self, of: &[u32]) -> Vec<f64> {
        let decades = libm::floor(self.ends[0]) as i32..=libm::floor(self.ends[1]) as i32;
        let values = decades.flat_map(|k| of.iter().map(move |&m| f64::from(m) * libm::exp10(f64::from(k))));
        values.filter(|&value| self.holds(value)).collect()
    }

    /// The multiples of a round step.
    fn steps(&self) -> Vec<f64> {
        let least = self.length() / MOST_LINEAR_TICKS;
        let power = libm::exp10(libm::floor(libm::log10(least)));
        let step = [1.0, 2.0, 5.0, 10.0].map(|m| m * power).into_iter().find(|step| *step >= least);
        let step = step.unwrap_or(10.0 * power);
        let [first, last] = [libm::ceil(self.ends[0] / step), libm::floor(self.ends[1] / step)];
        (first as i64..=last as i64).map(|k| k as f64 * step).collect()
    }
}

fn place(scale: Scale, value: f64) -> f64 {
    match scale {
        Scale::Logarithmic => libm::log10(value),
        Scale::Linear => value,
    }
}

impl Ranged for Axis {
    type FormatOption = NoDefaultFormatting;
    type ValueType = f64;

    fn map(&self, value: &f64, limit: (i32, i32)) -> i32 {
        let part = (place(self.scale, *value) - self.ends[0]) / self.length();
        limit.0 + libm::round(part * f64::from(limit.1 - limit.0)) as i32
    }

    fn key_points<Hint: KeyPointHint>(&self, hint: Hint) -> Vec<f64> {
        match (self.scale, hint.weight()) {
            (Scale::Linear, KeyPointWeight::Bold) => self.steps(),
            (Scale::Linear, KeyPointWeight::Any) => Vec::new(),
            (Scale::Logarithmic, KeyPointWeight::Bold) if self.is_short() => self.multiples(&[1, 2, 5]),
            (Scale::Logarithmic, KeyPointWeight::Bold) => self.multiples(&[1]),
            (Scale::Logarithmic, KeyPointWeight::Any) => {
                let is_long = self.multiples(&[1]).len() > MOST_DECADES_WITH_LIGHT_LINES;
                if is_long { Vec::new() } else { self.multiples(&[1, 2, 3, 4, 5, 6, 7, 8, 9]) }
            }
        }
    }

    fn range(&self) -> Range<f64> {
        let [low, high] = match self.scale {
            Scale::Logarithmic => self.ends.map(libm::exp10),
            Scale::Linear => self.ends,
        };
        low..high
    }
}

impl ValueFormatter<f64> for Axis {
    fn format_ext(&self, value: &f64) -> String {
        match self.scale {
            Scale::Linear => plain(*value),
            Scale::Logarithmic if self.is_short() => short(*value),
            Scale::Logarithmic => power(10, libm::round(libm::log10(*value)) as i32),
        }
    }
}

/// A tick of a short logarithmic axis: a plain number, or a digit times a power of ten where that has many zeros.
fn short(value: f64) -> String {
    let exponent = libm::floor(libm::log10(value) + 1e-9) as i32;
    if (-3..5).contains(&exponent) {
        return plain(value);
    }
    match libm::round(value / libm::exp10(f64::from(exponent))) as i32 {
        1 => power(10, exponent),
        digit => format!("{digit} · {}", power(10, exponent)),
    }
}

/// A round number without the digits that rounding left.
fn plain(value: f64) -> String {
    let text = format!("{value:.4}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    text.replace('-', "−")
}

/// A base with its exponent raised, in plain characters.
pub(crate) fn power(base: u32, exponent: i32) -> String {
    let digits = exponent.to_string();
    let raised = digits.chars().map(|digit| match digit {
        '-' => '⁻',
        '0' => '⁰',
        '1' => '¹',
        '2' => '²',
        '3' => '³',
        '4' => '⁴',
        '5' => '⁵',
        '6' => '⁶',
        '7' => '⁷',
        '8' => '⁸',
        _ => '⁹',
    });
    base.to_string().chars().chain(raised).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use plotters::coord::ranged1d::BoldPoints;

    fn ticks(scale: Scale, values: [f64; 2]) -> Vec<String> {
        let axis = Axis::around(scale, values.into_iter()).expect("two values");
        axis.key_points(BoldPoints(100)).iter().map(|value| axis.format_ext(value)).collect()
    }

    #[test]
    fn powers_are_written_with_raised_digits() {
        assert_eq!(power(10, 6), "10⁶");
        assert_eq!(power(10, -12), "10⁻¹²");
    }

    #[test]
    fn every_axis_has_several_ticks() {
        assert_eq!(ticks(Scale::Logarithmic, [6.0, 32.0]), ["5", "10", "20"]);
        assert_eq!(ticks(Scale::Logarithmic, [0.004, 0.06]), ["0.005", "0.01", "0.02", "0.05"]);
        assert_eq!(ticks(Scale::Logarithmic, [2.2e6, 9e6]), ["2 · 10⁶", "5 · 10⁶", "10⁷"]);
        assert_eq!(ticks(Scale::Logarithmic, [1.0, 2e4]), ["10⁰", "10¹", "10²", "10³", "10⁴"]);
        assert_eq!(ticks(Scale::Linear, [1.0, 30.0]), ["0", "5", "10", "15", "20", "25", "30"]);
    }

    #[test]
    fn equal_ratios_take_equal_lengths() {
        let axis = Axis::around(Scale::Logarithmic, [10.0, 1000.0].into_iter()).expect("two values");
        let at = |value: f64| axis.map(&value, (0, 1080));
        assert_eq!(at(10.0), 40);
        assert_eq!(at(100.0), 540);
        assert_eq!(at(1000.0), 1040);
    }

    #[test]
    fn one_value_still_has_an_axis() {
        for scale in [Scale::Logarithmic, Scale::Linear] {
            let axis = Axis::around(scale, [50.0].into_iter()).expect("a value");
            assert_eq!(axis.map(&50.0, (0, 100)), 50);
            assert_eq!(Axis::around(scale, std::iter::empty()), None);
        }
    }
}
