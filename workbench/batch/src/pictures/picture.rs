//! A picture that can be asked for, and what its data are written with.

use serde_json::Value;

use super::sheet::Sheet;
use crate::fields::Fields;
use crate::json::vector_to_json;
use crate::refusal::Refusal;

/// A picture that can be asked for.
#[derive(Debug)]
pub struct Picture {
    /// Its name.
    pub name: &'static str,
    /// The data, in one line.
    pub summary: &'static str,
    /// The fields that its input must have.
    pub fields: &'static [&'static str],
    /// Makes the data.
    pub(crate) draw: fn(&Fields<'_>) -> Result<Sheet, Refusal>,
}

/// Vectors as a JSON list.
pub(super) fn vectors<const D: usize>(vectors: &[[f64; D]]) -> Value {
    vectors.iter().map(|vector| vector_to_json(vector)).collect()
}

/// A number that may be missing.
pub(super) fn optional<T>(value: Option<T>, write: impl Fn(T) -> Value) -> Value {
    value.map_or(Value::Null, write)
}
