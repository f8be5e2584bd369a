//! Text as it may stand in a page.

use std::fmt;

/// Text with the characters that HTML reads as markup replaced.
pub(super) struct Escaped<'a>(pub(super) &'a str);

impl fmt::Display for Escaped<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut plain = 0;
        for (index, byte) in self.0.bytes().enumerate() {
            let replacement = match byte {
                b'&' => "&amp;",
                b'<' => "&lt;",
                b'>' => "&gt;",
                b'"' => "&quot;",
                _ => continue,
            };
            f.write_str(&self.0[plain..index])?;
            f.write_str(replacement)?;
            plain = index + 1;
        }
        f.write_str(&self.0[plain..])
    }
}

/// Text with a little mathematics as markup: `` `code` ``, n^2 and k^(d-1), P_t and P_{t+1}, 2.5e-3.
pub(super) fn prose(text: &str) -> String {
    text.split('`')
        .enumerate()
        .map(|(index, part)| if index % 2 == 1 { format!("<code>{}</code>", Escaped(part)) } else { formulas(part) })
        .collect()
}

/// Raises what follows `^`, lowers what follows `_` after a lone letter (primes between them allowed); the rest is
/// escaped.
fn formulas(text: &str) -> String {
    let mut markup = String::new();
    let mut rest = text;
    while let Some(at) = rest.find(['^', '_']) {
        let (before, after) = rest.split_at(at);
        let (mark, after) = after.split_at(1);
        let mut letters = before.trim_end_matches('\'').chars().rev();
        let lone =
            letters.next().is_some_and(char::is_alphabetic) && !letters.next().is_some_and(char::is_alphanumeric);
        markup.push_str(&with_powers_of_ten(before));
        match script(after).filter(|_| mark == "^" || lone) {
            Some(length) => {
                let tag = if mark == "^" { "sup" } else { "sub" };
                let content = &after[..length];
                let inner = content.strip_prefix('{').and_then(|group| group.strip_suffix('}')).unwrap_or(content);
                markup.push_str(&format!("<{tag}>{}</{tag}>", formulas(inner)));
                rest = &after[length..];
            }
            None => {
                markup.push_str(mark);
                rest = after;
            }
        }
    }
    markup + &with_powers_of_ten(rest)
}

/// Sets 1e-9 and 2.5e-3 with powers of ten; the rest is escaped.
fn with_powers_of_ten(text: &str) -> String {
    let is_of_number = |c: char| c.is_alphanumeric() || matches!(c, '.' | '-' | '−' | '+');
    let mut markup = String::new();
    for piece in text.split_inclusive(|c| !is_of_number(c)) {
        let word = piece.trim_end_matches(|c| !is_of_number(c) || c == '.');
        match power_of_ten(word) {
            Some(power) => markup.push_str(&format!("{power}{}", Escaped(&piece[word.len()..]))),
            None => markup.push_str(&Escaped(piece).to_string()),
        }
    }
    markup
}

/// The markup of a number like 2.5e-3, if the word is one.
fn power_of_ten(word: &str) -> Option<String> {
    let (factor, exponent) = word.split_once('e')?;
    let (sign, digits) = match exponent.strip_prefix(['-', '−']) {
        Some(digits) => ("−", digits),
        None => ("", exponent.strip_prefix('+').unwrap_or(exponent)),
    };
    let is_number = factor.ends_with(|c: char| c.is_ascii_digit()) && factor.parse::<f64>().is_ok();
    if !is_number || digits.is_empty() || !digits.bytes().all(|digit| digit.is_ascii_digit()) {
        return None;
    }
    let factor = if factor == "1" { String::new() } else { format!("{}·", factor.replace('-', "−")) };
    Some(format!("{factor}10<sup>{sign}{digits}</sup>"))
}

/// The length of what is raised or lowered: a group in braces or brackets, or digits, or letters and the group that
/// follows them.
fn script(text: &str) -> Option<usize> {
    let first = text.chars().next()?;
    if first == '{' || first == '(' {
        return group(text);
    }
    if !first.is_alphanumeric() {
        return None;
    }
    let alike = |c: char| c.is_alphanumeric() && c.is_ascii_digit() == first.is_ascii_digit();
    let word = text.find(|c| !alike(c)).unwrap_or(text.len());
    let argument = if text[word..].starts_with('(') { group(&text[word..]).unwrap_or(0) } else { 0 };
    Some(word + argument)
}

/// The length of the bracketed group at the start, if it is closed.
fn group(text: &str) -> Option<usize> {
    let mut depth = 0_i32;
    for (index, c) in text.char_indices() {
        match c {
            '{' | '(' => depth += 1,
            '}' | ')' => depth -= 1,
            _ => {}
        }
        if depth == 0 {
            return Some(index + c.len_utf8());
        }
    }
    None
}

/// A whole page around `body`.
pub(super) fn page(title: &str, body: &str) -> String {
    format!(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
         <meta name=\"color-scheme\" content=\"light dark\">\n\
         <title>{}</title>\n<style>\n{}</style>\n</head>\n<body>\n{body}</body>\n</html>\n",
        Escaped(title),
        include_str!("style.css"),
    )
}

/// The most columns of a table whose rows are lines on a wide page.
const MOST_COLUMNS: usize = 14;

/// A table with a header row; cells are markup already. Each has the name of its column, which is shown where the page
/// is so narrow, or the columns are so many, that rows take several lines.
pub(super) fn table(class: &str, header: &[&str], rows: &[Vec<String>]) -> String {
    let many = if header.len() > MOST_COLUMNS { " many" } else { "" };
    let mut text = format!("<div class=\"scroll\" tabindex=\"0\"><table class=\"{class}{many}\">\n<thead><tr>");
    for cell in header {
        text.push_str(&format!("<th scope=\"col\">{cell}</th>"));
    }
    text.push_str("</tr></thead>\n<tbody>\n");
    for row in rows {
        text.push_str("<tr>");
        for (name, cell) in header.iter().zip(row) {
            let none = if cell == "–" { " class=\"none\"" } else { "" };
            text.push_str(&format!("<td{none}><span class=\"name\">{name}</span>{cell}</td>"));
        }
        text.push_str("</tr>\n");
    }
    text.push_str("</tbody>\n</table></div>\n");
    text
}

/// A word on a coloured ground; `tone` is `good`, `bad`, `open` or `plain`.
pub(super) fn badge(tone: &str, word: &str) -> String {
    format!("<span class=\"badge {tone}\">{}</span>", Escaped(word))
}

/// A whole number with thin spaces between groups of three digits.
pub(super) fn grouped(number: u64) -> String {
    let digits = number.to_string();
    let mut text = String::new();
    for (index, digit) in digits.chars().enumerate() {
        if index > 0 && (digits.len() - index).is_multiple_of(3) {
            text.push('\u{202f}');
        }
        text.push(digit);
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn markup_is_escaped_and_digits_are_grouped() {
        assert_eq!(Escaped("a < b & \"ç\" > d").to_string(), "a &lt; b &amp; &quot;ç&quot; &gt; d");
        let code = prose("n log^2 n < k^(d-1), by `f_<x>`");
        assert_eq!(code, "n log<sup>2</sup> n &lt; k<sup>(d-1)</sup>, by <code>f_&lt;x&gt;</code>");
        assert_eq!(prose("P_{t+1} p_ij P'_{a'_s}"), "P<sub>t+1</sub> p<sub>ij</sub> P'<sub>a'<sub>s</sub></sub>");
        assert_eq!(prose("min_area, k^O(d), a^ (b_"), "min_area, k<sup>O(d)</sup>, a^ (b_");
        assert_eq!(prose("eps^(-(d-1)^2)"), "eps<sup>(-(d-1)<sup>2</sup>)</sup>");
        assert_eq!(prose("gaps of 1e-9, or 2.5e-3."), "gaps of 10<sup>−9</sup>, or 2.5·10<sup>−3</sup>.");
        assert_eq!(prose("1e, e5, 1ex, a1e5, 2^16"), "1e, e5, 1ex, a1e5, 2<sup>16</sup>");
        assert_eq!(grouped(0), "0");
        assert_eq!(grouped(999), "999");
        assert_eq!(grouped(1_048_576), "1\u{202f}048\u{202f}576");
    }
}
