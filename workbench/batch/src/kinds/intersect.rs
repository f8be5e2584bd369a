//! `intersect`: whether two zonotopes have a point in common.

use serde_json::json;
use zonotope::collision::Query;

use super::collision::{Task, certificate, locate};
use super::{Kind, Solution};
use crate::dimension::in_dimension;
use crate::fields::Fields;
use crate::refusal::Refusal;

pub(super) const KIND: Kind = Kind {
    name: "intersect",
    summary: "whether two zonotopes overlap, only touch or are disjoint",
    fields: &["a", "b"],
    methods: || Task::Locate.method_names(),
    solve,
};

/// The fields of a zonotope.
const BODY: [&str; 2] = ["center", "generators"];

fn solve(fields: &Fields<'_>, method: Option<&'static str>, seed: u64) -> Result<Solution, Refusal> {
    let bodies = [fields.object("a", &BODY)?, fields.object("b", &BODY)?];
    in_dimension!(bodies[0].dimension("center")?, "the center of a", in_space(&bodies, method, seed))
}

fn in_space<const D: usize>(
    bodies: &[Fields<'_>; 2],
    method: Option<&'static str>,
    seed: u64,
) -> Result<Solution, Refusal> {
    let [a, b] = [bodies[0].zonotope::<D>()?, bodies[1].zonotope::<D>()?];
    let question = Query::between(&a, &b);
    let method = Task::Locate.method::<D>(method, question.len())?;
    let (method, location) = locate(method, &question, seed)?;
    let result = json!({
        "intersects": location.is_member(),
        "status": location.status().name(),
        "certificate": certificate(&question, &location),
    });
    Ok(Solution { method: method.id(), result })
}
