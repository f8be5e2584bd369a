//! Section 5.2, local walking method: small motions.

use rand::RngExt;
use zonotope::arrangement::facet_walk::{FacetWalk, HullWalk};

use crate::claim::{Check, CheckContext, Claim, ClaimKind, Place, Tried, Verdict};
use crate::instances::polygons::generator;

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "small-motions",
    place: Place { section: "5.2", label: "local walking method" },
    kind: ClaimKind::Statement,
    statement: "If the motion is small, the closest pair of features is not far from that of the previous step, and \
        the walk terminates in a small number of steps",
    code: &["zonotope::arrangement::facet_walk"],
    check: Check::Run(check),
    tried: Tried::On(&["random bodies"]),
    ..Claim::LISTED
};

/// Generators of each body.
const GENERATORS: usize = 60;
/// Walks for each size of motion.
const WALKS: usize = 200;
/// The sizes of a motion of the ray, in terms of its length.
const MOTIONS: [f64; 5] = [1.0, 0.25, 0.0625, 0.015625, 0.00390625];

/// The mean number of steps from the facet of a ray to that of a ray nearby.
fn check(context: &CheckContext) -> Verdict {
    let mut random = generator(context.seed, 111);
    let mut vector = || -> [f64; 3] { std::array::from_fn(|_| random.random_range(-1.0..=1.0)) };
    let rows: Vec<[f64; 3]> = (0..GENERATORS).map(|_| vector()).collect();
    let Ok(mut walk) = HullWalk::new(&rows) else {
        return Verdict::Inconclusive("there is no walk on a random body".to_owned());
    };
    let mut means: Vec<f64> = Vec::new();
    for motion in MOTIONS {
        let mut steps = 0;
        for _ in 0..WALKS {
            let (ray, shift) = (vector(), vector());
            let moved = [0, 1, 2].map(|k| ray[k] + motion * shift[k]);
            let counted = walk.walk_to(ray).and_then(|_| walk.walk_to(moved));
            let Ok(count) = counted else {
                return Verdict::Inconclusive(format!("no walk from {ray:?} to {moved:?}"));
            };
            steps += count;
        }
        means.push(steps as f64 / WALKS as f64);
    }
    let shown: Vec<String> =
        MOTIONS.iter().zip(&means).map(|(motion, mean)| format!("{mean:.2} for a motion of {motion}")).collect();
    let sentence = format!("steps of a walk over a body of {GENERATORS} generators: {}", shown.join(", "));
    if means.windows(2).all(|pair| pair[1] < pair[0]) { Verdict::Holds(sentence) } else { Verdict::Refuted(sentence) }
}
