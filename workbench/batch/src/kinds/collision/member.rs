//! `member`: whether a point lies in a zonotope.

use serde_json::{Value, json};
use zonotope::collision::{Location, Query};

use super::posed::Posed;
use super::{Task, certificate, locate, locate_posed, proof};
use crate::claimed::{Placed, Traced, member as field, vector};
use crate::dimension::in_dimension;
use crate::fields::Fields;
use crate::kinds::{Kind, Solution};
use crate::refusal::Refusal;

pub(in crate::kinds) const KIND: Kind = Kind {
    name: "member",
    summary: "whether a point lies inside a zonotope, on its boundary or outside",
    fields: &["point", "center", "generators"],
    optional: &["pose"],
    methods: || Task::Locate.method_names(),
    solve,
    check,
};

fn solve(fields: &Fields<'_>, method: Option<&'static str>, seed: u64) -> Result<Solution, Refusal> {
    if fields.has_pose() {
        return in_dimension!(fields.dimension("center")?, "center", under_pose(fields, method, seed));
    }
    in_dimension!(fields.dimension("point")?, "point", in_space(fields, method, seed))
}

fn in_space<const D: usize>(fields: &Fields<'_>, method: Option<&'static str>, seed: u64) -> Result<Solution, Refusal> {
    let point = fields.vector::<D>("point")?;
    let body = fields.zonotope::<D>()?;
    let method = Task::Locate.method::<D>(method, body.generators().len())?;
    let question = Query::of_point(point, &body).expect("the numbers of a question are finite");
    let (method, location) = locate(method, &question, seed)?;
    Ok(Solution { method: method.id(), result: result(&location) })
}

fn under_pose<const D: usize>(
    fields: &Fields<'_>,
    method: Option<&'static str>,
    seed: u64,
) -> Result<Solution, Refusal> {
    let body = Posed::<D>::read(fields, "center")?;
    let point = Posed::of_point(fields.vector("point")?);
    let (method, location) = locate_posed([&body, &point], method, seed)?;
    Ok(Solution { method, result: result(&location) })
}

fn result<const D: usize>(location: &Location<D>) -> Value {
    json!({
        "member": location.is_member(),
        "status": location.status().name(),
        "certificate": certificate(location),
    })
}

fn check(input: Traced<'_>, result: Traced<'_>, _method: Option<&str>) -> Result<verifier::Verdict, String> {
    let point = vector(field(input, "point")?, "point")?;
    let body = Placed::read(input, "center")?;
    proof::located(&verifier::Displaced::to_point(&body.body(), &point)?, result, "member")
}
