//! Section 4.2, second paragraph.

use dashu_ratio::RBig;
use zonotope::enclosing::fixed_directions::rational::min_length_in_rationals;
use zonotope::enclosing::fixed_directions::{Enclosure, FixedDirections, min_length_along};

use crate::claim::{Check, CheckContext, Claim, ClaimKind, Correction, Place, Tried, Verdict};
use crate::definitions::enclosing::{Row, dot, doubles, facet_normals, papers_program, rows};
use crate::definitions::ratio::{exactly, fraction, integer};

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "extreme-points-off-the-span",
    place: Place { section: "4.2", label: "second paragraph" },
    kind: ClaimKind::Correction(Correction::MissingCondition),
    statement: "It is clear that only the two extreme points along the normal of each (d-1)-tuple of directions matter",
    remedy: Some(
        "right when the directions span R^d; otherwise work in the span, where points off the affine span make the \
            problem infeasible. Directions e1, e2 of R^3 with the unit square in z = 0: two extreme points give 1/2, \
            the optimum is 1",
    ),
    code: &["zonotope::enclosing::fixed_directions", "zonotope::enclosing::fixed_directions::rational"],
    check: Check::Run(check),
    tried: Tried::Witness,
    ..Claim::LISTED
};

/// Shows the unit square along two axes of space, what the library answers there, and what when a corner is lifted.
fn check(_context: &CheckContext) -> Verdict {
    let square = [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]];
    let axes = [[1, 0, 0], [0, 1, 0]];
    let (points, along) = (rows(&square), rows(&axes));
    let normals = facet_normals(&along, 3);
    // All four points are equally high along e3: any two may be the paper's, the first two among them.
    let heights: Vec<RBig> = normals.iter().flat_map(|u| points.iter().map(|p| dot(u, p))).collect();
    let ties = normals.len() == 1 && heights.iter().all(|height| *height == RBig::ZERO);
    let kept: Vec<Row> = points[..2].to_vec();
    let (few, all) = (papers_program(&kept, &along, 3), papers_program(&points, &along, 3));
    if !ties || few != Some(fraction(1, 2)) || all != Some(integer(1)) {
        return Verdict::Holds(format!("the square has {few:?} from two points and {all:?} from four"));
    }
    let (corners, directions) = (doubles(&square), doubles(&axes));
    let answer = |corners: &[[f64; 3]]| {
        let problem = FixedDirections::new(corners, &directions, &[1.0, 1.0]).map_err(|error| error.to_string())?;
        let truth = min_length_in_rationals(&problem).map(|optimum| optimum.value);
        Ok::<_, String>((min_length_along(&problem, &mut ()).map_err(|error| error.to_string())?, truth))
    };
    let mut lifted = corners.clone();
    lifted[2][2] = f64::from_bits(1);
    let (in_plane, lifted) = match (answer(&corners), answer(&lifted)) {
        (Ok(in_plane), Ok(lifted)) => (in_plane, lifted),
        (Err(error), _) | (_, Err(error)) => return Verdict::Inconclusive(error),
    };
    let right = in_plane.1 == Some(integer(1))
        && in_plane.0.optimal().is_some_and(|zonotope| exactly(zonotope.value) == RBig::ONE);
    let infeasible =
        matches!(&lifted.0, Enclosure::Infeasible(proof) if lifted.1.is_none() && proof.points.contains(&2));
    if !right || !infeasible {
        return Verdict::Inconclusive(format!("the library answers {:?} and {:?}", in_plane.0, lifted.0));
    }
    Verdict::Refuted(format!(
        "directions e1, e2 of R^3, unit square in z = 0: along e3, the only normal, all four corners are extreme; the \
         two (0,0,0) and (1,0,0) give {}, all four give {}. The library works in the plane and finds 1; with one \
         corner lifted by the least double it proves that there is no zonotope",
        fraction(1, 2),
        integer(1)
    ))
}
