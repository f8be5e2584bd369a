//! The definition: a centre and generators.

use crate::claim::{Check, CheckContext, Claim, ClaimKind, Place, Tried, Verdict};
use crate::definitions::ratio::{fraction, integer};
use crate::definitions::space::{Body, Vector};
use crate::instances::bodies::random_vector;
use crate::instances::polygons::generator;

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "center-and-generators",
    place: Place { section: "3", label: "definition" },
    kind: ClaimKind::Statement,
    statement: "A Minkowski sum of finitely many segments is { p + sum of δ_i v_i : |δ_i| <= 1 } for a centre \
        p and generators v_i, and conversely",
    code: &["zonotope::zonotope"],
    check: Check::Run(check),
    tried: Tried::On(&["segments of R^3"]),
    ..Claim::LISTED
};

/// Sums segments given by their ends, in any order, and compares with the body of the midpoints' sum and the
/// half-differences.
fn check(context: &CheckContext) -> Verdict {
    let mut random = generator(context.seed, 37);
    let (mut directions, mut sums) = (0, 0);
    for index in 0..60 {
        let segments: Vec<[Vector; 2]> =
            (0..index % 8).map(|_| [(); 2].map(|()| Vector::at(random_vector(&mut random, 6)))).collect();
        let half = fraction(1, 2);
        let mut body = Body { center: Vector::at([0; 3]), generators: Vec::new() };
        for [a, b] in &segments {
            body.center = body.center.plus(&half, a).plus(&half, b);
            body.generators.push(Vector::at([0; 3]).plus(&half, &a.to(b)));
        }
        for _ in 0..20 {
            let direction = Vector::at(random_vector(&mut random, 9));
            let farthest = segments.iter().fold(integer(0), |sum, [a, b]| sum + direction.dot(a).max(direction.dot(b)));
            if farthest != body.support(&direction) {
                return Verdict::Refuted(format!("{} segments, direction {direction}", segments.len()));
            }
            directions += 1;
        }
        sums += 1;
    }
    Verdict::Holds(format!(
        "{sums} sums of up to 7 segments, points among them: support functions equal those of the centre and the \
         generators in {directions} directions, so the convex sets are equal; each generator is half a segment, which \
         is the converse"
    ))
}
