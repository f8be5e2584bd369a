//! The forms that sentences about what was measured share.

use crate::catalog;
use crate::definition::Quantity;
use crate::measured::{Extreme, Measured, Series};

/// A number in words: grouped digits where it is whole and large, else three significant digits.
pub fn number(value: f64) -> String {
    let size = value.abs();
    if size < 1e15 && (value.fract() == 0.0 || size >= 1000.0) {
        return grouped(value.round() as i64);
    }
    if size != 0.0 && !(1e-3..1e15).contains(&size) {
        return format!("{value:.1e}").replace('-', "−");
    }
    let decimals = (2 - libm::floor(libm::log10(size)) as i32).clamp(0, 6) as usize;
    format!("{value:.decimals$}").replace('-', "−")
}

/// A whole number with narrow spaces between groups of three digits.
fn grouped(value: i64) -> String {
    let digits = value.unsigned_abs().to_string();
    let mut text = if value < 0 { String::from("−") } else { String::new() };
    for (index, digit) in digits.chars().enumerate() {
        if index > 0 && (digits.len() - index).is_multiple_of(3) {
            text.push('\u{202f}');
        }
        text.push(digit);
    }
    text
}

/// The name of an input: `random_bodies` is "random bodies".
pub fn input(id: &str) -> String {
    id.replace('_', " ")
}

/// The title of a method in an experiment.
pub fn title(experiment: &str, method: &str) -> String {
    let variants = catalog::find(experiment).map_or(&[][..], |experiment| experiment.variants);
    let found = variants.iter().find(|variant| variant.id == method);
    found.map_or(method, |variant| variant.title).to_owned()
}

/// A share in per cent.
pub fn percent(share: f64) -> String {
    format!("{} %", number(100.0 * share))
}

/// A number with where it was measured: "1.28 (italy, n = 323)".
pub fn at(extreme: &Extreme) -> String {
    format!("{} ({}, n = {})", number(extreme.number), input(&extreme.input), number(extreme.n as f64))
}

/// The least and the greatest of some numbers, or the one number where both are written alike.
pub fn between([least, greatest]: [f64; 2]) -> String {
    let [least, greatest] = [least, greatest].map(number);
    let is_alike = least == greatest || least.parse::<f64>().is_ok_and(|value| greatest.parse() == Ok(value));
    if is_alike { greatest } else { format!("{least} to {greatest}") }
}

/// "What, from the least to the greatest, each with where it was measured, over so many inputs."
pub fn span(
    found: &Measured<'_>,
    what: &str,
    [experiment, method]: [&str; 2],
    quantity: Quantity,
    made: impl Fn(f64, f64) -> f64,
) -> Option<String> {
    let [least, greatest] = found.extremes(experiment, method, quantity, made)?;
    let inputs = found.over_inputs(experiment, method, quantity).len();
    let range = match least.number == greatest.number {
        true => format!("is {} wherever it was measured", number(least.number)),
        false => format!("is from {} to {}", at(&least), at(&greatest)),
    };
    Some(format!("{what} {range}, on {inputs} {}.", if inputs == 1 { "input" } else { "inputs" }))
}

/// "What, input by input, from its value at the smallest size to that at the largest."
pub fn course(
    found: &Measured<'_>,
    what: &str,
    [experiment, method]: [&str; 2],
    quantity: Quantity,
    made: impl Fn(f64, f64) -> f64,
) -> Option<String> {
    let courses = found.inputs(experiment, method).into_iter().filter_map(|id| {
        let series = Series { experiment, input: id, method };
        let ((first, start), (last, end)) = (found.at_smallest(series, quantity)?, found.at_largest(series, quantity)?);
        let [start, end] = [(first, start), (last, end)].map(|(n, value)| number(made(n as f64, value)));
        let [first, last] = [first, last].map(|n| number(n as f64));
        let begin = if first == last { String::new() } else { format!("{start} at n = {first} and ") };
        Some(format!("{begin}{end} at n = {last} on {}", input(id)))
    });
    let courses: Vec<String> = courses.collect();
    if courses.is_empty() { None } else { Some(format!("{what} is {}.", courses.join("; "))) }
}

/// "What of one method over that of another, at the largest size of both, input by input."
pub fn ratio(
    found: &Measured<'_>,
    what: &str,
    experiment: &str,
    [method, other]: [&str; 2],
    quantity: Quantity,
) -> Option<String> {
    let ratios = found.inputs(experiment, method).into_iter().filter_map(|id| {
        let of = |method| Series { experiment, input: id, method };
        let (own, others) = (found.at_largest(of(method), quantity)?.0, found.at_largest(of(other), quantity)?.0);
        let n = own.min(others);
        let [own, others] = [method, other].map(|method| found.at(of(method), quantity, n as f64));
        Some(format!("{} at n = {} on {}", number(own? / others?), number(n as f64), input(id)))
    });
    let ratios: Vec<String> = ratios.collect();
    let (own, others) = (title(experiment, method), title(experiment, other));
    if ratios.is_empty() {
        None
    } else {
        Some(format!("{what} of “{own}” over those of “{others}”: {}.", ratios.join("; ")))
    }
}

/// The quantity as it is.
pub fn plain(_: f64, value: f64) -> f64 {
    value
}

/// The quantity divided by the size.
pub fn per_size(n: f64, value: f64) -> f64 {
    value / n
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_have_three_digits_that_matter() {
        let shown = [0.0, 2.0, 4096.0, 1.2345, 0.012345, 123.456, 1234.56, 1.5e-7, -2.5].map(number);
        assert_eq!(shown, ["0", "2", "4\u{202f}096", "1.23", "0.0123", "123", "1\u{202f}235", "1.5e−7", "−2.50"]);
        assert_eq!(percent(0.1234), "12.3 %");
        assert_eq!(
            [between([1.0, 1.001]), between([1.001, 1.002]), between([0.5, 2.0])],
            ["1.00", "1.00", "0.500 to 2"]
        );
    }
}
