//! Floats in JSON, the non-finite ones included.

use std::fmt;

use serde_json::Value;

/// A float that is no number in JSON.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum NonFinite {
    /// Not a number.
    NaN,
    /// Positive infinity.
    Infinity,
    /// Negative infinity.
    MinusInfinity,
}

impl NonFinite {
    /// The non-finite float that a JSON string spells.
    pub fn spelled(text: &str) -> Option<Self> {
        match text {
            "NaN" => Some(Self::NaN),
            "Infinity" => Some(Self::Infinity),
            "-Infinity" => Some(Self::MinusInfinity),
            _ => None,
        }
    }

    /// The float itself.
    pub fn value(self) -> f64 {
        match self {
            Self::NaN => f64::NAN,
            Self::Infinity => f64::INFINITY,
            Self::MinusInfinity => f64::NEG_INFINITY,
        }
    }
}

impl fmt::Display for NonFinite {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::NaN => "NaN",
            Self::Infinity => "Infinity",
            Self::MinusInfinity => "-Infinity",
        })
    }
}

/// A float as a JSON value: a shortest round-trip number, or the name of a non-finite float.
pub fn to_json(number: f64) -> Value {
    match serde_json::Number::from_f64(number) {
        Some(finite) => Value::Number(finite),
        None if number.is_nan() => NonFinite::NaN.to_string().into(),
        None if number > 0.0 => NonFinite::Infinity.to_string().into(),
        None => NonFinite::MinusInfinity.to_string().into(),
    }
}

/// A vector as a JSON list.
pub fn vector_to_json(vector: &[f64]) -> Value {
    vector.iter().map(|&component| to_json(component)).collect()
}

/// Vectors as a JSON list of lists.
pub fn rows_to_json(vectors: &[Vec<f64>]) -> Value {
    vectors.iter().map(|vector| vector_to_json(vector)).collect()
}
