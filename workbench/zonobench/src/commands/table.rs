//! Two columns of text: what a person reads of an answer.

use std::fmt::{Display, Write};

/// The note on a body whose generators are rounded products of directions and coefficients.
pub(super) const ROUNDED: &str = "; coefficients times directions, rounded";

const LABEL_WIDTH: usize = 14;

/// Labels and what they label.
#[derive(Default)]
pub(super) struct Table {
    text: String,
}

impl Table {
    /// Adds a line.
    pub(super) fn row(&mut self, label: &str, value: String) {
        writeln!(self.text, "{label:<LABEL_WIDTH$}{value}").expect("writing to a string does not fail");
    }

    /// The lines.
    pub(super) fn text(self) -> String {
        self.text
    }
}

/// A number of things: "1 vertex", "4 vertices".
pub(super) fn counted<N: Display + PartialEq + From<u8>>(count: N, one: &str, many: &str) -> String {
    let is_one = count == N::from(1);
    format!("{count} {}", if is_one { one } else { many })
}

/// A number as it is written in the answer: enough digits to be read back unchanged.
pub(super) fn in_full(number: f64) -> String {
    if number.is_finite() { format!("{number:?}") } else { "beyond the range of doubles".to_owned() }
}

/// A number for the eye, rounded to six digits.
pub(super) fn figure(number: f64) -> String {
    rounded(number, DIGITS, |_, _| false)
}

/// A bound from below: rounded down.
pub(super) fn at_least(number: f64) -> String {
    rounded(number, DIGITS, |shown, number| shown > number)
}

/// A bound from above: rounded up.
pub(super) fn at_most(number: f64) -> String {
    rounded(number, DIGITS, |shown, number| shown < number)
}

/// A factor from 1 on that bounds another from above: the part above 1 where six digits would not show it.
pub(super) fn factor_at_most(factor: f64) -> String {
    const SHOWN_FROM: f64 = 1e-4;
    match factor - 1.0 {
        0.0 => "1".to_owned(),
        part if part > 0.0 && part < SHOWN_FROM => format!("1 + {}", rounded(part, 2, |shown, part| shown < part)),
        _ => at_most(factor),
    }
}

/// A bound from below that says so where it is rounded.
pub(super) fn lower_bound(number: f64) -> String {
    let shown = at_least(number);
    if shown == in_full(number) { shown } else { shown + ", rounded down" }
}

/// The digits that are shown of a number.
const DIGITS: i64 = 6;

/// The most digits that a double needs to be read back unchanged.
const ALL_DIGITS: i64 = 17;

/// A number in so many digits: the nearest such number, or its neighbour on the other side where it is on the wrong
/// one.
fn rounded(number: f64, count: i64, is_wrong: impl Fn(f64, f64) -> bool) -> String {
    if count >= ALL_DIGITS {
        return in_full(number);
    }
    let scientific = format!("{number:.*e}", count as usize - 1);
    let Some((digits, exponent)) = scientific.split_once('e') else { return in_full(number) };
    let (Ok(digits), Ok(exponent)) = (digits.replace('.', "").parse::<i64>(), exponent.parse::<i64>()) else {
        return in_full(number);
    };
    let shown = |digits: i64, exponent: i64| {
        let shown = format!("{digits}e{}", exponent - count + 1).parse().ok();
        shown.filter(|shown: &f64| shown.is_finite()).unwrap_or(number)
    };
    let nearest = shown(digits, exponent);
    if !is_wrong(nearest, number) {
        return in_full(nearest);
    }
    let step = if nearest > number { -1 } else { 1 };
    // Numbers below a power of ten are ten times closer to each other.
    let is_finer = digits.abs() == 10i64.pow(count as u32 - 1) && digits.signum() != step;
    in_full(if is_finer { shown(10 * digits + step, exponent - 1) } else { shown(digits + step, exponent) })
}

/// A sentence of the verifier with its numbers in six digits: bounds, as the words around them tell, on their side.
pub(super) fn with_six_digits(sentence: &str) -> String {
    let words: Vec<&str> = sentence.split(' ').collect();
    let before = |index: usize, back: usize| index.checked_sub(back).map_or("", |index| words[index]);
    let shown = |(index, word): (usize, &&str)| {
        let number = word.trim_end_matches([';', ',', ':', ')', '.']);
        let digits = number.split('e').next().unwrap_or_default().bytes().filter(u8::is_ascii_digit).count();
        let value = number.parse::<f64>().ok().filter(|_| number.contains('.') && digits > DIGITS as usize);
        let Some(value) = value else { return (*word).to_owned() };
        let rounded = match (before(index, 2), before(index, 1)) {
            ("at", "most") | (_, "to") => at_most(value),
            ("at", "least") => at_least(value),
            _ if words.get(index + 1) == Some(&"to") => at_least(value),
            _ => figure(value),
        };
        rounded + &word[number.len()..]
    };
    words.iter().enumerate().map(shown).collect::<Vec<_>>().join(" ")
}

/// A vector.
pub(super) fn tuple(vector: &[f64]) -> String {
    format!("({})", vector.iter().map(|&x| figure(x)).collect::<Vec<_>>().join(", "))
}

/// A point of a body of a size: six digits of the size are shown, so that a small body far from the origin has its own
/// place.
pub(super) fn position(point: &[f64], size: f64) -> String {
    let digits = |x: f64| match (decimal_exponent(x), decimal_exponent(size)) {
        (Some(of_number), Some(of_size)) => DIGITS + (of_number - of_size).max(0),
        (_, None) => ALL_DIGITS,
        (None, Some(_)) => DIGITS,
    };
    let shown: Vec<String> = point.iter().map(|&x| rounded(x, digits(x), |_, _| false)).collect();
    format!("({})", shown.join(", "))
}

/// The exponent of ten of a number that is not zero.
fn decimal_exponent(number: f64) -> Option<i64> {
    let scientific = (number != 0.0).then(|| format!("{number:e}"))?;
    scientific.split_once('e')?.1.parse().ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn factors_near_1_show_how_near() {
        for (factor, shown) in [
            (1.0, "1"),
            (1.0 + f64::EPSILON, "1 + 2.3e-16"),
            (1.000_000_033_25, "1 + 3.4e-8"),
            (1.000_329_242_163, "1.00033"),
            (2.5, "2.5"),
        ] {
            assert_eq!(factor_at_most(factor), shown);
        }
    }

    #[test]
    fn a_small_body_far_from_the_origin_has_its_own_place() {
        let point = [500_000.123_456, 4_500_100.654_321, 0.0, -1e-7 / 3.0];
        assert_eq!(position(&point, 250.0), "(500000.123, 4500100.654, 0.0, -3.33333e-8)");
        assert_eq!(position(&point[..2], 1e7), "(500000.0, 4500100.0)");
        assert_eq!(position(&[1.0 / 3.0, 1e17 + 16.0], 1e-300), "(0.3333333333333333, 1.0000000000000002e17)");
        assert_eq!(position(&[1.0 / 3.0], 0.0), "(0.3333333333333333)", "a point has no size");
        assert_eq!(position(&[f64::INFINITY], f64::INFINITY), "(beyond the range of doubles)");
    }

    #[test]
    fn screens_show_six_digits_on_the_safe_side() {
        for (number, nearest, below, above) in [
            (1.0 / 3.0, "0.333333", "0.333333", "0.333334"),
            (-2.0 / 3.0, "-0.666667", "-0.666667", "-0.666666"),
            (12.0, "12.0", "12.0", "12.0"),
            (0.0, "0.0", "0.0", "0.0"),
            (123_456_789.0, "123457000.0", "123456000.0", "123457000.0"),
            (0.999_999_9, "1.0", "0.999999", "1.0"),
            (1.000_000_1, "1.0", "1.0", "1.00001"),
            (5e-324, "5e-324", "5e-324", "5e-324"),
        ] {
            assert_eq!([figure(number), at_least(number), at_most(number)], [nearest, below, above], "{number:?}");
        }
        assert_eq!([lower_bound(4.0), lower_bound(12.999_999_999_999_998)], ["4.0", "12.9999, rounded down"]);
        let sentence = "the distance is 1.601571521802106 to 1.616587602298466; at most 1.000000000613 times 2.5";
        let shown = "the distance is 1.60157 to 1.61659; at most 1.00001 times 2.5";
        assert_eq!(with_six_digits(sentence), shown);
        for beyond in [f64::INFINITY, f64::NEG_INFINITY, f64::NAN] {
            assert_eq!(figure(beyond), "beyond the range of doubles");
        }
        assert_eq!(at_most(f64::MAX), "1.7976931348623157e308", "no number of six digits is above");
        assert!(at_least(2.0f64.powi(-1074) * 3.0).parse::<f64>().is_ok_and(|below| below <= 2.0f64.powi(-1074) * 3.0));
    }
}
