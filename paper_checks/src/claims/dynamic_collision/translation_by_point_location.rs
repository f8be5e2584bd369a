//! Section 5.2, Minkowski sum method.

use rand::RngExt;
use zonotope::collision::prepared::DirectionTree;

use crate::claim::{Check, CheckContext, Claim, ClaimKind, Place, Tried, Verdict};
use crate::definitions::space::{Body, Vector};
use crate::instances::bodies::{bodies, bodies_in_general_position, doubles, random_vector};
use crate::instances::polygons::generator;

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "translation-by-point-location",
    place: Place { section: "5.2", label: "Minkowski sum method" },
    kind: ClaimKind::Statement,
    statement: "For bodies that only translate, repeated intersection tests are point locations in one Minkowski sum",
    code: &["zonotope::collision::prepared"],
    check: Check::Run(check),
    tried: Tried::On(&["random bodies", "degenerate bodies", "bodies in general position"]),
    ..Claim::LISTED
};

/// One tree of the Minkowski sum is asked where many translations put a body; the truth is whether a point of one body
/// lies in the other, by the definition.
fn check(context: &CheckContext) -> Verdict {
    let mut random = generator(context.seed, 87);
    let mut instances = bodies(&mut random, 20);
    instances.extend(bodies_in_general_position(&mut random, 7));
    let mut counts = [0; 2];
    for pair in instances.chunks_exact(2) {
        let [fixed, moving] = [pair[0].in_doubles(), pair[1].in_doubles()];
        let Ok(sum) = fixed.minkowski_sum_with_reflection(&moving) else {
            return Verdict::Inconclusive(format!("no sum of {} and {}", pair[0].name, pair[1].name));
        };
        let tree = DirectionTree::new(&sum);
        let truth = Body {
            center: Vector::at([0; 3]),
            generators: pair.iter().flat_map(|instance| instance.body().generators).collect(),
        };
        for _ in 0..20 {
            let reach = [2, 10, 1000][random.random_range(0..3)];
            let translation = random_vector(&mut random, reach);
            let [to, from] = [pair[1].center, pair[0].center];
            let meets = truth.holds(&Vector::at([0, 1, 2].map(|k| to[k] + translation[k] - from[k])));
            if tree.contains(doubles(translation)) != Ok(meets) {
                let [fixed, moving] = [&pair[0].name, &pair[1].name];
                return Verdict::Refuted(format!("{fixed}, and {moving} moved by {translation:?}"));
            }
            counts[usize::from(meets)] += 1;
        }
    }
    let [apart, meeting] = counts;
    Verdict::Holds(format!(
        "{meeting} placements that meet and {apart} that do not, of {} pairs of bodies: located in the Minkowski sum \
         of each pair, which is built once",
        instances.len() / 2
    ))
}
