//! Numbers that a double does not hold as a text spells them: whole numbers of too many digits, which are rounded, and
//! numbers so small that they are read as zero. Fractions are rounded as well, and nobody takes them for exact.

use crate::input::error::Place;

/// The least number of digits of a whole number that no double equals: 2^53 + 1 has sixteen.
const EXACT_DIGITS: usize = 15;

/// The numbers of a text that were rounded or read as zero.
#[derive(Debug, Clone, Default, PartialEq)]
pub(in crate::input) struct Losses {
    rounded: Lost,
    vanished: Lost,
}

/// Numbers of one kind: their count, and the first one with its place.
#[derive(Debug, Clone, Default, PartialEq)]
struct Lost {
    count: usize,
    first: Option<(String, Place)>,
}

impl Losses {
    /// Takes notice of a word that was read as this number.
    pub(in crate::input) fn note(&mut self, word: &[u8], number: f64, place: impl FnOnce() -> Place) {
        let lost = match number == 0.0 {
            true if has_digit_other_than_zero(word) => &mut self.vanished,
            false if is_rounded_whole_number(word, number) => &mut self.rounded,
            _ => return,
        };
        lost.count += 1;
        lost.first.get_or_insert_with(|| (String::from_utf8_lossy(word.trim_ascii()).into_owned(), place()));
    }

    /// The counts in words, each with the first number and its place; `None` where nothing was lost.
    pub(in crate::input) fn in_words(&self) -> Option<String> {
        let rounded = self.rounded.in_words(
            "whole number has more digits than a double holds and is rounded",
            "whole numbers have more digits than a double holds and are rounded",
        );
        let vanished = self.vanished.in_words(
            "number is too small for a double and is read as 0",
            "numbers are too small for a double and are read as 0",
        );
        let parts: Vec<String> = rounded.into_iter().chain(vanished).collect();
        (!parts.is_empty()).then(|| parts.join("; "))
    }
}

impl Lost {
    fn in_words(&self, one: &str, several: &str) -> Option<String> {
        let (word, place) = self.first.as_ref()?;
        let first = if self.count == 1 { "" } else { "the first is " };
        let shown: String = word.chars().take(40).collect();
        let ellipsis = if word.chars().count() > 40 { "…" } else { "" };
        let counted = if self.count == 1 { one } else { several };
        Some(format!("{} {counted} ({first}{shown}{ellipsis}, {place})", self.count))
    }
}

/// Whether a digit other than 0 stands before the exponent.
fn has_digit_other_than_zero(word: &[u8]) -> bool {
    let digits = word.iter().take_while(|byte| !b"eE".contains(byte));
    digits.into_iter().any(|byte| (b'1'..=b'9').contains(byte))
}

/// Whether a word without an exponent is a whole number that is not the one of the double.
fn is_rounded_whole_number(word: &[u8], number: f64) -> bool {
    if word.len() <= EXACT_DIGITS || number.fract() != 0.0 {
        return false;
    }
    let Ok(word) = std::str::from_utf8(word.trim_ascii()) else { return false };
    let unsigned = word.trim_start_matches(['+', '-']);
    let (whole, fraction) = unsigned.split_once(['.', ',']).unwrap_or((unsigned, ""));
    let is_whole = whole.bytes().all(|byte| byte.is_ascii_digit()) && fraction.bytes().all(|byte| byte == b'0');
    is_whole && whole.trim_start_matches('0') != format!("{:.0}", number.abs())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn lost(words: &[&str]) -> Option<String> {
        let mut losses = Losses::default();
        for (line, word) in (1..).zip(words) {
            losses.note(word.as_bytes(), word.parse().expect("a number"), || Place::Line(line));
        }
        losses.in_words()
    }

    #[test]
    fn whole_numbers_that_no_double_equals_and_numbers_that_vanish_are_counted_with_the_first() {
        let rounded = "1 whole number has more digits than a double holds and is rounded";
        for word in ["9007199254740993", "-9007199254740993", "+009007199254740993", "9007199254740993.0"] {
            assert_eq!(lost(&["1", word]), Some(format!("{rounded} ({word}, line 2)")));
        }
        let all = lost(&["1e-400", "18446744073709551617", "-0.5e-999", "9007199254740993"]);
        let expected = "2 whole numbers have more digits than a double holds and are rounded (the first is \
                        18446744073709551617, line 2); 2 numbers are too small for a double and are read as 0 (the \
                        first is 1e-400, line 1)";
        assert_eq!(all.as_deref(), Some(expected));
    }

    #[test]
    fn numbers_that_a_double_holds_and_fractions_lose_nothing() {
        for word in [
            "9007199254740992",
            "9007199254740994",
            "18446744073709551616",
            "0.1",
            "1e-320",
            "0e-400",
            "-0.000",
            "1e23",
            "0.30000000000000004441",
            "123456789012345678.5",
        ] {
            assert_eq!(lost(&[word]), None, "{word}");
        }
    }
}
