//! In space, central symmetry is not enough.

use std::collections::BTreeSet;

use crate::claim::{Check, CheckContext, Claim, ClaimKind, Place, Tried, Verdict};
use crate::definitions::ratio::{fraction, integer};
use crate::definitions::space::{Body, Vector};

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "spatial-symmetric-not-zonotope",
    place: Place { section: "1", label: "second paragraph" },
    kind: ClaimKind::Statement,
    statement: "In three and more dimensions there are centrally symmetric convex polytopes that are not zonotopes",
    code: &["zonotope::zonotope"],
    check: Check::Run(check),
    tried: Tried::Witness,
    ..Claim::LISTED
};

/// The octahedron. An edge of a sum of segments is a translate of the parallel segments, so a zonotope is the sum of
/// its edges, one of each direction: for the octahedron that sum is another body.
fn check(_context: &CheckContext) -> Verdict {
    let corners: Vec<Vector> =
        [[1, 0, 0], [-1, 0, 0], [0, 1, 0], [0, -1, 0], [0, 0, 1], [0, 0, -1]].map(Vector::at).to_vec();
    let symmetric = corners.iter().all(|corner| corners.contains(&Vector::at([0; 3]).plus(&integer(-1), corner)));
    let mut edges: BTreeSet<Vector> = BTreeSet::new();
    for (index, a) in corners.iter().enumerate() {
        for b in &corners[..index] {
            let opposite = Vector::at([0; 3]).plus(&integer(-1), a) == *b;
            if !opposite {
                edges.insert(a.to(b).line());
            }
        }
    }
    let half_edges = edges.iter().map(|edge| Vector::at([0; 3]).plus(&fraction(1, 2), edge)).collect();
    let sum = Body { center: Vector::at([0; 3]), generators: half_edges };
    let vertices = sum.vertices();
    if !symmetric || vertices.iter().all(|vertex| corners.contains(vertex)) {
        return Verdict::Refuted("the octahedron is the sum of its edges".to_owned());
    }
    if !(3..=5).all(has_triangle) {
        return Verdict::Inconclusive("a cross-polytope has no triangle".to_owned());
    }
    Verdict::Holds(format!(
        "the octahedron is centrally symmetric, and the sum of its {} edge directions at the edges' length is a body \
         of {} vertices and not the octahedron of {}; in R^3, R^4 and R^5 the cross-polytope has a triangle for a \
         face, and the two-dimensional faces of a zonotope are zonogons",
        edges.len(),
        vertices.len(),
        corners.len()
    ))
}

/// Whether three vertices of the cross-polytope ± e_i are all that it has farthest along e_1 + e_2 + e_3: the corners
/// of a face of two dimensions that has no centre of symmetry.
fn has_triangle(dimension: usize) -> bool {
    let along = |axis: usize, sign: i64| if axis < 3 { sign } else { 0 };
    let corners = (0..dimension).flat_map(|axis| [1, -1].map(|sign| along(axis, sign)));
    let heights: Vec<i64> = corners.collect();
    heights.iter().max() == Some(&1) && heights.iter().filter(|height| **height == 1).count() == 3
}
