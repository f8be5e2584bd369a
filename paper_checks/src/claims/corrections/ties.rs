//! Vertices that share an x, and vertical lines.

use crate::claim::{Check, CheckContext, Claim, ClaimKind, Correction, Place, Tried, Verdict};
use crate::definitions::plane::{arrangement_vertices, bisectors};
use crate::definitions::ratio::integer;
use crate::instances::polygons::polygon;

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "ties-of-candidates",
    place: Place { section: "4.1", label: "before Theorem 4.5" },
    kind: ClaimKind::Correction(Correction::MissingCondition),
    statement: "The slope selection algorithm gives a vertical line that separates the candidate vertices into two \
        subsets of equal size",
    remedy: Some(
        "true when the candidate vertices have different x and no line l_t is vertical; else many vertices can share \
            an x, and l_t can be vertical: put the line through the median vertex and discard the vertices on it as \
            well",
    ),
    code: &["zonotope::lad::of_lines::by_slope_selection", "zonotope::arrangement::slope_selection"],
    figures: &["search-of-theorem-4-5"],
    check: Check::Run(check),
    tried: Tried::Witness,
};

/// Shows a symmetric hexagon whose lines all meet in one point, and a polygon with a vertical line l_t.
fn check(_context: &CheckContext) -> Verdict {
    let hexagon = polygon(&[(3, 0), (1, 2), (-2, 3), (-3, 0), (-1, -2), (2, -3)]);
    let lines = bisectors(&hexagon);
    let vertices = arrangement_vertices(&lines);
    let pairs = (0..lines.len())
        .flat_map(|one| (0..one).map(move |other| (one, other)))
        .filter(|&(one, other)| lines[one].intersection(&lines[other]).is_some())
        .count();
    let triangle = polygon(&[(0, -2), (0, 2), (5, 0)]);
    let vertical = bisectors(&triangle).iter().filter(|line| line.edge.x == integer(0)).count();
    if vertices.len() != 1 || vertical == 0 {
        return Verdict::Holds(format!(
            "the hexagon has {} vertices, the triangle {vertical} vertical lines",
            vertices.len()
        ));
    }
    Verdict::Refuted(format!(
        "hexagon ±(3,0), ±(1,2), ±(-2,3): all {pairs} crossings of its 6 lines are the one point {}, so every vertical \
         line leaves all of them on one side; triangle (0,-2), (0,2), (5,0): {vertical} line l_t is vertical and has \
         no slope",
        vertices[0]
    ))
}
