//! The third displayed line of the area formula.

use dashu_ratio::RBig;

use crate::claim::{Check, CheckContext, Claim, ClaimKind, Correction, Place, Tried, Verdict};
use crate::definitions::plane::{Point, zonogon_area};
use crate::definitions::runs::{displayed_lines, first_points_area, runs};
use crate::instances::polygons::{generator, polygon, polygons, random_center};

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "area-formula-third-line",
    place: Place { section: "4.1", label: "displayed formula, third line" },
    kind: ClaimKind::Correction(Correction::Erratum),
    statement: "f(O) equals the third displayed line of the area formula",
    remedy: Some(
        "drop the O from its first bracket; or use f(O) = C + 2 sum over t of max(0, e_t x (O - m_t)), m_t a point of \
            l_t",
    ),
    code: &["zonotope::enclosing::min_area_zonogon"],
    check: Check::Run(check),
    tried: Tried::Witness,
    ..Claim::LISTED
};

/// Shows one polygon where the line fails, and that everywhere it is off by the area of P_{a_1} ... P_{a_k}.
fn check(context: &CheckContext) -> Verdict {
    let mut random = generator(context.seed, 15);
    let (mut tried, mut wrong) = (0, 0);
    for instance in polygons(&mut random, 60) {
        let center = random_center(&mut random, &instance.polygon);
        let Some(runs) = runs(&instance.polygon, &center) else {
            continue;
        };
        let [_, _, third, _] = displayed_lines(&runs, &center);
        let gap: RBig = zonogon_area(&instance.polygon, &center) - third;
        if gap != first_points_area(&runs) {
            return Verdict::Inconclusive(format!("{}: the gap at {center} is another, {gap}", instance.name));
        }
        tried += 1;
        wrong += usize::from(gap != RBig::ZERO);
    }
    let triangle = polygon(&[(0, 0), (6, 0), (0, 6)]);
    let center = Point::at(2, 2);
    let Some(runs) = runs(&triangle, &center) else {
        return Verdict::Inconclusive("the witness has coinciding vertices".to_owned());
    };
    let [_, _, third, last] = displayed_lines(&runs, &center);
    let area = zonogon_area(&triangle, &center);
    if third == area || last != area {
        return Verdict::Holds("the triangle (0,0), (6,0), (0,6) about (2,2) is no counterexample".to_owned());
    }
    Verdict::Refuted(format!(
        "triangle (0,0), (6,0), (0,6) about (2,2): Z(O) has area {area}, the last line gives {last}, the third \
         {third}; in {wrong} of {tried} cases the third line is wrong, always by the area of P_{{a_1}} ... P_{{a_k}}"
    ))
}
