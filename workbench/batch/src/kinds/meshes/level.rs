//! `mesh_level`: the bounding volumes of a level of a mesh's hierarchy, which are zonotopes of few generators.

use serde_json::{Value, json};
use verifier::{ClaimedNode, Verdict, check_mesh_level};
use zonotope::bvh::{Enclosed, Method};

use super::mesh::Read;
use crate::claimed::{Traced, float, index, indices, member, vector, vectors};
use crate::fields::Fields;
use crate::json::{to_json, vector_to_json};
use crate::kinds::{Kind, Solution};
use crate::meshes::{MESH, check_size, mesh};
use crate::refusal::{Code, Refusal};

pub(in crate::kinds) const KIND: Kind = Kind {
    name: "mesh_level",
    summary: "the bounding volumes of a level of a mesh's hierarchy, and the triangles in each",
    fields: &["a", "level"],
    optional: &[],
    methods: || Method::SHAPED.map(Method::id).to_vec(),
    solve,
    check,
};

/// The deepest level.
const LEVEL_LIMIT: u64 = 20;

fn solve(fields: &Fields<'_>, method: Option<&'static str>, _seed: u64) -> Result<Solution, Refusal> {
    let method = match method {
        Some(name) => Method::from_id(name).expect("the kind lists the names of these methods"),
        None => Method::SHAPED[0],
    };
    let mesh = mesh(&fields.object("a", &MESH, &[])?, "a")?;
    check_size([&mesh])?;
    let level = fields.count("level")?;
    if level > LEVEL_LIMIT {
        return Err(Refusal::new(Code::TooLarge, format!("level is {level}, at most {LEVEL_LIMIT} is taken")));
    }
    let nodes = method.level(&mesh, level as usize).expect("the kind lists volumes that are zonotopes");
    let nodes = nodes.map_err(|error| Refusal::new(Code::TooLarge, format!("a: {error}")))?;
    Ok(Solution { method: method.id(), result: json!({"nodes": nodes.iter().map(of_node).collect::<Value>()}) })
}

fn of_node(node: &Enclosed) -> Value {
    let generators = node.shape.generators().iter().map(|generator| vector_to_json(generator));
    json!({
        "center": vector_to_json(&node.shape.center()),
        "generators": generators.collect::<Value>(),
        "margin": to_json(node.margin),
        "triangles": node.triangles,
    })
}

fn check(input: Traced<'_>, result: Traced<'_>, _method: Option<&str>) -> Result<Verdict, String> {
    let mesh = Read::of(input, "a")?;
    let level = index(input, "level")?;
    let node = |node: Traced<'_>| -> Result<ClaimedNode, String> {
        Ok(ClaimedNode {
            center: vector(member(node, "center")?, "center")?,
            generators: vectors(member(node, "generators")?, "generators")?,
            margin: float(node, "margin")?,
            triangles: indices(node, "triangles")?,
        })
    };
    let nodes = member(result, "nodes")?.elements().ok_or("`nodes` is not a list")?;
    let nodes: Vec<ClaimedNode> = nodes.map(node).collect::<Result<_, _>>()?;
    Ok(check_mesh_level(&mesh.surface(), level, &nodes).in_words())
}
