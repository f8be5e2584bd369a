//! When an edge of H is an edge of Z(O).

use crate::claim::{Check, CheckContext, Claim, ClaimKind, Place, Tried, Verdict};

use std::cmp::Ordering;

use crate::definitions::plane::{Point, bisector, farthest_vertices, turn, zonogon_about};
use crate::definitions::ratio::integer;
use crate::instances::polygons::{generator, polygons, random_center};

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "edge-criterion",
    place: Place { section: "4.1", label: "before Lemma 4.1" },
    kind: ClaimKind::Statement,
    statement: "The edge P_t P_{t+1} of H is an edge of Z(O) iff O is to the left of the line l_t through the \
        midpoints of P_s P_t and P_s P_{t+1}, P_s the vertex farthest from the edge",
    code: &["zonotope::enclosing::bisectors"],
    figures: &["arrangement-and-level-sets"],
    check: Check::Run(check),
    tried: Tried::On(&["random polygons", "degenerate polygons"]),
    ..Claim::LISTED
};

/// Compares the side of l_t with the hull itself; with two farthest vertices, both must give the same line.
fn check(context: &CheckContext) -> Verdict {
    let mut random = generator(context.seed, 8);
    let (mut tried, mut ties, mut on_line) = (0, 0, 0);
    for instance in polygons(&mut random, 60) {
        let polygon = &instance.polygon;
        for t in 0..polygon.len() {
            let lines: Vec<_> = farthest_vertices(polygon, t).into_iter().map(|s| bisector(polygon, t, s)).collect();
            ties += lines.len() - 1;
            let mut centers: Vec<Point> = (0..3).map(|_| random_center(&mut random, polygon)).collect();
            centers.push(lines[0].start.clone());
            centers.push(lines[0].start.plus(&integer(1), &lines[0].edge));
            for center in &centers {
                let sides: Vec<Ordering> = lines.iter().map(|line| line.height(center).cmp(&integer(0))).collect();
                let truth = side_by_hull(polygon, t, center);
                if sides.iter().any(|side| *side != truth) {
                    return Verdict::Refuted(format!("edge {t} of {} about {center}", instance.name));
                }
                tried += 1;
                on_line += usize::from(truth == Ordering::Equal);
            }
        }
    }
    Verdict::Holds(format!(
        "the side of l_t told {tried} times whether the edge is on Z(O), {on_line} of them from the line itself, where \
         the edge is part of a longer or a shared one; {ties} parallel edges gave the same line from either farthest \
         vertex"
    ))
}

/// Greater: the edge is on Z(O) and nothing of the other side's edge touches its line. Equal: both do. Less: it is not.
fn side_by_hull(polygon: &[Point], t: usize, center: &Point) -> Ordering {
    let (from, to) = (&polygon[t], &polygon[(t + 1) % polygon.len()]);
    let zonogon = zonogon_about(polygon, center);
    if zonogon.iter().any(|vertex| turn(from, to, vertex) < integer(0)) {
        return Ordering::Less;
    }
    let touched = polygon.iter().any(|point| turn(from, to, &point.reflected_through(center)) == integer(0));
    if touched { Ordering::Equal } else { Ordering::Greater }
}
