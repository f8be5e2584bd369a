//! Section 7, fifth question.

use experiments::hierarchies::{Scene, scene};
use zonotope::Pose;
use zonotope::bvh::{BoundingVolume, Bvh, OrientedBox, Zonotope4, Zonotope6};
use zonotope::tally::{Operation, OperationCounts};

use crate::claim::{Check, CheckContext, Claim, ClaimKind, Place, Tried, Verdict};

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "question-hierarchies",
    place: Place { section: "7", label: "fifth question" },
    kind: ClaimKind::OpenQuestion,
    statement: "How can bounding volume hierarchies of zonotopes be built for arbitrary polyhedral geometry?",
    remedy: Some(
        "a tree over the triangles by the surface area heuristic; for each node few generators of which the expected \
            number of overlaps with its like, V1 V2 + 2 V3 in intrinsic volumes, is little: directions from a \
            dictionary, then a descent by linear programs. A test goes along the facet normals of both nodes, of up \
            to four generators along the normals of edges, too. That these are the best hierarchies is not shown",
    ),
    code: &["zonotope::bvh", "zonotope::bvh::volumes::zonotope"],
    figures: &["mesh-in-hierarchy", "mesh-node-tests", "mesh-cost-against-fit"],
    check: Check::Run(check),
    tried: Tried::On(&["a mesh of a body", "a mesh of thin parts"]),
};

/// The meshes.
const MESHES: [&str; 2] = ["teapot", "needles"];

/// Poses of each mesh.
const POSES: usize = 6;

/// The place of the distance of one per cent among those of the poses.
const ONE_PER_CENT: usize = 2;

/// Volumes contain their triangles exactly, hierarchies find the pairs that boxes find, and with fewer tests.
fn check(context: &CheckContext) -> Verdict {
    match MESHES.into_iter().map(|name| on_mesh(name, context.seed)).collect::<Result<Vec<String>, String>>() {
        Err(reason) => Verdict::Inconclusive(reason),
        Ok(found) => Verdict::InPart(format!(
            "hierarchies of zonotopes over two meshes contain their triangles in each of their nodes, exactly, and \
             find the pairs of triangles that those of boxes find; tests of nodes of copies one per cent of the \
             diagonal apart, over those of boxes that a search turns: {}",
            found.join("; ")
        )),
    }
}

fn on_mesh(name: &str, seed: u64) -> Result<String, String> {
    let scene = scene(name, POSES, seed)?;
    let boxes = on_volume::<OrientedBox>(&scene)?;
    let [four, six] = [on_volume::<Zonotope4>(&scene)?, on_volume::<Zonotope6>(&scene)?];
    if four.1 != boxes.1 || six.1 != boxes.1 {
        return Err(format!("{name}: other pairs than by boxes"));
    }
    let ratio = |tests: u64| tests as f64 / boxes.0 as f64;
    Ok(format!("{name} {:.2} with four generators, {:.2} with six", ratio(four.0), ratio(six.0)))
}

/// The tests of nodes of copies that are apart, and the pairs of those that overlap.
fn on_volume<V: BoundingVolume>(scene: &Scene) -> Result<(u64, Vec<[usize; 2]>), String> {
    let hierarchy = Bvh::<V>::build(&scene.mesh);
    hierarchy.validate().map_err(|fault| format!("{}: {fault}", V::NAME))?;
    let mut counts = OperationCounts::default();
    let mut pairs = Vec::new();
    for placed in &scene.placed {
        let still = hierarchy.at(&Pose::IDENTITY);
        if still.witness(hierarchy.at(&placed.apart[ONE_PER_CENT]), &mut counts).is_some() {
            return Err(format!("{}: copies that are apart meet", V::NAME));
        }
        pairs.extend(still.pairs(hierarchy.at(&placed.overlapping)));
    }
    Ok((counts.get(Operation::NodeTest), pairs))
}
