//! Stretches of time with their directions, as answers have them.

use serde_json::{Value, json};
use zonotope::motion::continuous::{FreeStretch, SeparatingDirection};

use crate::json::{to_json, vector_to_json};

/// A stretch with its direction.
pub(super) fn interval(stretch: &FreeStretch) -> Value {
    let (frame, direction) = match &stretch.direction {
        SeparatingDirection::Space(u) => ("space", vector_to_json(u)),
        SeparatingDirection::First(u) => ("a", vector_to_json(u)),
        SeparatingDirection::Second(u) => ("b", vector_to_json(u)),
        SeparatingDirection::Edges(edges) => ("edges", edges.iter().map(|edge| vector_to_json(edge)).collect()),
    };
    json!({
        "from": to_json(stretch.from),
        "to": to_json(stretch.until),
        "frame": frame,
        "direction": direction,
    })
}
