//! `gauge`: how many times a zonotope must be taken to reach from one point to another.

use serde_json::{Value, json};
use zonotope::collision::{Gauge, Query, by_lad};

use super::posed::{Posed, Prism, SPACE};
use super::{Task, certificate, gauge, posed_method, proof};
use crate::claimed::{Placed, Traced, boolean, float, member, vector};
use crate::dimension::in_dimension;
use crate::fields::Fields;
use crate::json::to_json;
use crate::kinds::{Kind, Solution};
use crate::refusal::Refusal;

pub(in crate::kinds) const KIND: Kind = Kind {
    name: "gauge",
    summary: "how many times a zonotope around the origin must be taken to hold the way from p to q",
    fields: &["p", "q", "generators"],
    optional: &["pose"],
    methods: || Task::Gauge.method_names(),
    solve,
    check,
};

fn solve(fields: &Fields<'_>, method: Option<&'static str>, _seed: u64) -> Result<Solution, Refusal> {
    if fields.has_pose() {
        return in_dimension!(fields.dimension("p")?, "p", under_pose(fields, method));
    }
    in_dimension!(fields.dimension("p")?, "p", in_space(fields, method))
}

fn in_space<const D: usize>(fields: &Fields<'_>, method: Option<&'static str>) -> Result<Solution, Refusal> {
    let [p, q] = [fields.vector::<D>("p")?, fields.vector::<D>("q")?];
    let generators = fields.vectors::<D>("generators")?;
    let method = Task::Gauge.method::<D>(method, generators.len())?;
    let question = Query::new(p, q, &generators).expect("the numbers of a question are finite");
    Ok(Solution { method: method.id(), result: result(&gauge(method, &question)) })
}

/// With a pose, p is the centre of the body and moves with it.
fn under_pose<const D: usize>(fields: &Fields<'_>, method: Option<&'static str>) -> Result<Solution, Refusal> {
    let body = Posed::<D>::read(fields, "p")?;
    let q = fields.vector::<D>("q")?;
    if D > SPACE {
        let image = body.image()?;
        let method = Task::Gauge.method::<D>(method, image.generators().len())?;
        let question = Query::of_point(q, &image).expect("the numbers of a question are finite");
        return Ok(Solution { method: method.id(), result: result(&gauge(method, &question)) });
    }
    let method = posed_method(method)?;
    let prism = Prism::over(&body, &Posed::of_point(q));
    let gauge = by_lad::nearest_gauge(&prism.query_of(q), &mut ());
    Ok(Solution { method, result: result(&prism.hidden().gauge(&gauge)) })
}

fn result<const D: usize>(gauge: &Gauge<D>) -> Value {
    json!({
        "gauge": to_json(gauge.value),
        "at_most_one": gauge.location.is_member(),
        "certificate": certificate(&gauge.location),
    })
}

fn check(input: Traced<'_>, result: Traced<'_>, _method: Option<&str>) -> Result<verifier::Verdict, String> {
    let (body, q) = (Placed::read(input, "p")?, vector(member(input, "q")?, "q")?);
    let answer = verifier::GaugeAnswer {
        gauge: float(result, "gauge")?,
        at_most_one: boolean(result, "at_most_one")?,
        certificate: proof::certificate(member(result, "certificate")?)?,
    };
    Ok(verifier::check_gauge(&verifier::Displaced::to_point(&body.body(), &q)?, &answer).in_words())
}
