//! Numbers of a table.

use crate::report::html::{grouped, prose};

/// Whole numbers in groups of digits, others in a few digits.
pub(super) fn significant(value: f64) -> String {
    if value.fract() == 0.0 && (0.0..1e15).contains(&value) {
        grouped(value as u64)
    } else if (1e-3..1e6).contains(&value.abs()) {
        format!("{value:.5}")
    } else {
        prose(&format!("{value:.3e}"))
    }
}
