//! A number as texts spell it: finite, missing, or broken in a way that has a name.

pub(super) mod in_json;
mod loss;

use super::error::Problem;

pub(super) use self::loss::Losses;

/// Words for a missing number in tables, beside an empty cell and the spellings of NaN.
const MISSING: [&str; 5] = ["na", "n/a", "<na>", "null", "none"];

/// The errors that spreadsheets write in place of a number.
const ERRORS: [&str; 13] = [
    "#n/a",
    "#num!",
    "#ref!",
    "#div/0!",
    "#value!",
    "#name?",
    "#null!",
    "#spill!",
    "#calc!",
    "#getting_data",
    "#field!",
    "#blocked!",
    "#na",
];

/// Words for NaN and the infinities by the C library of Windows, without the sign.
const NON_FINITE: [&str; 6] = ["1.#ind", "1.#qnan", "1.#snan", "1.#inf", "nan(ind)", "nan(snan)"];

/// The finite number of a word, with a decimal point.
pub(super) fn number(word: &[u8]) -> Result<f64, Problem> {
    let word = std::str::from_utf8(word).map_err(|_| Problem::NotText)?.trim();
    let written = || word.to_owned();
    match word.parse::<f64>() {
        Ok(number) if number.is_finite() => Ok(number),
        Ok(_) if word.bytes().any(|byte| byte.is_ascii_digit()) => Err(Problem::OutOfRange(written())),
        Ok(_) => Err(Problem::NotFinite(written())),
        Err(_) if word.is_empty() => Err(Problem::EmptyCell),
        Err(_) if is_not_finite(word) => Err(Problem::NotFinite(written())),
        Err(_) if is_grouped(word) => Err(Problem::Thousands(written())),
        Err(_) if with_decimal_point(word).is_some() => Err(Problem::DecimalComma(written())),
        Err(_) => Err(Problem::NotANumber(written())),
    }
}

/// Whether a word stands for a number, a missing one and one with a decimal comma or with separators of thousands
/// included.
pub(super) fn is_number(word: &[u8]) -> bool {
    !matches!(number(word), Err(Problem::NotText | Problem::EmptyCell | Problem::NotANumber(_)))
}

/// The word with a point in place of its decimal comma, if it has one and is a number then.
pub(super) fn with_decimal_point(word: &str) -> Option<String> {
    let (whole, rest) = word.trim().split_once(',')?;
    let is_part = |part: &str| !part.contains(['.', ',']);
    let pointed = format!("{whole}.{rest}");
    let begins = rest.starts_with(|c: char| c.is_ascii_digit());
    (begins && is_part(whole) && is_part(rest) && pointed.parse::<f64>().is_ok_and(f64::is_finite)).then_some(pointed)
}

/// Whether the comma of a number with one comma can only be a decimal one: thousands are separated from one to three
/// digits that do not begin with 0, and followed by three.
pub(super) fn has_plain_decimal_comma(word: &str) -> bool {
    let Some((whole, rest)) = word.trim().split_once(',') else { return false };
    let whole = whole.trim_start_matches(['+', '-']);
    let is_group = rest.len() == 3 && rest.bytes().all(|byte| byte.is_ascii_digit());
    !(is_group && (1..=3).contains(&whole.len()) && !whole.starts_with('0'))
}

/// Whether a word is an error that spreadsheets write in place of a number.
pub(super) fn is_error(word: &[u8]) -> bool {
    ERRORS.iter().any(|error| word.trim_ascii().eq_ignore_ascii_case(error.as_bytes()))
}

fn is_not_finite(word: &str) -> bool {
    let lower = word.to_ascii_lowercase();
    let unsigned = lower.strip_prefix(['+', '-']).unwrap_or(&lower);
    MISSING.contains(&lower.as_str()) || is_error(word.as_bytes()) || NON_FINITE.contains(&unsigned)
}

/// Whether a word is a number whose thousands are separated: `1 234,5`, `1'234.5`, `1.234,5`, `1,234.5`, `1,234,567`.
/// A single comma is no such separator here, as it may be a decimal one.
fn is_grouped(word: &str) -> bool {
    let unsigned = word.strip_prefix(['+', '-']).unwrap_or(word);
    const SEPARATORS: [char; 7] = [' ', '\'', '’', '\u{a0}', '\u{202f}', '\u{2009}', '_'];
    let by = |separator: char, marks: &[char]| {
        let (whole, fraction) = match unsigned.split_once(|c| c != separator && marks.contains(&c)) {
            Some((whole, fraction)) => (whole, Some(fraction)),
            None => (unsigned, None),
        };
        let mut groups = whole.split(separator);
        let is_digits = |group: &str| group.bytes().all(|byte| byte.is_ascii_digit());
        let starts = groups.next().is_some_and(|first| (1..=3).contains(&first.len()) && is_digits(first));
        let others: Vec<&str> = groups.collect();
        let is_fraction = |part: &str| !part.is_empty() && is_digits(part);
        let is_marked = SEPARATORS.contains(&separator) || others.len() > 1 || fraction.is_some();
        starts
            && is_marked
            && !others.is_empty()
            && others.iter().all(|group| group.len() == 3 && is_digits(group))
            && fraction.is_none_or(is_fraction)
    };
    SEPARATORS.iter().any(|&separator| by(separator, &['.', ','])) || by('.', &[',']) || by(',', &['.'])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_doubles_with_a_point() {
        for (word, expected) in [(".5", 0.5), ("5.", 5.0), ("+1e3", 1e3), (" -0.25 ", -0.25), ("1E-400", 0.0)] {
            assert_eq!(number(word.as_bytes()).ok(), Some(expected), "{word}");
        }
        let problem = |word: &str| number(word.as_bytes()).expect_err("no finite number");
        for word in
            ["nan", "-NaN", "inf", "-Infinity", "-1.#IND", "1.#QNAN", "1.#INF", "-nan(ind)", "NA", "null", "N/A"]
        {
            assert!(matches!(problem(word), Problem::NotFinite(_)), "{word}");
        }
        assert!(matches!(problem("1e999"), Problem::OutOfRange(_)));
        assert!(matches!(problem(" "), Problem::EmptyCell));
        assert!(matches!(number(b"\xff"), Err(Problem::NotText)));
        for word in ["1.2.3", "5e", "north", "1,2,3", "1;2", "0x10", "12 34", "1,234,56", "\u{2212}1"] {
            assert!(matches!(problem(word), Problem::NotANumber(_)), "{word}");
        }
    }

    #[test]
    fn decimal_commas_and_thousands_have_names() {
        let problem = |word: &str| number(word.as_bytes()).expect_err("no number with a point");
        for (word, is_plain) in
            [("0,5", true), ("-0,125", true), (",5", true), ("1,5e3", true), ("1234,567", true), ("1,234", false)]
        {
            assert!(matches!(problem(word), Problem::DecimalComma(_)), "{word}");
            assert_eq!(has_plain_decimal_comma(word), is_plain, "{word}");
        }
        for word in ["1 234,5", "1 234", "1'234.5", "1.234,5", "1,234.5", "1,234,567", "1\u{a0}234", "-12\u{202f}345,0"]
        {
            assert!(matches!(problem(word), Problem::Thousands(_)), "{word}");
        }
        assert_eq!(with_decimal_point("-1,5e3").as_deref(), Some("-1.5e3"));
        assert_eq!(with_decimal_point("1,5,2"), None);
        assert_eq!(with_decimal_point("1,"), None);
    }
}
