//! Two columns of text: what a person reads of an answer.

use std::fmt::Write;

/// What is said of a body whose generators are rounded products of directions and coefficients.
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
pub(super) fn counted(count: usize, one: &str, many: &str) -> String {
    format!("{count} {}", if count == 1 { one } else { many })
}

/// A number as it is written in the answer: enough digits to be read back unchanged.
pub(super) fn figure(number: f64) -> String {
    if number.is_finite() { format!("{number:?}") } else { "beyond the range of doubles".to_owned() }
}

/// A vector.
pub(super) fn tuple(vector: &[f64]) -> String {
    format!("({})", vector.iter().map(|&x| figure(x)).collect::<Vec<_>>().join(", "))
}
