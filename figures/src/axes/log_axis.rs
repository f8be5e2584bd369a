//! A logarithmic axis: powers of ten as ticks, the multiples between them as light grid lines.

use plotters::coord::ranged1d::{KeyPointHint, KeyPointWeight, NoDefaultFormatting, Ranged, ValueFormatter};
use std::ops::Range;

/// From a little below the smallest value to a little above the largest.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct LogAxis {
    /// Decimal logarithms of the ends.
    ends: [f64; 2],
}

/// Room at each end, as a part of the whole.
const ROOM: f64 = 0.04;
/// Up to this many decades the multiples of powers of ten have grid lines of their own.
const MOST_DECADES_WITH_LIGHT_LINES: usize = 6;
/// An axis shows at least this many decades.
const LEAST_DECADES: f64 = 1.0;

impl LogAxis {
    /// The axis around positive values; none if there are none.
    pub(super) fn around(values: impl Iterator<Item = f64>) -> Option<Self> {
        let (low, high) = values.map(libm::log10).fold(None, |ends: Option<(f64, f64)>, log| {
            Some(ends.map_or((log, log), |(low, high)| (low.min(log), high.max(log))))
        })?;
        let lacking = (LEAST_DECADES - (high - low)).max(0.0) / 2.0;
        let room = ROOM * (high - low).max(LEAST_DECADES);
        Some(Self { ends: [low - lacking - room, high + lacking + room] })
    }

    fn decades(&self) -> impl Iterator<Item = i32> {
        let first = libm::ceil(self.ends[0]) as i32;
        let last = libm::floor(self.ends[1]) as i32;
        first..=last
    }
}

impl Ranged for LogAxis {
    type FormatOption = NoDefaultFormatting;
    type ValueType = f64;

    fn map(&self, value: &f64, limit: (i32, i32)) -> i32 {
        let part = (libm::log10(*value) - self.ends[0]) / (self.ends[1] - self.ends[0]);
        limit.0 + libm::round(part * f64::from(limit.1 - limit.0)) as i32
    }

    fn key_points<Hint: KeyPointHint>(&self, hint: Hint) -> Vec<f64> {
        let low = libm::floor(self.ends[0]) as i32;
        match hint.weight() {
            KeyPointWeight::Bold => self.decades().map(|k| libm::exp10(f64::from(k))).collect(),
            KeyPointWeight::Any if self.decades().count() > MOST_DECADES_WITH_LIGHT_LINES => Vec::new(),
            KeyPointWeight::Any => (low..=libm::floor(self.ends[1]) as i32)
                .flat_map(|k| (1..10).map(move |m| f64::from(m) * libm::exp10(f64::from(k))))
                .filter(|value| {
                    let log = libm::log10(*value);
                    self.ends[0] <= log && log <= self.ends[1]
                })
                .collect(),
        }
    }

    fn range(&self) -> Range<f64> {
        libm::exp10(self.ends[0])..libm::exp10(self.ends[1])
    }
}

impl ValueFormatter<f64> for LogAxis {
    fn format_ext(&self, value: &f64) -> String {
        power(10, libm::round(libm::log10(*value)) as i32)
    }
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

    #[test]
    fn powers_are_written_with_raised_digits() {
        assert_eq!(power(10, 6), "10⁶");
        assert_eq!(power(10, -12), "10⁻¹²");
    }

    #[test]
    fn equal_ratios_take_equal_lengths() {
        let axis = LogAxis::around([10.0, 1000.0].into_iter()).expect("two values");
        let at = |value: f64| axis.map(&value, (0, 1080));
        assert_eq!(at(10.0), 40);
        assert_eq!(at(100.0), 540);
        assert_eq!(at(1000.0), 1040);
    }

    #[test]
    fn one_value_still_has_an_axis() {
        let axis = LogAxis::around([50.0].into_iter()).expect("a value");
        assert_eq!(axis.map(&50.0, (0, 100)), 50);
        assert_eq!(LogAxis::around(std::iter::empty()), None);
    }
}
