//! `gauge`: how many times a zonotope must be taken to reach from one point to another.

use serde_json::json;
use zonotope::collision::Query;

use super::collision::{Task, certificate, gauge};
use super::{Kind, Solution};
use crate::dimension::in_dimension;
use crate::fields::Fields;
use crate::json::to_json;
use crate::refusal::Refusal;

pub(super) const KIND: Kind = Kind {
    name: "gauge",
    summary: "how many times a zonotope around the origin must be taken to hold the way from p to q",
    fields: &["p", "q", "generators"],
    methods: || Task::Gauge.method_names(),
    solve,
};

fn solve(fields: &Fields<'_>, method: Option<&'static str>, _seed: u64) -> Result<Solution, Refusal> {
    in_dimension!(fields.dimension("p")?, "p", in_space(fields, method))
}

fn in_space<const D: usize>(fields: &Fields<'_>, method: Option<&'static str>) -> Result<Solution, Refusal> {
    let [p, q] = [fields.vector::<D>("p")?, fields.vector::<D>("q")?];
    let generators = fields.vectors::<D>("generators")?;
    let method = Task::Gauge.method::<D>(method, generators.len())?;
    let question = Query::new(p, q, &generators).expect("the numbers of a question are finite");
    let gauge = gauge(method, &question);
    let result = json!({
        "gauge": to_json(gauge.value),
        "at_most_one": gauge.location.is_member(),
        "certificate": certificate(&question, &gauge.location),
    });
    Ok(Solution { method: method.id(), result })
}
