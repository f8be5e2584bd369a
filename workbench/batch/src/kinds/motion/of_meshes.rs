//! `collide` about meshes: the answer with the order of the triangles, of which the parts in the proof are runs.

use serde_json::{Value, json};
use zonotope::bvh::{Bvh, Mesh, OrientedBox};
use zonotope::motion::continuous::Method;
use zonotope::motion::continuous::of_meshes::{FreePair, MeshContact, NotRational, Part, first_contact_counted};

use super::stated::{motion, resolution};
use super::written::interval;
use crate::fields::{Fields, SPACE, image_not_held};
use crate::json::vector_to_json;
use crate::kinds::{PLACED, Solution};
use crate::meshes::{MESH, check_size, mesh};
use crate::placement::{Placement, doubles};
use crate::refusal::{Code, Refusal};

/// The volume of the nodes: an oriented box is tighter than one along the axes, and both are zonotopes of three
/// generators to the proofs.
type Hierarchy = Bvh<OrientedBox>;

/// The most stretches of a proof that are written.
const STRETCH_LIMIT: usize = 300_000;

/// Whether both bodies are meshes, of bodies that seem to be.
pub(super) fn are_meshes(seem: [bool; 2]) -> Result<bool, Refusal> {
    match seem {
        [true, true] => Ok(true),
        [false, false] => Ok(false),
        [a_is, _] => {
            let [mesh, other] = if a_is { ["a", "b"] } else { ["b", "a"] };
            let message = format!("`{mesh}` is a mesh and `{other}` is none: both are zonotopes, or both are meshes");
            Err(Refusal::bad_input(message))
        }
    }
}

pub(super) fn solve(fields: &Fields<'_>, method: Method) -> Result<Solution, Refusal> {
    if method != Method::ByControlPoints {
        let message = format!("about meshes there is the method `{}` alone", Method::ByControlPoints.id());
        return Err(Refusal::new(Code::UnknownMethod, message));
    }
    let meshes = [posed(fields, "a")?, posed(fields, "b")?];
    check_size(&meshes)?;
    let motions = fields.object("motion", &[], &["a", "b"])?;
    let [of_a, of_b] = [motion(&motions, "a")?, motion(&motions, "b")?];
    let resolution = resolution(fields)?;
    let [a, b] = meshes.each_ref().map(Hierarchy::build);
    let found = first_contact_counted([&a, &b], [&of_a, &of_b], resolution, &mut ());
    let found = found.map_err(|NotRational { body }| {
        let place = motions.place_of(["a", "b"][body]);
        Refusal::bad_input(format!("{place} turns at constant rate: motions of meshes have `pieces`"))
    })?;
    let count = found.free().len();
    if count > STRETCH_LIMIT {
        let message = format!("the proof has {count} stretches of time, at most {STRETCH_LIMIT} are written");
        return Err(Refusal::new(Code::TooLarge, message));
    }
    Ok(Solution { method: method.id(), result: result(&found, [&a, &b]) })
}

/// The mesh under a name where its pose puts it: doubles must hold the image.
fn posed(fields: &Fields<'_>, name: &str) -> Result<Mesh, Refusal> {
    let object = fields.object(name, &MESH, &PLACED)?;
    let (mesh, placement) = (mesh(&object, name)?, object.placement(SPACE)?);
    if placement == Placement::identity(SPACE) {
        return Ok(mesh);
    }
    let exact = placement.exact();
    let image = |vertex: &[f64; SPACE]| <[f64; SPACE]>::try_from(doubles(&exact.point(vertex))?).ok();
    let vertices = mesh.vertices().iter().map(image).collect::<Option<Vec<_>>>();
    let moved = vertices.and_then(|vertices| mesh.with_vertices(vertices).ok());
    moved.ok_or_else(|| image_not_held(&object.place_of("pose"), SPACE))
}

fn result(found: &MeshContact, hierarchies: [&Hierarchy; 2]) -> Value {
    let orders = hierarchies.map(|hierarchy| hierarchy.topology().order());
    let places = orders.map(|order| {
        let mut places = vec![0; order.len()];
        (0..).zip(order).for_each(|(place, &triangle)| places[triangle as usize] = place);
        places
    });
    let run = |i: usize, part: Part| match part {
        Part::Node(node) => {
            let below = hierarchies[i].topology().nodes()[node].range();
            [below.start, below.end]
        }
        Part::Triangle(triangle) => [places[i][triangle], places[i][triangle] + 1],
    };
    let free = |FreePair { parts, stretch }: &FreePair| {
        let mut free = interval(stretch);
        free["a"] = json!(run(0, parts[0]));
        free["b"] = json!(run(1, parts[1]));
        free
    };
    let intervals: Vec<Value> = found.free().iter().map(free).collect();
    let mut result = json!({"status": found.name()});
    if let MeshContact::Contact { time, triangles, .. } | MeshContact::Grazing { time, triangles, .. } = found {
        result["time"] = vector_to_json(time);
        result["triangles"] = json!(triangles);
    }
    result["certificate"] = json!({"order": {"a": orders[0], "b": orders[1]}, "intervals": intervals});
    result
}
