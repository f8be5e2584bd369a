//! Membership by the upper and the lower hull.

use dashu_ratio::RBig;

use crate::claim::{Check, CheckContext, Claim, ClaimKind, Place, Tried, Verdict};
use crate::definitions::ratio::{fraction, integer};
use crate::definitions::space::{Facet, Vector};
use crate::instances::bodies::{bodies, random_member, random_vector};
use crate::instances::polygons::generator;

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "between-the-hulls",
    place: Place { section: "5.1", label: "after Lemma 5.1" },
    kind: ClaimKind::Statement,
    statement: "A point lies in Z iff it is directly below the upper hull and directly above the lower hull; if its \
        projection is outside Q it is not",
    code: &["zonotope::collision::by_slope_selection"],
    check: Check::Run(check),
    tried: Tried::On(&["random bodies", "degenerate bodies"]),
    ..Claim::LISTED
};

/// Compares membership by all normals with the heights at which the vertical through the point meets the facets that
/// look up and down.
fn check(context: &CheckContext) -> Verdict {
    let mut random = generator(context.seed, 40);
    let (mut inside, mut outside, mut beside) = (0, 0, 0);
    for instance in bodies(&mut random, 80) {
        let body = instance.body();
        if !body.holds_inside(&body.center) {
            continue;
        }
        let facets = body.facets();
        for trial in 0..12 {
            let point = match trial % 3 {
                0 => random_member(&mut random, &body),
                1 => random_member(&mut random, &body)
                    .plus(&fraction(1, 100), &Vector::at(random_vector(&mut random, 3))),
                _ => body.center.plus(&integer(1), &Vector::at(random_vector(&mut random, 30))),
            };
            let between = match heights(&facets, &point) {
                Some([low, high]) => low <= point.0[2] && point.0[2] <= high,
                None => {
                    beside += 1;
                    false
                }
            };
            if between != body.holds(&point) {
                return Verdict::Refuted(format!("{}: {point}", instance.name));
            }
            if between { inside += 1 } else { outside += 1 }
        }
    }
    Verdict::Holds(format!(
        "{} points about bodies of full dimension: {inside} lie between the two hulls and in the body, {outside} \
         neither, {beside} of them with projections outside Q",
        inside + outside
    ))
}

/// The heights of the lower and of the upper hull over a point; `None` where its vertical misses the body.
fn heights(facets: &[Facet], point: &Vector) -> Option<[RBig; 2]> {
    let height = |upwards: bool| {
        facets.iter().find_map(|facet| {
            let looks_there = if upwards { facet.normal.0[2] > RBig::ZERO } else { facet.normal.0[2] < RBig::ZERO };
            let below = |from: &Vector, to: &Vector| {
                let (edge, offset) = (from.to(to), from.to(point));
                let turn = &edge.0[0] * &offset.0[1] - &edge.0[1] * &offset.0[0];
                if upwards { turn >= RBig::ZERO } else { turn <= RBig::ZERO }
            };
            let count = facet.corners.len();
            let over = looks_there && (0..count).all(|k| below(&facet.corners[k], &facet.corners[(k + 1) % count]));
            over.then(|| {
                let offset = point.to(&facet.corners[0]);
                &point.0[2] + facet.normal.dot(&offset) / &facet.normal.0[2]
            })
        })
    };
    Some([height(false)?, height(true)?])
}
