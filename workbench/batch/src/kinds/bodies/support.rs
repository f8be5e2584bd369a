//! `support`: how far a zonotope reaches in a direction, and a point where it does.

use serde_json::{Value, json};
use zonotope::support_of;

use crate::dimension::refused;
use crate::fields::Fields;
use crate::json::to_json;
use crate::kinds::{Kind, Solution};
use crate::refusal::Refusal;

pub(in crate::kinds) const KIND: Kind = Kind {
    name: "support",
    summary: "how far a zonotope reaches in a direction, and a point where it does",
    fields: &["direction", "center", "generators"],
    optional: &[],
    methods: || vec![BY_SIGNS],
    solve,
};

const BY_SIGNS: &str = "by_signs";

/// The most coordinates that are taken: the sums are the same in any number of dimensions.
const COORDINATE_LIMIT: usize = 10_000;

fn solve(fields: &Fields<'_>, _method: Option<&'static str>, _seed: u64) -> Result<Solution, Refusal> {
    let dimension = fields.dimension("direction")?;
    if !(1..=COORDINATE_LIMIT).contains(&dimension) {
        return Err(refused("direction", dimension, COORDINATE_LIMIT));
    }
    let direction = fields.vector_of("direction", dimension)?;
    let center = fields.vector_of("center", dimension)?;
    let generators = fields.vectors_of("generators", dimension)?;
    let (value, point) = support_of(&direction, &center, generators.iter().map(Vec::as_slice));
    let point: Value = point.iter().map(|coordinate| to_json(coordinate.to_f64())).collect();
    Ok(Solution { method: BY_SIGNS, result: json!({"value": to_json(value.to_f64()), "point": point}) })
}
