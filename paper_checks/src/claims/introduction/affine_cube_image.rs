//! The two definitions: a sum of segments, and an affine image of a cube.

use std::collections::BTreeSet;

use crate::claim::{Check, CheckContext, Claim, ClaimKind, Place, Tried, Verdict};
use crate::definitions::ratio::integer;
use crate::definitions::space::{Body, Vector};
use crate::instances::bodies::{bodies, random_vector};
use crate::instances::polygons::generator;

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "affine-image-of-cube",
    place: Place { section: "1", label: "second paragraph" },
    kind: ClaimKind::Statement,
    statement: "The Minkowski sum of n segments is the same set as an affine image of the unit cube of R^n",
    code: &["zonotope::zonotope"],
    check: Check::Run(check),
    tried: Tried::On(&["bodies of R^3"]),
    ..Claim::LISTED
};

/// Both are convex, so equal support functions make them equal: the image's is a maximum over the corners of the cube,
/// the sum's the sum over its segments.
fn check(context: &CheckContext) -> Verdict {
    let mut random = generator(context.seed, 30);
    let mut compared = 0;
    let instances = bodies(&mut random, 60);
    for instance in &instances {
        let body = instance.body();
        let corners = images_of_cube_corners(&body);
        let zonotope = instance.in_doubles();
        for _ in 0..20 {
            let direction = random_vector(&mut random, 9);
            let exact = Vector::at(direction);
            let farthest = corners.iter().map(|corner| exact.dot(corner)).max().expect("a cube has a corner");
            let support = zonotope.support(direction.map(|c| c as f64)).exact_value.to_rational();
            if farthest != body.support(&exact) || support != farthest {
                return Verdict::Refuted(format!("{}: direction {exact}", instance.name));
            }
            compared += 1;
        }
        if !corners.iter().all(|corner| body.holds(corner)) {
            return Verdict::Refuted(format!(
                "{}: the image of a corner of the cube lies outside the sum",
                instance.name
            ));
        }
    }
    Verdict::Holds(format!(
        "{} bodies, flat and empty ones among them: the sum of the segments reaches as far as the images of all 2^n \
         corners of the cube in {compared} directions, and contains all of these images",
        instances.len()
    ))
}

fn images_of_cube_corners(body: &Body) -> BTreeSet<Vector> {
    body.generators.iter().fold(BTreeSet::from([body.center.clone()]), |corners, generator| {
        corners.iter().flat_map(|corner| [-1, 1].map(|sign| corner.plus(&integer(sign), generator))).collect()
    })
}
