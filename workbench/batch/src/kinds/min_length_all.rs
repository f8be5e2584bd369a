//! `min_length_all`: the zonotope of least total length that contains points, along any directions.

use serde_json::{Value, json};
use zonotope::enclosing::min_total_length::{
    MinLengthError, MinLengthZonotope, Net, Outcome, by_direction_net, by_vertex_sets,
};

use super::{Kind, Solution};
use crate::dimension::refused;
use crate::fields::Fields;
use crate::json::{to_json, vector_to_json};
use crate::refusal::{Code, Refusal};

pub(super) const KIND: Kind = Kind {
    name: "min_length_all",
    summary: "the zonotope of least total length that contains points, within a proven ratio",
    fields: &["points", "epsilon"],
    optional: &[],
    methods: || METHODS.to_vec(),
    solve,
};

const METHODS: [&str; 3] = ["by_column_generation", "by_direction_net", "by_papers_net"];

/// The most points that are taken in 1, 2, … dimensions.
const POINT_LIMITS: [usize; 4] = [2_000_000, 200_000, 200_000, 20_000];

fn solve(fields: &Fields<'_>, method: Option<&'static str>, _seed: u64) -> Result<Solution, Refusal> {
    let method = method.unwrap_or(METHODS[0]);
    let result = match fields.dimension_of_first("points")?.unwrap_or(1) {
        1 => in_space::<1>(fields, method)?,
        2 => in_space::<2>(fields, method)?,
        3 => in_space::<3>(fields, method)?,
        4 => in_space::<4>(fields, method)?,
        other => return Err(refused("point 1", other, POINT_LIMITS.len())),
    };
    Ok(Solution { method, result })
}

fn in_space<const D: usize>(fields: &Fields<'_>, method: &str) -> Result<Value, Refusal> {
    let points = fields.vectors::<D>("points")?;
    let epsilon = fields.number("epsilon")?;
    let most = POINT_LIMITS[D - 1];
    if points.len() > most {
        let message = format!("{} points, at most {most} are taken in {D} dimensions", points.len());
        return Err(Refusal::new(Code::TooLarge, message));
    }
    let found = match method {
        "by_direction_net" => by_direction_net::min_length_by_net(&points, epsilon, Net::Cells),
        "by_papers_net" => by_direction_net::min_length_by_net(&points, epsilon, Net::Paper),
        _ => by_vertex_sets::min_length_enclosing(&points, epsilon),
    };
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
    let generators: Vec<Value> = found.zonotope.generators().iter().map(|g| vector_to_json(g)).collect();
    let forces = found.multipliers.iter();
    let forces: Vec<Value> =
        forces.map(|force| json!({"point": force.point, "vector": vector_to_json(&force.vector)})).collect();
    json!({
        "length": to_json(found.length),
        "center": vector_to_json(&found.zonotope.center()),
        "generators": generators,
        "lower_bound": to_json(found.lower_bound),
        "ratio": to_json(found.ratio),
        "within_epsilon": found.outcome == Outcome::WithinEpsilon,
        "certificate": {"forces": forces},
    })
}
