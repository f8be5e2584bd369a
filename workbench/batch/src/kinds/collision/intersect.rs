//! `intersect`: whether two zonotopes have a point in common.

use serde_json::{Value, json};
use zonotope::collision::{Location, Query};

use super::{PLACED, Task, certificate, locate, posed_method};
use crate::dimension::in_dimension;
use crate::fields::Fields;
use crate::kinds::{BODY, Kind, Solution};
use crate::refusal::Refusal;

pub(in crate::kinds) const KIND: Kind = Kind {
    name: "intersect",
    summary: "whether two zonotopes overlap, only touch or are disjoint",
    fields: &["a", "b"],
    optional: &[],
    methods: || Task::Locate.method_names(),
    solve,
};

fn solve(fields: &Fields<'_>, method: Option<&'static str>, seed: u64) -> Result<Solution, Refusal> {
    let bodies = [fields.object("a", &BODY, &PLACED)?, fields.object("b", &BODY, &PLACED)?];
    if bodies.iter().any(Fields::has_pose) {
        return under_poses(&bodies, method);
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

fn under_poses([first, second]: &[Fields<'_>; 2], method: Option<&'static str>) -> Result<Solution, Refusal> {
    let [from, to] = [first.pose("center")?, second.pose("center")?];
    let [a, b] = [first.zonotope()?, second.zonotope()?];
    let method = posed_method(method)?;
    Ok(Solution { method, result: result(&a.at(&from).intersection(b.at(&to))) })
}

fn result<const D: usize>(location: &Location<D>) -> Value {
    json!({
        "intersects": location.is_member(),
        "status": location.status().name(),
        "certificate": certificate(location),
    })
}
