//! The steps of the algorithm of Gilbert, Johnson and Keerthi, which believes and does not prove.

use rivals::by_gjk::{self, GjkAnswer};
use serde_json::{Value, json};
use zonotope::collision::Query;
use zonotope::zonotope::Zonotope;

/// The belief and the steps as a line of JSON: `belief` is `intersecting`, `disjoint` or `gave_up`, and each step has
/// the `direction` in which it looks, the `vertex` that it finds, and the point `nearest` to the origin, or null.
pub(super) fn steps(body: &Zonotope<3>, point: [f64; 3]) -> String {
    let Ok(question) = Query::of_point(point, body) else {
        return json!({"belief": "gave_up", "steps": []}).to_string();
    };
    let mut steps: Vec<Value> = Vec::new();
    let belief = by_gjk::traced(&question, &mut (), &mut |step| {
        steps.push(json!({"direction": step.direction, "vertex": step.vertex, "nearest": step.nearest}));
    });
    let belief = match belief {
        GjkAnswer::Intersecting => "intersecting",
        GjkAnswer::Disjoint { .. } => "disjoint",
        GjkAnswer::GaveUp => "gave_up",
    };
    json!({"belief": belief, "steps": steps}).to_string()
}
