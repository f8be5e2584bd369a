//! `support`: how far a zonotope reaches in a direction, and a point where it does.

use serde_json::{Value, json};

use crate::dimension::in_dimension;
use crate::fields::Fields;
use crate::json::{to_json, vector_to_json};
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

fn solve(fields: &Fields<'_>, _method: Option<&'static str>, _seed: u64) -> Result<Solution, Refusal> {
    let result = in_dimension!(fields.dimension("direction")?, "direction", in_space(fields))?;
    Ok(Solution { method: BY_SIGNS, result })
}

fn in_space<const D: usize>(fields: &Fields<'_>) -> Result<Value, Refusal> {
    let direction = fields.vector::<D>("direction")?;
    let support = fields.zonotope::<D>()?.support(direction);
    Ok(json!({"value": to_json(support.value()), "point": vector_to_json(&support.point())}))
}
