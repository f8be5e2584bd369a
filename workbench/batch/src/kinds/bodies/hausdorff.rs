//! `hausdorff`: the Hausdorff distance of two zonotopes, and whether one contains the other.

use serde_json::{Value, json};
use zonotope::reduction::contains;
use zonotope::reduction::hausdorff::hausdorff;

use crate::dimension::in_dimension;
use crate::fields::Fields;
use crate::json::{to_json, vector_to_json};
use crate::kinds::{BODY, PLACED};
use crate::kinds::{Kind, Solution};
use crate::refusal::{Code, Refusal};

pub(in crate::kinds) const KIND: Kind = Kind {
    name: "hausdorff",
    summary: "the Hausdorff distance of two zonotopes between two bounds, and whether the second contains the first",
    fields: &["a", "b"],
    optional: &[],
    methods: || vec![METHOD],
    solve,
};

const METHOD: &str = "by_branch_and_bound";

/// The bounds differ by at most this part of the lower one, where the search for them allows it.
const WIDTH: f64 = 0.01;

/// The most generators of both bodies.
const GENERATOR_LIMIT: usize = 200_000;

fn solve(fields: &Fields<'_>, _method: Option<&'static str>, _seed: u64) -> Result<Solution, Refusal> {
    let bodies = [fields.object("a", &BODY, &PLACED)?, fields.object("b", &BODY, &PLACED)?];
    let result = in_dimension!(bodies[0].dimension("center")?, "the center of a", in_space(&bodies))?;
    Ok(Solution { method: METHOD, result })
}

fn in_space<const D: usize>(bodies: &[Fields<'_>; 2]) -> Result<Value, Refusal> {
    let [a, b] = [bodies[0].image::<D>()?, bodies[1].image::<D>()?];
    let generators = a.generators().len() + b.generators().len();
    if generators > GENERATOR_LIMIT {
        let message = format!("{generators} generators, at most {GENERATOR_LIMIT} are taken");
        return Err(Refusal::new(Code::TooLarge, message));
    }
    let Some(is_subset) = contains(&b, &a) else {
        return Err(Refusal::new(Code::TooLarge, "b has too many facets to tell whether it contains a"));
    };
    let distance = hausdorff(&a, &b, WIDTH);
    Ok(json!({
        "value": to_json(distance.lower + (distance.upper - distance.lower) / 2.0),
        "lower": to_json(distance.lower),
        "upper": to_json(distance.upper),
        "direction": vector_to_json(&distance.direction),
        "a_subset_b": is_subset,
    }))
}
