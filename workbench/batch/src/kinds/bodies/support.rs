//! `support`: how far a zonotope reaches in a direction, and a point where it does.

use serde_json::{Value, json};
use zonotope::numeric::dyadic::Dyadic;

use crate::dimension::in_dimension;
use crate::fields::Fields;
use crate::json::{to_json, vector_to_json};
use crate::kinds::{Kind, Solution};
use crate::placement::nearest;
use crate::refusal::Refusal;

pub(in crate::kinds) const KIND: Kind = Kind {
    name: "support",
    summary: "how far a zonotope reaches in a direction, and a point where it does",
    fields: &["direction", "center", "generators"],
    optional: &["pose"],
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
    let body = fields.zonotope::<D>()?;
    if !fields.has_pose() {
        let support = body.support(direction);
        return Ok(json!({"value": to_json(support.value()), "point": vector_to_json(&support.point())}));
    }
    let placement = fields.placement(D)?.exact();
    let direction = direction.map(Dyadic::from_f64);
    let along = |v: &[Dyadic]| direction.iter().zip(v).fold(Dyadic::zero(), |sum, (u, x)| sum + u * x);
    let mut point = placement.point(&body.center());
    for generator in body.generators() {
        let image = placement.vector(generator);
        let is_against = along(&image).sign().is_lt();
        for (sum, x) in point.iter_mut().zip(image) {
            *sum = if is_against { &*sum - &x } else { &*sum + &x };
        }
    }
    let value = along(&point).to_f64();
    Ok(json!({"value": to_json(value), "point": vector_to_json(&nearest(&point))}))
}
