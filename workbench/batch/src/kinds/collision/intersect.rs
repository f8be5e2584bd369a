//! `intersect`: whether two zonotopes have a point in common.

use serde_json::{Value, json};
use zonotope::collision::{Location, Query};

use super::posed::Posed;
use super::{Task, certificate, locate, locate_posed, proof};
use crate::claimed::{Placed, Traced, member};
use crate::dimension::in_dimension;
use crate::fields::Fields;
use crate::kinds::{BODY, Kind, PLACED, Solution};
use crate::refusal::Refusal;

pub(in crate::kinds) const KIND: Kind = Kind {
    name: "intersect",
    summary: "whether two zonotopes overlap, only touch or are disjoint",
    fields: &["a", "b"],
    optional: &[],
    methods: || Task::Locate.method_names(),
    solve,
    check,
};

fn solve(fields: &Fields<'_>, method: Option<&'static str>, seed: u64) -> Result<Solution, Refusal> {
    let bodies = [fields.object("a", &BODY, &PLACED)?, fields.object("b", &BODY, &PLACED)?];
    if bodies.iter().any(Fields::has_pose) {
        let dimension = bodies[0].dimension("center")?;
        return in_dimension!(dimension, "the center of a", under_poses(&bodies, method, seed));
    }
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
    Ok(Solution { method: method.id(), result: result(&location) })
}

fn under_poses<const D: usize>(
    bodies: &[Fields<'_>; 2],
    method: Option<&'static str>,
    seed: u64,
) -> Result<Solution, Refusal> {
    let [a, b] = [Posed::<D>::read(&bodies[0], "center")?, Posed::read(&bodies[1], "center")?];
    let (method, location) = locate_posed([&a, &b], method, seed)?;
    Ok(Solution { method, result: result(&location) })
}

fn result<const D: usize>(location: &Location<D>) -> Value {
    json!({
        "intersects": location.is_member(),
        "status": location.status().name(),
        "certificate": certificate(location),
    })
}

fn check(input: Traced<'_>, result: Traced<'_>, _method: Option<&str>) -> Result<verifier::Verdict, String> {
    let [a, b] = [Placed::read(member(input, "a")?, "center")?, Placed::read(member(input, "b")?, "center")?];
    proof::located(&verifier::Displaced::between(&a.body(), &b.body())?, result, "intersects")
}
