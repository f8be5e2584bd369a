//! A list of generators stands for the polytope.

use zonotope::zonotope::combinatorics;

use crate::claim::{Check, CheckContext, Claim, ClaimKind, Place, Tried, Verdict};
use crate::instances::bodies::bodies_in_general_position;
use crate::instances::polygons::generator;

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "implicit-representation",
    place: Place { section: "1", label: "second bullet" },
    kind: ClaimKind::Statement,
    statement: "n generators represent a body of up to order n^2 faces in R^3, and sums and differences are \
        concatenations of generator lists",
    code: &["zonotope::zonotope"],
    check: Check::Run(check),
    tried: Tried::On(&["bodies in general position"]),
    ..Claim::LISTED
};

/// Joins the lists of pairs of bodies: sum and difference have the lists of both, and as many facets as there are
/// pairs, twice.
fn check(context: &CheckContext) -> Verdict {
    let mut random = generator(context.seed, 50);
    let instances = bodies_in_general_position(&mut random, 28);
    let (mut pairs, mut facets, mut numbers) = (0, 0, 0);
    for pair in instances.chunks_exact(2) {
        let [a, b] = [&pair[0], &pair[1]].map(|instance| instance.in_doubles());
        for joined in [a.minkowski_sum(&b), a.minkowski_sum_with_reflection(&b)] {
            let Ok(joined) = joined else {
                return Verdict::Inconclusive(format!("{} and {}: the centre overflows", pair[0].name, pair[1].name));
            };
            let lists: Vec<[f64; 3]> = [a.generators(), b.generators()].concat();
            let same_up_to_sign = lists.len() == joined.generators().len()
                && lists.iter().zip(joined.generators()).all(|(v, w)| v == w || v.map(|c| -c) == *w);
            let counts = combinatorics(&joined);
            let n = lists.len() as u64;
            if !same_up_to_sign || counts.facets > n * (n - 1) {
                return Verdict::Refuted(format!("{} and {}", pair[0].name, pair[1].name));
            }
            pairs += 1;
            facets += counts.facets;
            numbers += 3 * (n + 1);
        }
    }
    Verdict::Holds(format!(
        "{pairs} sums A + B and differences A + (-B): the list of generators is that of A followed by that of B, and \
         {numbers} numbers in all stand for {facets} facets, at most n(n-1) a body"
    ))
}
