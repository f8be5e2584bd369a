//! Section 6, third paragraph.

use zonotope::motion::space_time::{Method, Sweep};

use crate::claim::{Check, CheckContext, Claim, ClaimKind, Place, Tried, Verdict};
use crate::definitions::ratio::{fraction, integer};
use crate::definitions::space::{Body, Vector};
use crate::instances::bodies::{bodies, doubles, random_vector};
use crate::instances::polygons::generator;
use crate::instances::sweeps::{exact_body, sign_points};

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "pure-translation",
    place: Place { section: "6", label: "third paragraph" },
    kind: ClaimKind::Statement,
    statement: "A translating zonotope sweeps exactly a zonotope of one generator more, which is along the translation",
    remedy: Some("the added generator is half the translation where generators are half-lengths: see the erratum"),
    code: &["zonotope::motion::space_time::by_farthest_vertex"],
    check: Check::Run(check),
    tried: Tried::On(&["random bodies", "degenerate bodies"]),
    ..Claim::LISTED
};

/// The library adds v/2 exactly; each corner of the volume is a point of the first or the last placement, and every
/// placement lies in the volume.
fn check(context: &CheckContext) -> Verdict {
    let mut random = generator(context.seed, 166);
    let (mut volumes, mut corners) = (0, 0);
    for instance in bodies(&mut random, 20).into_iter().filter(|instance| instance.generators.len() <= 6) {
        let step = random_vector(&mut random, 7).map(|c| 2 * c);
        let Ok(sweep) = Sweep::new([0.0; 3], [0.0, 0.0, 1.0], 0.0, doubles(step)) else {
            return Verdict::Inconclusive("an angle of zero is refused".to_owned());
        };
        let volume = match instance.in_doubles().swept_by(&sweep, Method::ByFarthestVertex) {
            Ok(volume) => exact_body(&volume),
            Err(error) => return Verdict::Inconclusive(format!("{}: {error}", instance.name)),
        };
        let (body, v) = (instance.body(), Vector::at(step));
        let moved = |share: &dashu_ratio::RBig| Body {
            center: body.center.plus(share, &v),
            generators: body.generators.clone(),
        };
        let half = fraction(1, 2);
        let by_definition = Body {
            center: body.center.plus(&half, &v),
            generators: [body.generators.clone(), vec![v.plus(&-&half, &v)]].concat(),
        };
        let is_same = volume.center == by_definition.center
            && sign_points(&volume).into_iter().collect::<std::collections::BTreeSet<_>>()
                == sign_points(&by_definition).into_iter().collect();
        let placements: Vec<Body> = (0..=4).map(|quarters| moved(&fraction(quarters, 4))).collect();
        if !is_same || by_definition.first_outside(&placements).is_some() {
            return Verdict::Refuted(format!("{} moved by {v}", instance.name));
        }
        // a corner of the sum is a corner of the body at one of the two ends
        let [first, last] = [0, 1].map(|end| sign_points(&moved(&integer(end))));
        let ends: std::collections::BTreeSet<&Vector> = first.iter().chain(&last).collect();
        let points = sign_points(&by_definition);
        if points.iter().any(|point| !ends.contains(point)) {
            return Verdict::Refuted(format!("{} moved by {v}: a corner is in neither end", instance.name));
        }
        volumes += 1;
        corners += points.len();
    }
    Verdict::Holds(format!(
        "for {volumes} bodies the library's volume is the body with v/2 added and the centre moved by v/2; its \
         {corners} points center ± g_1 ± … are those of the first and the last placement, and the placements between \
         lie in it"
    ))
}
