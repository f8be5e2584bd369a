//! Pictures of meshes: the work that a bounding volume makes of a question.

use serde_json::json;
use zonotope::bvh::{Encounter, Method};
use zonotope::tally::{Operation, OperationCounts};

use super::picture::Picture;
use crate::json::to_json;
use crate::meshes::{Placing, placing};
use crate::nearest::did_you_mean;
use crate::refusal::{Code, Refusal};

pub(super) const MESH_TESTS: Picture = Picture {
    name: "mesh_tests",
    summary: "the tests of nodes and triangles until it is decided whether two meshes meet, by a volume's name",
    fields: &["a", "b", "volume"],
    draw: |fields| {
        let name = fields.text("volume")?;
        let method = Method::from_id(name).ok_or_else(|| {
            let names = Method::ALL.map(Method::id);
            let near = did_you_mean(name, names);
            let message = format!("there is no volume `{name}`; the volumes are {}{near}", names.join(", "));
            Refusal::new(Code::UnknownMethod, message)
        })?;
        let Placing { meshes: [a, b], poses: [of_a, of_b] } = placing(fields)?;
        // of a mesh and its copy the hierarchy is built once
        let second = if a == b { &a } else { &b };
        let mut counts = OperationCounts::default();
        let encounter = method.encounter([a.at(&of_a), second.at(&of_b)], &mut counts);
        let [nodes, triangles] = [Operation::NodeTest, Operation::TriangleTest].map(|of| counts.get(of));
        let mut content = json!({"node_tests": nodes, "triangle_tests": triangles});
        match encounter {
            Encounter::Meeting(witness) => content["witness"] = json!(witness),
            Encounter::Apart(distance) => {
                content["distance"] = json!([to_json(distance.lower), to_json(distance.upper)])
            }
        }
        Ok(content.into())
    },
};
