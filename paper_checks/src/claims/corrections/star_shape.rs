//! Section 5.2, proof of Corollary 5.4.

use zonotope::collision::prepared::by_cutting::PreparedByCutting;
use zonotope::zonotope::Zonotope;

use crate::claim::{Check, CheckContext, Claim, ClaimKind, Correction, Place, Tried, Verdict};
use crate::definitions::ratio::integer;
use crate::definitions::space::{Body, Vector};

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "location-of-rays",
    place: Place { section: "5.2", label: "proof of Corollary 5.4" },
    kind: ClaimKind::Correction(Correction::MissingCondition),
    statement: "The intersection of a ray with the boundary can be reduced to point location in the boundary's map to \
        a sphere, with the same technique and bound",
    remedy: Some(
        "one step is missing: the silhouette is star-shaped from the centre, so the side test works for rays; off the \
            span of a flat zonotope the distance is infinite",
    ),
    code: &["zonotope::collision::prepared::by_cutting"],
    check: Check::Run(check),
    tried: Tried::Witness,
    ..Claim::LISTED
};

/// A ray that leaves a cube by a vertical side, of which no multiple lies over Q's interior where it leaves, and one
/// that never meets a flat body.
fn check(_context: &CheckContext) -> Verdict {
    let gauge = |generators: &[[f64; 3]], point: [f64; 3]| {
        let body = Zonotope::new([0.0; 3], generators.to_vec()).expect("the coordinates are finite");
        let space = (generators.len() * generators.len()) as u64;
        let prepared = PreparedByCutting::new(body, space, 0, &mut ()).expect("the space is the square of the number");
        prepared.facet(point, &mut ()).expect("the point is finite").value().0
    };
    let cube = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    // the point (4, 1, 2) lies beside Q; its ray leaves by the side x = 1, at a quarter of it
    let aside = gauge(&cube, [4.0, 1.0, 2.0]);
    let body = Body::about_origin(&[[1, 0, 0], [0, 1, 0], [0, 0, 1]]);
    let leaves = |factor: i64| {
        let point = Vector(Vector::at([4, 1, 2]).0.map(|c| c / integer(factor)));
        body.holds(&point)
    };
    let off = gauge(&cube[..2], [0.25, 0.0, 1.0]);
    if aside != 4.0 || !leaves(4) || leaves(3) || off != f64::INFINITY {
        return Verdict::Holds(format!("the gauges are {aside} and {off}"));
    }
    Verdict::Refuted(
        "the point (4,1,2) lies beside the projection of a cube, and locating it says no more; its ray leaves by a \
         vertical side at a quarter of it, and the gauge is 4; a ray off a flat square never meets a multiple of it, \
         and the gauge is infinite"
            .to_owned(),
    )
}
