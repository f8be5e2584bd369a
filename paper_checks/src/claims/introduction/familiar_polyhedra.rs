//! Polyhedra that are zonotopes.

use std::collections::BTreeSet;

use crate::claim::{Check, CheckContext, Claim, ClaimKind, Place, Tried, Verdict};
use crate::definitions::ratio::fraction;
use crate::definitions::space::{Body, Vector};

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "familiar-zonotopes",
    place: Place { section: "1", label: "second paragraph" },
    kind: ClaimKind::Statement,
    statement: "Cubes, parallelepipeds, the truncated octahedron and the rhombic dodecahedron are zonotopes",
    code: &["zonotope::zonotope"],
    figures: &["named-zonohedra"],
    check: Check::Run(check),
    tried: Tried::Witness,
    ..Claim::LISTED
};

/// Compares the vertices of a sum of segments with the vertices that each polyhedron is known by.
fn check(_context: &CheckContext) -> Verdict {
    let cube = Body::about_origin(&[[1, 0, 0], [0, 1, 0], [0, 0, 1]]);
    let parallelepiped = Body::about_origin(&[[2, 0, 1], [1, 3, 0], [-1, 1, 4]]);
    let halves = |generators: &[[i64; 3]]| {
        let half = |&g: &[i64; 3]| Vector::at([0; 3]).plus(&fraction(1, 2), &Vector::at(g));
        Body { center: Vector::at([0; 3]), generators: generators.iter().map(half).collect() }
    };
    let truncated_octahedron = halves(&[[1, 1, 0], [1, -1, 0], [1, 0, 1], [1, 0, -1], [0, 1, 1], [0, 1, -1]]);
    let rhombic_dodecahedron = halves(&[[1, 1, 1], [1, 1, -1], [1, -1, 1], [-1, 1, 1]]);

    let cube_corners = sign_changes([1, 1, 1]);
    let edges = [[2, 0, 1], [1, 3, 0], [-1, 1, 4]];
    let parallelepiped_corners = cube_corners
        .iter()
        .map(|signs| {
            let terms = signs.0.iter().zip(edges);
            terms.fold(Vector::at([0; 3]), |corner, (sign, edge)| corner.plus(sign, &Vector::at(edge)))
        })
        .collect();
    let truncated_corners = permutations([0, 1, 2]).into_iter().flat_map(sign_changes).collect();
    let rhombic_corners = permutations([2, 0, 0]).into_iter().chain([[1, 1, 1]]).flat_map(sign_changes).collect();

    let mut counts = Vec::new();
    for (name, body, corners) in [
        ("cube", cube, cube_corners),
        ("parallelepiped", parallelepiped, parallelepiped_corners),
        ("truncated octahedron", truncated_octahedron, truncated_corners),
        ("rhombic dodecahedron", rhombic_dodecahedron, rhombic_corners),
    ] {
        if body.vertices() != corners {
            return Verdict::Refuted(format!("the {name} has other vertices than the sum of its segments"));
        }
        counts.push(format!(
            "{name}: {} segments, {} vertices, {} facets",
            body.generators.len(),
            corners.len(),
            body.facets().len()
        ));
    }
    Verdict::Holds(format!("the vertices of the sums are those of the polyhedra; {}", counts.join("; ")))
}

/// All points whose coordinates are these up to sign.
fn sign_changes(coordinates: [i64; 3]) -> BTreeSet<Vector> {
    (0..8)
        .map(|signs| {
            Vector::at(std::array::from_fn(|i| if signs >> i & 1 == 1 { -coordinates[i] } else { coordinates[i] }))
        })
        .collect()
}

fn permutations([a, b, c]: [i64; 3]) -> [[i64; 3]; 6] {
    [[a, b, c], [a, c, b], [b, a, c], [b, c, a], [c, a, b], [c, b, a]]
}
