//! `min_area`: the zonogon of least area that contains points of the plane.

use serde_json::{Value, json};
use zonotope::enclosing::min_area_zonogon::{Method, MinAreaError, MinAreaZonogon};
use zonotope::hull::HullError;

use crate::fields::Fields;
use crate::json::{to_json, vector_to_json};
use crate::kinds::{Kind, Solution};
use crate::refusal::{Code, Refusal};

pub(in crate::kinds) const KIND: Kind = Kind {
    name: "min_area",
    summary: "the zonogon of least area that contains points of the plane",
    fields: &["points"],
    optional: &[],
    methods: || Method::ALL.map(Method::id).to_vec(),
    solve,
};

fn solve(fields: &Fields<'_>, method: Option<&'static str>, seed: u64) -> Result<Solution, Refusal> {
    let points = fields.vectors::<2>("points")?;
    let named = |name| Method::from_id(name).expect("the kind lists the names of these methods");
    let method = method.map_or(Method::default(), named);
    let found = method.solve(&points, seed, &mut ()).map_err(|error| {
        let code = match error {
            MinAreaError::Points(HullError::Empty) => Code::Empty,
            _ => Code::TooLarge,
        };
        Refusal::new(code, error.to_string())
    })?;
    Ok(Solution { method: method.id(), result: result(&found) })
}

/// The result of a `min_area` answer, as it is written.
pub fn result(found: &MinAreaZonogon) -> Value {
    let generators: Vec<Value> = found.body.generators().iter().map(|generator| vector_to_json(generator)).collect();
    let farthest: Vec<usize> = found.proof.farthest().iter().map(|farthest| farthest.vertex().get()).collect();
    json!({
        "area": to_json(found.value),
        "center": vector_to_json(&found.body.center()),
        "generators": generators,
        "lower_bound": to_json(found.lower_bound),
        "certificate": {
            "hull": found.proof.hull().indices().iter().map(|index| index.get()).collect::<Vec<usize>>(),
            "farthest": farthest,
            "coefficients": found.proof.certificate().signs,
            "basis": found.proof.certificate().basis.iter().map(|edge| edge.position()).collect::<Vec<usize>>(),
        },
    })
}
