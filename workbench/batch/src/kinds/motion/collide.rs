//! `collide`: whether two moving bodies of space meet during a step of time, and when first; both are zonotopes, or
//! meshes of triangles.

use serde_json::{Value, json};
use verifier::Verdict;
use zonotope::collision::Witness;
use zonotope::motion::continuous::{FirstContact, Method};

use super::stated::{motion, resolution};
use super::written::interval;
use super::{claimed_contact, claimed_mesh_contact, of_meshes};
use crate::claimed::{Traced, member};
use crate::fields::Fields;
use crate::json::{to_json, vector_to_json};
use crate::kinds::{BODY, Kind, PLACED, Solution};
use crate::meshes::MESH;
use crate::refusal::{Code, Refusal};

pub(in crate::kinds) const KIND: Kind = Kind {
    name: "collide",
    summary: "when two moving zonotopes of space, or two meshes, meet first, or that they do not",
    fields: &["a", "b", "motion"],
    optional: &["resolution"],
    methods: || Method::ALL.map(Method::id).to_vec(),
    solve,
    check,
};

/// The most generators of both bodies: each stretch of time takes some passes over them.
const GENERATOR_LIMIT: usize = 200_000;

fn solve(fields: &Fields<'_>, method: Option<&'static str>, _seed: u64) -> Result<Solution, Refusal> {
    let named = |name| Method::from_id(name).expect("the kind lists the names of these methods");
    let method = method.map_or(Method::default(), named);
    if of_meshes::are_meshes(["a", "b"].map(|name| fields.has_one_of(name, &MESH)))? {
        return of_meshes::solve(fields, method);
    }
    let bodies = [fields.object("a", &BODY, &PLACED)?, fields.object("b", &BODY, &PLACED)?];
    let [a, b] = [bodies[0].image::<3>()?, bodies[1].image::<3>()?];
    let motions = fields.object("motion", &[], &["a", "b"])?;
    let [of_a, of_b] = [motion(&motions, "a")?, motion(&motions, "b")?];
    let resolution = resolution(fields)?;
    let generators = a.generators().len() + b.generators().len();
    if generators > GENERATOR_LIMIT {
        let message = format!("{generators} generators, at most {GENERATOR_LIMIT} of both bodies are taken");
        return Err(Refusal::new(Code::TooLarge, message));
    }
    let found = method.first_contact([&a, &b], [&of_a, &of_b], resolution, &mut ());
    Ok(Solution { method: method.id(), result: result(&found) })
}

fn check(input: Traced<'_>, result: Traced<'_>, _method: Option<&str>) -> Result<Verdict, String> {
    let is_mesh = |name: &str| member(input, name).map(|body| body.tree.field("triangles").is_some());
    if is_mesh("a")? && is_mesh("b")? {
        return claimed_mesh_contact::check(input, result);
    }
    claimed_contact::check(input, result)
}

fn result(found: &FirstContact) -> Value {
    let mut result = json!({"status": found.name()});
    let mut certificate = json!({"intervals": found.free().iter().map(interval).collect::<Vec<_>>()});
    match found {
        FirstContact::Separate { .. } => {}
        FirstContact::Contact { time, witness: Witness { coefficients, basis }, .. } => {
            result["time"] = vector_to_json(time);
            certificate["coefficients"] = vector_to_json(coefficients);
            certificate["basis"] = json!(basis);
        }
        FirstContact::Grazing { time, distance_at_most, .. } => {
            result["time"] = vector_to_json(time);
            result["distance_at_most"] = to_json(*distance_at_most);
        }
    }
    result["certificate"] = certificate;
    result
}
