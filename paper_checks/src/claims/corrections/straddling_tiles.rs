//! Section 5.2, proof of Lemma 5.3.

use std::num::NonZeroU32;

use dashu_ratio::RBig;
use zonotope::arrangement::cutting::by_hierarchy::cutting;
use zonotope::arrangement::{DualArrangement, LineIndex};

use crate::claim::{Check, CheckContext, Claim, ClaimKind, Correction, Place, Tried, Verdict};
use crate::definitions::ratio::fraction;
use crate::definitions::space::{Body, Vector};
use crate::instances::bodies::{doubles, generators_in_general_position};
use crate::instances::polygons::generator;

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "tiles-of-cutting-lines",
    place: Place { section: "5.2", label: "proof of Lemma 5.3" },
    kind: ClaimKind::Correction(Correction::Erratum),
    statement: "The line-trapezoid incidence relationship in the cutting is preserved by its map to the tiling, so \
        the lines that cross a trapezoid tell the tile of a point in its cell",
    remedy: Some(
        "a tile of a sampled line can straddle cells: keep the boundary lines of a trapezoid among its crossing \
            lines; or decide of every query whether its optimum is on a cut, and answer it there",
    ),
    code: &["zonotope::arrangement::cutting", "zonotope::collision::prepared::by_cutting"],
    figures: &["cutting-and-image"],
    check: Check::Run(check),
    tried: Tried::Witness,
};

/// Looks for a trapezoid along a line ℓ_i, and a vertex of ℓ_i with a line that crosses the trapezoid: the half of the
/// tile (i, j) beyond the bisector of its strip is in the cell, and the facet of its points needs v_i.
fn check(context: &CheckContext) -> Verdict {
    let mut random = generator(context.seed, 91);
    let rows = generators_in_general_position(&mut random, 8, 20);
    let upward: Vec<[i64; 3]> = rows.into_iter().filter(|v| v[2] != 0 && v[1] != 0).collect();
    let in_doubles: Vec<[f64; 3]> = upward.iter().copied().map(doubles).collect();
    let Ok(dual) = DualArrangement::new(&in_doubles) else {
        return Verdict::Inconclusive("the generators have no dual lines".to_owned());
    };
    let lines = dual.lines();
    let cut = cutting(lines, NonZeroU32::new(2).expect("two is not zero"), context.seed, &mut ());
    let all: Vec<LineIndex> = (0..upward.len() as u32).map(LineIndex).collect();
    for &first in &all {
        for &second in &all {
            let vertex = lines.exact_line(first).meet(&lines.exact_line(second));
            let Some(found) = cut.locate_homogeneous(vertex) else { continue };
            let crossing = cut.crossing_lines(found);
            let bottom = cut.trapezoids()[found.0 as usize].bottom;
            if bottom != Some(first) || first == second || !crossing.contains(&second) || crossing.contains(&first) {
                continue;
            }
            let body = Body::about_origin(&upward);
            let [i, j] = [first, second].map(|line| line.0 as usize);
            let Some(point) = point_of_facet(&body, [i, j]) else { continue };
            if body.holds(&point) && !body.holds_inside(&point) {
                let [v, w] = [upward[i], upward[j]];
                return Verdict::Refuted(format!(
                    "generators {upward:?}, r = 2: a trapezoid lies on the line of {v:?}, which does not cross it, and \
                     the line of {w:?} crosses both; so half of their tile is in its cell, with the point {point} of \
                     the boundary, whose coefficient of {v:?} is 1/2"
                ));
            }
        }
    }
    Verdict::Holds("no tile of a boundary line was found in a cell".to_owned())
}

/// The point of an upper facet with the coefficient 1/2 of its first generator, turned up, and 0 of its second.
fn point_of_facet(body: &Body, [i, j]: [usize; 2]) -> Option<Vector> {
    let up = Vector::at([0, 0, 1]);
    let facet = body.facets().into_iter().find(|facet| {
        let along = |index: usize| facet.normal.dot(&body.generators[index]) == RBig::ZERO;
        along(i) && along(j) && facet.normal.dot(&up) > RBig::ZERO
    })?;
    let others = body.generators.iter().enumerate().filter(|(index, _)| ![i, j].contains(index));
    let middle = others.fold(Vector::at([0; 3]), |sum, (_, generator)| {
        let sign = if facet.normal.dot(generator) < RBig::ZERO { -1 } else { 1 };
        sum.plus(&fraction(sign, 1), generator)
    });
    let half = if body.generators[i].dot(&up) < RBig::ZERO { -1 } else { 1 };
    Some(middle.plus(&fraction(half, 2), &body.generators[i]))
}
