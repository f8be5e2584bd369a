//! Section 5.2, the pseudo lines of the proof of Lemma 5.3.

use crate::claim::{Check, CheckContext, Claim, ClaimKind, Place, Tried, Verdict};
use crate::definitions::plane::Point;
use crate::definitions::upper_hull::UpperFacet;
use crate::instances::bodies::tilings;
use crate::instances::polygons::generator;

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "pseudo-lines",
    place: Place { section: "5.2", label: "proof of Lemma 5.3" },
    kind: ClaimKind::Statement,
    statement: "The bisector of the strip of a generator has complexity O(n), so r of them have an arrangement of \
        complexity O(nr)",
    code: &["zonotope::arrangement"],
    check: Check::Run(check),
    tried: Tried::Scope("bodies in general position"),
    ..Claim::LISTED
};

/// The strip of a generator is a path of tiles, one for each other generator; two strips share one tile.
fn check(context: &CheckContext) -> Verdict {
    let mut random = generator(context.seed, 109);
    let instances = tilings(&mut random, 35);
    let mut strips = 0;
    for (instance, body, facets) in &instances {
        for index in 0..body.generators.len() {
            let strip: Vec<&UpperFacet> = facets.iter().filter(|facet| facet.pair.contains(&index)).collect();
            let neighbours = |tile: &UpperFacet| {
                strip.iter().filter(|other| other.pair != tile.pair && share_an_edge(&tile.tile, &other.tile)).count()
            };
            let ends = strip.iter().filter(|tile| neighbours(tile) < 2).count();
            let is_path = ends == 2.min(strip.len()) && strip.iter().all(|tile| neighbours(tile) <= 2);
            if strip.len() + 1 != body.generators.len() || !is_path {
                return Verdict::Refuted(format!("{}: the strip of generator {index}", instance.name));
            }
            strips += 1;
        }
    }
    Verdict::Holds(format!(
        "{strips} strips of {} tilings are paths of n-1 tiles; two of them have the tile of their pair in common, so r \
         bisectors have at most r(n-1) segments and r(r-1)/2 crossings",
        instances.len()
    ))
}

fn share_an_edge(one: &[Point], other: &[Point]) -> bool {
    one.iter().filter(|corner| other.contains(corner)).count() >= 2
}
