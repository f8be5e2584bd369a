//! Section 5.2, footnote 2.

use dashu_ratio::RBig;

use crate::claim::{Check, CheckContext, Claim, ClaimKind, Place, Tried, Verdict};
use crate::definitions::enclosing::rank;
use crate::definitions::space::Vector;
use crate::instances::bodies::bodies_in_general_position;
use crate::instances::polygons::generator;

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "rotations-in-the-sum",
    place: Place { section: "5.2", label: "footnote 2" },
    kind: ClaimKind::Statement,
    statement: "The Minkowski sum method works for rotations too, but it raises the dimension from three to six and \
        increases the complexity significantly",
    code: &["zonotope::zonotope"],
    check: Check::Run(check),
    tried: Tried::Scope("bodies in general position"),
    ..Claim::LISTED
};

/// The velocities that translations and rotations give to the vertices of a body: three directions of translation, six
/// of both together.
fn check(context: &CheckContext) -> Verdict {
    let mut random = generator(context.seed, 108);
    let instances = bodies_in_general_position(&mut random, 21);
    for instance in &instances {
        let vertices: Vec<Vector> = instance.body().vertices().into_iter().take(4).collect();
        let axes = [[1, 0, 0], [0, 1, 0], [0, 0, 1]].map(Vector::at);
        let shifts: Vec<Vec<RBig>> = axes.iter().map(|axis| flat(vertices.iter().map(|_| axis.clone()))).collect();
        let turns = axes.iter().map(|axis| flat(vertices.iter().map(|vertex| axis.cross(vertex))));
        let all: Vec<Vec<RBig>> = shifts.iter().cloned().chain(turns).collect();
        if [rank(&shifts), rank(&all)] != [3, 6] {
            return Verdict::Refuted(instance.name.clone());
        }
    }
    Verdict::InPart(format!(
        "the vertices of {} bodies have three independent velocities under translations and six under rigid motions, \
         so the placements have that many dimensions; the complexity in them was not tried",
        instances.len()
    ))
}

fn flat(vectors: impl Iterator<Item = Vector>) -> Vec<RBig> {
    vectors.flat_map(|vector| vector.0).collect()
}
