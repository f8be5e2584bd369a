//! The check of `collide` about meshes: the order of the triangles, the stretches, and what the meshes do after them.

use super::claimed_contact::{interval, motion, numbers, resolution};
use crate::claimed::{Traced, indices, member, text};
use crate::kinds::meshes::mesh::{Read, pair};
use verifier::{FreeParts, MeshContactAnswer, MeshEncounter, Motion, MovingSurface, Verdict, check_mesh_contact};

pub(super) fn check(input: Traced<'_>, result: Traced<'_>) -> Result<Verdict, String> {
    let motions = member(input, "motion")?;
    let meshes = [Read::of(input, "a")?.image()?, Read::of(input, "b")?.image()?];
    let motions = [motion(motions, "a")?, motion(motions, "b")?];
    let resolution = resolution(input)?;
    Ok(check_mesh_contact([0, 1].map(|i| moving(&meshes[i], &motions[i])), resolution, &answer(result)?))
}

fn moving<'a>(mesh: &'a Read, motion: &'a Motion) -> MovingSurface<'a> {
    MovingSurface { vertices: &mesh.vertices, triangles: &mesh.triangles, motion }
}

/// The fields of an answer of its status: others are not read, so they are not called right.
fn answer(result: Traced<'_>) -> Result<MeshContactAnswer, String> {
    let certificate = member(result, "certificate")?;
    let time = || numbers(result, "time");
    let triangles = || pair(indices(result, "triangles")?, "triangles");
    let encounter = match text(result, "status")? {
        "separate" => MeshEncounter::Separate,
        "contact" => MeshEncounter::Contact { time: time()?, triangles: triangles()? },
        "grazing" => MeshEncounter::Grazing { time: time()?, triangles: triangles()? },
        other => return Err(format!("there is no status `{other}`")),
    };
    let order = member(certificate, "order")?;
    let intervals = member(certificate, "intervals")?.elements().ok_or("`intervals` is not a list")?;
    let free = |tree: Traced<'_>| -> Result<FreeParts, String> {
        let part = |name| pair(indices(tree, name)?, name);
        Ok(FreeParts { interval: interval(tree)?, parts: [part("a")?, part("b")?] })
    };
    Ok(MeshContactAnswer {
        encounter,
        order: [indices(order, "a")?, indices(order, "b")?],
        intervals: intervals.map(free).collect::<Result<_, _>>()?,
    })
}
