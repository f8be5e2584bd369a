//! `min_length_all`: the zonotope of least total length that contains points, along any directions.

use serde_json::{Value, json};
use zonotope::enclosing::min_total_length::{Method, MinLengthError, MinLengthZonotope, Outcome};

use crate::dimension::refused;
use crate::fields::Fields;
use crate::json::{to_json, vector_to_json};
use crate::kinds::{Kind, Solution};
use crate::refusal::{Code, Refusal};

pub(in crate::kinds) const KIND: Kind = Kind {
    name: "min_length_all",
    summary: "the zonotope of least total length that contains points, within a proven ratio",
    fields: &["points", "epsilon"],
    optional: &[],
    methods: || Method::ALL.map(Method::id).to_vec(),
    solve,
};

/// The most points that are taken in 1, 2, … dimensions.
const POINT_LIMITS: [usize; 4] = [2_000_000, 200_000, 200_000, 20_000];

fn solve(fields: &Fields<'_>, method: Option<&'static str>, _seed: u64) -> Result<Solution, Refusal> {
    let named = |name| Method::from_id(name).expect("the kind lists the names of these methods");
    let method = method.map_or(Method::default(), named);
    let result = match fields.dimension_of_first("points")?.unwrap_or(1) {
        1 => in_space::<1>(fields, method)?,
        2 => in_space::<2>(fields, method)?,
        3 => in_space::<3>(fields, method)?,
        4 => in_space::<4>(fields, method)?,
        other => return Err(refused("point 1", other, POINT_LIMITS.len())),
    };
    Ok(Solution { method: method.id(), result })
}

fn in_space<const D: usize>(fields: &Fields<'_>, method: Method) -> Result<Value, Refusal> {
    let points = fields.vectors::<D>("points")?;
    let epsilon = fields.number("epsilon")?;
    let most = POINT_LIMITS[D - 1];
    if points.len() > most {
        let message = format!("{} points, at most {most} are taken in {D} dimensions", points.len());
        return Err(Refusal::new(Code::TooLarge, message));
    }
    let found = method.solve(&points, epsilon, &mut ());
    found.map(|found| result(&found)).map_err(|error| {
        let code = match error {
            MinLengthError::Empty => Code::Empty,
            MinLengthError::BadEpsilon(_) => Code::BadEpsilon,
            _ => Code::TooLarge,
        };
        Refusal::new(code, error.to_string())
    })
}

/// The result of an answer, as it is written.
fn result<const D: usize>(found: &MinLengthZonotope<D>) -> Value {
    let generators: Vec<Value> = found.body.generators().iter().map(|g| vector_to_json(g)).collect();
    let forces = found.proof.multipliers.iter();
    let forces: Vec<Value> =
        forces.map(|force| json!({"point": force.point, "vector": vector_to_json(&force.vector)})).collect();
    json!({
        "length": to_json(found.value),
        "center": vector_to_json(&found.body.center()),
        "generators": generators,
        "lower_bound": to_json(found.lower_bound),
        "ratio": to_json(found.ratio()),
        "within_epsilon": found.proof.outcome == Outcome::WithinEpsilon,
        "certificate": {"forces": forces},
    })
}
