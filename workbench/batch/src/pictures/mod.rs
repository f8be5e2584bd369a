//! Pictures: what a drawing needs beside the answers of the kinds. Data that is computed by the library and drawn by
//! somebody else: faces, tilings, level sets, the steps of searches.
//!
//! A question for a picture is one of a batch, with the name of a picture as its kind. There is nothing in it to be
//! proved, and the numbers are rounded, so pictures are no kinds: `solve` does not take them. Indices count from 0.

mod lines_of_hull;
mod plane;
mod searches;
mod space;

use serde_json::Value;

use super::fields::Fields;
use super::refusal::Refusal;
use crate::json::{to_json, vector_to_json};

/// A picture that can be asked for.
#[derive(Debug)]
pub struct Picture {
    /// Its name.
    pub name: &'static str,
    /// What is drawn, in one line.
    pub summary: &'static str,
    /// The fields that its input must have.
    pub fields: &'static [&'static str],
    /// Makes the data.
    pub(super) draw: fn(&Fields<'_>) -> Result<Value, Refusal>,
}

/// Every picture.
pub static PICTURES: &[Picture] = &[
    plane::ZONOGON,
    plane::CENTERED_ZONOGON,
    plane::LEVEL_SETS,
    plane::AREA_ALONG,
    searches::THEOREM_4_5,
    searches::PRUNING,
    space::FACES,
    space::TILING,
    space::PLANE_OF_DIRECTIONS,
    searches::THEOREM_5_2,
];

/// Vectors as a JSON list.
fn vectors<const D: usize>(vectors: &[[f64; D]]) -> Value {
    vectors.iter().map(|vector| vector_to_json(vector)).collect()
}

/// A number that may be missing.
fn optional<T>(value: Option<T>, write: impl Fn(T) -> Value) -> Value {
    value.map_or(Value::Null, write)
}
