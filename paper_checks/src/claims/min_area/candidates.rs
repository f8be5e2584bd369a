//! Section 4.1: the candidates of the search.

use crate::claim::{Check, CheckContext, Claim, ClaimKind, Place, Tried, Verdict};
use crate::definitions::plane::{arrangement_vertices, bisectors};
use crate::instances::polygons::{generator, polygons};

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "candidates",
    place: Place { section: "4.1", label: "before Theorem 4.5" },
    kind: ClaimKind::Statement,
    statement: "There are O(n^2) candidate vertices at the beginning of the search",
    code: &["zonotope::enclosing::bisectors"],
    check: Check::Run(check),
    tried: Tried::On(&["random polygons", "degenerate polygons"]),
    ..Claim::LISTED
};

/// Two lines have at most one vertex: n(n-1)/2 in all, fewer where lines are parallel or meet in one point.
fn check(context: &CheckContext) -> Verdict {
    let mut random = generator(context.seed, 104);
    let instances = polygons(&mut random, 60);
    let mut full = 0;
    for instance in &instances {
        let n = instance.polygon.len();
        let vertices = arrangement_vertices(&bisectors(&instance.polygon)).len();
        if vertices > n * (n - 1) / 2 {
            return Verdict::Refuted(format!("{}: {vertices} vertices", instance.name));
        }
        full += usize::from(vertices == n * (n - 1) / 2);
    }
    Verdict::Holds(format!(
        "the lines l_t of {} polygons have at most n(n-1)/2 vertices, as many for {full} of them",
        instances.len()
    ))
}
