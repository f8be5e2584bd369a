//! Section 6, after Theorem 6.1.

use rand::RngExt;
use zonotope::motion::space_time::Method;

use crate::claim::{Check, CheckContext, Claim, ClaimKind, Place, Tried, Verdict};
use crate::definitions::ratio::fraction;
use crate::definitions::space::Body;
use crate::instances::polygons::generator;
use crate::instances::sweeps::{exact_body, sweeps};

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "any-schedule",
    place: Place { section: "6", label: "after Theorem 6.1" },
    kind: ClaimKind::Statement,
    statement: "The bound holds whatever the velocity and the angular acceleration during the motion: only the set of \
        positions matters",
    code: &["zonotope::motion::space_time"],
    check: Check::Run(check),
    tried: Tried::On(&["random bodies", "degenerate bodies"]),
    ..Claim::LISTED
};

/// Parts of the angle and of the translation drawn independently of each other, backwards and forwards.
fn check(context: &CheckContext) -> Verdict {
    let mut random = generator(context.seed, 162);
    let (mut volumes, mut placements) = (0, 0);
    for moving in sweeps(&mut random, 8) {
        let own = moving.instance.body();
        let schedule: Vec<Body> = (0..8)
            .map(|_| {
                let [part, moved] = [0, 1].map(|_| fraction(random.random_range(0..=16), 16));
                moving.turning.placed(&part, &moved, &own)
            })
            .collect();
        for method in Method::ALL {
            let name = || format!("{}, {}", moving.instance.name, method.title());
            let volume = match moving.instance.in_doubles().swept_by(&moving.sweep, method) {
                Ok(volume) => exact_body(&volume),
                Err(error) => return Verdict::Inconclusive(format!("{}: {error}", name())),
            };
            if volume.generators.len() > 12 {
                continue;
            }
            if let Some(outside) = volume.first_outside(&schedule) {
                return Verdict::Refuted(format!("{}: the placement about {} sticks out", name(), outside.center));
            }
            volumes += 1;
            placements += schedule.len();
        }
    }
    Verdict::Holds(format!(
        "{placements} placements, each by parts of the angle and of the translation that are drawn independently of \
         each other, lie in their {volumes} volumes, Theorem 6.1's and five others'"
    ))
}
