//! Boxes are zonotopes of three orthogonal generators.

use crate::claim::{Check, CheckContext, Claim, ClaimKind, Place, Tried, Verdict};
use crate::definitions::ratio::integer;
use crate::definitions::space::{Body, Vector};
use crate::instances::bodies::random_vector;
use crate::instances::polygons::generator;

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "boxes-are-zonotopes",
    place: Place { section: "1", label: "fifth paragraph" },
    kind: ClaimKind::Statement,
    statement: "Axis-aligned and oriented bounding boxes are special zonotopes",
    code: &["zonotope::zonotope"],
    check: Check::Run(check),
    tried: Tried::On(&["boxes along the axes", "turned boxes"]),
    ..Claim::LISTED
};

/// Compares the box { x : |u_i · (x − c)| <= w_i |u_i|² } of orthogonal u_i with the zonotope of the generators w_i
/// u_i, point by point.
fn check(context: &CheckContext) -> Verdict {
    let mut random = generator(context.seed, 31);
    let (mut boxes, mut points, mut inside) = (0, 0, 0);
    for index in 0..60 {
        let axes = match index % 2 {
            0 => [[1, 0, 0], [0, 1, 0], [0, 0, 1]].map(Vector::at),
            _ => orthogonal_frame(random_vector(&mut random, 5)),
        };
        if axes.iter().any(Vector::is_zero) {
            continue;
        }
        boxes += 1;
        let halves = random_vector(&mut random, 4).map(|half| integer(half.abs()));
        let generators = axes.iter().zip(&halves).map(|(axis, half)| Vector::at([0; 3]).plus(half, axis)).collect();
        let body = Body { center: Vector::at(random_vector(&mut random, 9)), generators };
        for _ in 0..30 {
            let point = Vector::at(random_vector(&mut random, 12));
            let offset = body.center.to(&point);
            let in_box = axes.iter().zip(&halves).all(|(axis, half)| {
                let along = axis.dot(&offset);
                let reach = half * axis.dot(axis);
                -&reach <= along && along <= reach
            });
            if in_box != body.holds(&point) {
                return Verdict::Refuted(format!("the box about {} and the point {point}", body.center));
            }
            points += 1;
            inside += usize::from(in_box);
        }
    }
    Verdict::Holds(format!(
        "{boxes} axis-aligned and oriented boxes, flat ones among them: {points} points lie in the box just when they \
         lie in the zonotope of its three half-edges ({inside} of them do)"
    ))
}

/// Three orthogonal vectors, the first of them given; zero vectors when it is vertical or zero.
fn orthogonal_frame(first: [i64; 3]) -> [Vector; 3] {
    let first = Vector::at(first);
    let second = first.cross(&Vector::at([0, 0, 1]));
    let third = first.cross(&second);
    [first, second, third]
}
