//! Section 6, first paragraph.

use zonotope::motion::Motion;
use zonotope::motion::continuous::first_contact;
use zonotope::zonotope::Zonotope;

use crate::claim::{Check, CheckContext, Claim, ClaimKind, Place, Tried, Verdict};
use crate::definitions::ratio::{fraction, integer};
use crate::definitions::space::{Body, Vector};

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "collisions-between-steps",
    place: Place { section: "6", label: "first paragraph" },
    kind: ClaimKind::Statement,
    statement: "Tests at each time step alone may miss a collision, if P and Q overlap and stop overlapping within a \
        single step, and may be unnecessary when they are far away",
    code: &["zonotope::motion::continuous"],
    check: Check::Run(check),
    tried: Tried::Witness,
    ..Claim::LISTED
};

/// A cube that passes through another one within a step, and one that passes far away.
fn check(_: &CheckContext) -> Verdict {
    match encounters() {
        Err(reason) => Verdict::Inconclusive(reason),
        Ok(["contact", "separate"]) => Verdict::Holds(
            "a cube of side 2 that moves by 20 through another one is apart from it at both ends of the step, overlaps \
             in the middle, and the first contact is found between; one that passes 50 beside it is proved to be apart \
             during the whole step without a test at any time"
                .to_owned(),
        ),
        Ok(found) => Verdict::Refuted(format!("the two motions are found to be {found:?}")),
    }
}

/// Whether two cubes whose centres are so far apart overlap or touch, by the difference body.
fn meet(apart: Vector) -> bool {
    let difference =
        Body { center: apart, generators: Body::about_origin(&[[2, 0, 0], [0, 2, 0], [0, 0, 2]]).generators };
    difference.holds(&Vector::at([0; 3]))
}

fn encounters() -> Result<[&'static str; 2], String> {
    let place = |share: &dashu_ratio::RBig| Vector::at([-10, 0, 0]).plus(share, &Vector::at([20, 0, 0]));
    if meet(place(&integer(0))) || meet(place(&integer(1))) || !meet(place(&fraction(1, 2))) {
        return Err("the cubes are not apart at the ends and together in the middle".to_owned());
    }
    let axes = vec![[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    let cube = |center| Zonotope::new(center, axes.clone()).map_err(|error| error.to_string());
    let moving = Motion::translation([20.0, 0.0, 0.0]).map_err(|error| error.to_string())?;
    let rest = cube([0.0; 3])?;
    let found = |start: [f64; 3]| {
        let body = cube(start)?;
        Ok::<_, String>(first_contact([&rest, &body], [&Motion::rest(), &moving]).name())
    };
    Ok([found([-10.0, 0.0, 0.0])?, found([-10.0, 50.0, 0.0])?])
}
