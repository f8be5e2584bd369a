//! The other Minkowski difference.

use std::collections::BTreeSet;

use dashu_ratio::RBig;

use crate::claim::{Check, CheckContext, Claim, ClaimKind, Place, Tried, Verdict};
use crate::definitions::space::{Body, Vector};

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "erosion",
    place: Place { section: "1", label: "first bullet" },
    kind: ClaimKind::Note,
    statement: "Zonotopes are closed under Minkowski difference: two intersect when the origin is in theirs",
    remedy: Some(
        "the difference that the paper means and uses is A + (-B); the erosion { x : x + B in A }, which has the same \
            name elsewhere, is no zonotope in general when d > 2",
    ),
    code: &["zonotope::zonotope"],
    check: Check::Run(check),
    tried: Tried::Witness,
    ..Claim::LISTED
};

/// Erodes small bodies by segments until a facet of the erosion has an odd number of sides, which no zonotope has.
fn check(_context: &CheckContext) -> Verdict {
    let bodies: [(&str, &[[i64; 3]]); 2] = [
        ("the rhombic dodecahedron ⟨(±1,±1,1)⟩", &[[1, 1, 1], [1, 1, -1], [1, -1, 1], [-1, 1, 1]]),
        (
            "the truncated octahedron ⟨(±1,1,0), (±1,0,1), (0,±1,1)⟩",
            &[[1, 1, 0], [1, -1, 0], [1, 0, 1], [1, 0, -1], [0, 1, 1], [0, 1, -1]],
        ),
    ];
    let segments = [[0, 0, 1], [1, 0, 0], [1, 1, 1], [1, 1, 0]];
    for (name, generators) in bodies {
        for segment in segments {
            let erosion = erode(&Body::about_origin(generators), &Body::about_origin(&[segment]));
            let odd = erosion.iter().find(|(_, corners)| corners.len() % 2 == 1);
            if let Some((normal, corners)) = odd {
                return Verdict::Holds(format!(
                    "{name} eroded by the segment ⟨{}⟩: the facet with normal {normal} has {} corners, {}, and so is \
                     not centrally symmetric as every facet of a zonotope is",
                    Vector::at(segment),
                    corners.len(),
                    corners.iter().map(Vector::to_string).collect::<Vec<_>>().join(" ")
                ));
            }
        }
    }
    Verdict::Inconclusive("every erosion tried has facets with an even number of sides".to_owned())
}

/// The facets of { x : x + B ⊂ A }: A's halfspaces moved inwards by the reach of B.
fn erode(a: &Body, b: &Body) -> Vec<(Vector, BTreeSet<Vector>)> {
    let halfspaces: Vec<(Vector, RBig)> =
        a.normals().into_iter().map(|normal| (normal.clone(), a.reach(&normal) - b.reach(&normal))).collect();
    let mut corners = BTreeSet::new();
    for (i, (u, s)) in halfspaces.iter().enumerate() {
        for (j, (v, t)) in halfspaces[..i].iter().enumerate() {
            for (w, r) in &halfspaces[..j] {
                let volume = u.dot(&v.cross(w));
                if volume == RBig::ZERO {
                    continue;
                }
                let sum = Vector::at([0; 3]).plus(s, &v.cross(w)).plus(t, &w.cross(u)).plus(r, &u.cross(v));
                let point = Vector(sum.0.map(|c| c / &volume));
                if halfspaces.iter().all(|(normal, reach)| normal.dot(&point) <= *reach) {
                    corners.insert(point);
                }
            }
        }
    }
    let on = |(normal, reach): &(Vector, RBig)| {
        let corners: BTreeSet<Vector> = corners.iter().filter(|corner| normal.dot(corner) == *reach).cloned().collect();
        (normal.clone(), corners)
    };
    halfspaces.iter().map(on).filter(|(_, corners)| corners.len() >= 3).collect()
}
