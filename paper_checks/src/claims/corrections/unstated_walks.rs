//! Section 5.2, Lemma 5.6.

use zonotope::arrangement::facet_walk::{FacetName, FacetWalk, HullWalk, NormalSense};

use crate::claim::{Check, CheckContext, Claim, ClaimKind, Correction, Place, Tried, Verdict};
use crate::definitions::space::Vector;

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "neighbours-of-a-face",
    place: Place { section: "5.2", label: "Lemma 5.6" },
    kind: ClaimKind::Correction(Correction::MissingCondition),
    statement: "On each face of the tiling there are four choices of a neighbour, which are the neighbours of the \
        dual vertex in the arrangement",
    remedy: Some(
        "true of a face that has four neighbours in the tiling: past the last vertex of a dual line an unbounded edge \
            of the arrangement leads from the upper hull to the antipodal facet; without the paper's assumption of \
            independent generators a facet has more than four neighbours",
    ),
    code: &["zonotope::arrangement::facet_walk"],
    check: Check::Run(check),
    tried: Tried::Witness,
    ..Claim::LISTED
};

/// A hexagonal prism, whose top has six neighbours, and a tripod of generators above the plane, whose upper facets have
/// neighbours of the lower hull.
fn check(_context: &CheckContext) -> Verdict {
    let prism = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [1.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    let Ok(mut walk) = HullWalk::new(&prism) else {
        return Verdict::Inconclusive("there is no walk on a hexagonal prism".to_owned());
    };
    let top = FacetName::new(0, 1, NormalSense::Along);
    if walk.place_at(top).is_err() {
        return Verdict::Inconclusive("the prism has no top".to_owned());
    }
    let sides = walk.neighbours();
    // the sides of the prism are the six facets along the third axis
    let are_sides = sides.iter().all(|side| side.second == 3);

    let tripod = [[1.0, 0.0, 1.0], [0.0, 1.0, 1.0], [-1.0, -1.0, 1.0]];
    let normal = |facet: &FacetName| {
        let [a, b] = [facet.first, facet.second].map(|index| Vector::exactly(tripod[index]));
        let cross = a.cross(&b);
        if facet.normal.sign() < 0 { cross.to(&Vector::at([0; 3])) } else { cross }
    };
    let upward = |facet: &FacetName| normal(facet).dot(&Vector::at([0, 0, 1])) > dashu_ratio::RBig::ZERO;
    let Ok(mut walk) = HullWalk::new(&tripod) else {
        return Verdict::Inconclusive("there is no walk on a tripod".to_owned());
    };
    let start = [NormalSense::Along, NormalSense::Against].map(|sense| FacetName::new(0, 1, sense));
    let Some(upper) = start.into_iter().find(upward) else {
        return Verdict::Inconclusive("the tripod has no upper facet".to_owned());
    };
    if walk.place_at(upper).is_err() {
        return Verdict::Inconclusive("the walk does not find the upper facet".to_owned());
    }
    let wrapped = walk.neighbours().iter().filter(|facet| !upward(facet)).count();
    if sides.len() == 4 || !are_sides || wrapped == 0 {
        return Verdict::Holds("the counterexamples are none".to_owned());
    }
    Verdict::Refuted(format!(
        "the top of a hexagonal prism has {} neighbours; of the four of an upper facet of three generators {wrapped} \
         belong to the lower hull, past the last vertices of their dual lines",
        sides.len()
    ))
}
