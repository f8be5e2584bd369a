//! `support`: how far a zonotope reaches in a direction, and a point where it does.

use serde_json::{Value, json};
use zonotope::zonotope::Zonotope;

use super::Kind;
use crate::batch::fields::Fields;
use crate::batch::refusal::{Code, Refusal};
use crate::json::{to_json, vector_to_json};

pub(super) const KIND: Kind = Kind {
    name: "support",
    summary: "how far a zonotope reaches in a direction, and a point where it does",
    fields: &["direction", "center", "generators"],
    methods: || vec!["by_signs"],
    solve,
};

fn solve(fields: &Fields<'_>, _method: &'static str, _seed: u64) -> Result<Value, Refusal> {
    match fields.dimension("direction")? {
        2 => in_dimension::<2>(fields),
        3 => in_dimension::<3>(fields),
        other => {
            Err(Refusal::new(Code::DimensionMismatch, format!("direction has {other} coordinates; 2 and 3 are taken")))
        }
    }
}

fn in_dimension<const D: usize>(fields: &Fields<'_>) -> Result<Value, Refusal> {
    let direction = fields.vector::<D>("direction")?;
    let center = fields.vector::<D>("center")?;
    let generators = fields.vectors::<D>("generators")?;
    let zonotope =
        Zonotope::new(center, generators).expect("what is not finite was refused when the question was read");
    let support = zonotope.support(direction);
    Ok(json!({"value": to_json(support.value()), "point": vector_to_json(&support.point())}))
}
