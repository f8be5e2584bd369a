//! The meshes of a question: their fields, their size, and where they stand.

use zonotope::Pose;
use zonotope::bvh::{Mesh, MeshError};

use crate::fields::Fields;
use crate::placement::PLACED;
use crate::refusal::{Code, Refusal};

/// The fields of a mesh.
pub(crate) const MESH: [&str; 2] = ["vertices", "triangles"];

/// The most triangles of all meshes of a question.
const TRIANGLE_LIMIT: usize = 1_000_000;

/// The number of coordinates.
pub(crate) const SPACE: usize = 3;

/// The two meshes of a question, and where they stand.
pub(crate) struct Placing {
    pub(crate) meshes: [Mesh; 2],
    pub(crate) poses: [Pose; 2],
}

/// The meshes `a` and `b` of a question with their poses.
pub(crate) fn placing(fields: &Fields<'_>) -> Result<Placing, Refusal> {
    let read = ["a", "b"].map(|name| fields.object(name, &MESH, &PLACED));
    let [of_a, of_b] = read;
    let [of_a, of_b] = [of_a?, of_b?];
    let meshes = [mesh(&of_a, "a")?, mesh(&of_b, "b")?];
    let poses = [of_a.placement(SPACE)?, of_b.placement(SPACE)?].map(|placement| placement.of_space(1.0));
    check_size(&meshes)?;
    Ok(Placing { meshes, poses })
}

/// Refuses meshes of too many triangles.
pub(crate) fn check_size<'a>(meshes: impl IntoIterator<Item = &'a Mesh>) -> Result<(), Refusal> {
    let triangles: usize = meshes.into_iter().map(|mesh| mesh.triangles().len()).sum();
    if triangles <= TRIANGLE_LIMIT {
        return Ok(());
    }
    let message = format!("{triangles} triangles, at most {TRIANGLE_LIMIT} of all meshes are taken");
    Err(Refusal::new(Code::TooLarge, message))
}

/// The mesh of an object with vertices and triangles, before its pose.
pub(crate) fn mesh(fields: &Fields<'_>, name: &str) -> Result<Mesh, Refusal> {
    let (vertices, triangles) = (fields.vectors::<SPACE>("vertices")?, fields.triples("triangles")?);
    Mesh::new(vertices, triangles).map_err(|error| match error {
        MeshError::Empty => Refusal::new(Code::Empty, format!("{name} has no triangles")),
        MeshError::NoSuchVertex { triangle, corner, vertex, vertices } => Refusal::bad_input(format!(
            "{}, corner {} is {vertex}: there are {vertices} vertices, counted from 0",
            fields.place_of("triangles").element(triangle),
            corner + 1
        )),
        MeshError::TooLarge { .. } => Refusal::new(Code::TooLarge, format!("{name}: {error}")),
        other => Refusal::new(Code::NonFinite, format!("{name}: {other}")),
    })
}
