//! The number of faces.

use zonotope::zonotope::combinatorics;

use crate::claim::{Check, CheckContext, Claim, ClaimKind, Place, Tried, Verdict};
use crate::instances::bodies::{are_independent, bodies, bodies_in_general_position};
use crate::instances::polygons::generator;

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "face-count",
    place: Place { section: "3", label: "first paragraph" },
    kind: ClaimKind::Statement,
    statement: "In R^d a zonotope with n generators has complexity O(n^(d-1)), and the topology of its boundary is \
        that of an arrangement",
    code: &["zonotope::zonotope::faces"],
    figures: &["scaling-face-counts"],
    check: Check::Run(check),
    tried: Tried::On(&["bodies in general position", "random bodies", "degenerate bodies"]),
    ..Claim::LISTED
};

/// In space: n(n−1) facets, 2n(n−1) edges and n(n−1) + 2 vertices in general position, never more; Euler's formula
/// always.
fn check(context: &CheckContext) -> Verdict {
    let mut random = generator(context.seed, 38);
    let (mut general, mut others) = (0, 0);
    for instance in bodies_in_general_position(&mut random, 28).into_iter().chain(bodies(&mut random, 60)) {
        let body = instance.body();
        if !body.holds_inside(&body.center) {
            continue;
        }
        let facets = body.facets();
        let edges: usize = facets.iter().map(|facet| facet.corners.len()).sum::<usize>() / 2;
        let vertices = body.vertices().len();
        let n = body.generators.len();
        let most = n * (n - 1);
        let library = combinatorics(&instance.in_doubles());
        if [library.vertices, library.edges, library.facets]
            != [vertices, edges, facets.len()].map(|count| count as u64)
        {
            return Verdict::Inconclusive(format!("{}: the library counts {library:?}", instance.name));
        }
        let independent = are_independent(&instance.generators);
        let counts = format!("{}: {vertices} vertices, {edges} edges, {} facets", instance.name, facets.len());
        if vertices + facets.len() != edges + 2 || facets.len() > most || edges > 2 * most || vertices > most + 2 {
            return Verdict::Refuted(counts);
        }
        if independent && facets.len() != most {
            return Verdict::Refuted(counts);
        }
        if independent { general += 1 } else { others += 1 }
    }
    Verdict::Holds(format!(
        "{general} bodies of R^3 with independent triples have n(n-1) facets, 2n(n-1) edges and n(n-1) + 2 vertices; \
         {others} others have no more, and Euler's formula holds for all; the library counts the same"
    ))
}
