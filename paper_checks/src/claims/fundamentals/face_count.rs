//! The number of faces.

use std::collections::BTreeSet;

use zonotope::zonotope::combinatorics;
use zonotope::zonotope::faces::brute_force::faces_by_dimension;

use crate::claim::{Check, CheckContext, Claim, ClaimKind, Place, Tried, Verdict};
use crate::definitions::enclosing::doubles;
use crate::definitions::signs::{Signs, faces};
use crate::instances::bodies::{are_independent, bodies, bodies_in_general_position};
use crate::instances::higher::spanning;
use crate::instances::polygons::generator;

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "face-count",
    place: Place { section: "3", label: "first paragraph" },
    kind: ClaimKind::Statement,
    statement: "In R^d a zonotope with n generators has complexity O(n^(d-1)), and the topology of its boundary is \
        that of an arrangement",
    code: &["zonotope::zonotope::faces"],
    figures: &["scaling-face-counts"],
    check: Check::Run(check),
    tried: Tried::On(&["bodies of R^3", "bodies of R^4", "bodies of R^5"]),
    ..Claim::LISTED
};

/// In space: n(n−1) facets, 2n(n−1) edges and n(n−1) + 2 vertices in general position, never more; Euler's formula
/// always.
fn check(context: &CheckContext) -> Verdict {
    let mut random = generator(context.seed, 38);
    let (mut general, mut others) = (0, 0);
    for instance in bodies_in_general_position(&mut random, 28).into_iter().chain(bodies(&mut random, 60)) {
        let body = instance.body();
        if !body.holds_inside(&body.center) {
            continue;
        }
        let facets = body.facets();
        let edges: usize = facets.iter().map(|facet| facet.corners.len()).sum::<usize>() / 2;
        let vertices = body.vertices().len();
        let n = body.generators.len();
        let most = n * (n - 1);
        let library = combinatorics(&instance.in_doubles());
        if [library.vertices, library.edges, library.facets]
            != [vertices, edges, facets.len()].map(|count| count as u64)
        {
            return Verdict::Inconclusive(format!("{}: the library counts {library:?}", instance.name));
        }
        let independent = are_independent(&instance.generators);
        let counts = format!("{}: {vertices} vertices, {edges} edges, {} facets", instance.name, facets.len());
        if vertices + facets.len() != edges + 2 || facets.len() > most || edges > 2 * most || vertices > most + 2 {
            return Verdict::Refuted(counts);
        }
        if independent && facets.len() != most {
            return Verdict::Refuted(counts);
        }
        if independent { general += 1 } else { others += 1 }
    }
    match [higher::<4>(context.seed, 113), higher::<5>(context.seed, 114)] {
        [Ok(four), Ok(five)] => Verdict::Holds(format!(
            "{general} bodies of R^3 with independent triples have n(n-1) facets, 2n(n-1) edges and n(n-1) + 2 \
             vertices; {others} others have no more, and Euler's formula holds for all; the library counts the same; \
             {four}; {five}"
        )),
        [Err(witness), _] | [_, Err(witness)] => Verdict::Refuted(witness),
    }
}

/// The faces of each dimension beside the number in general position, Euler's relation, and the covectors of the
/// arrangement, which the library composes from the facets.
fn higher<const D: usize>(seed: u64, stream: u64) -> Result<String, String> {
    let instances = spanning::<D>(&mut generator(seed, stream), 24);
    let (mut general, mut all) = (0, 0);
    for instance in &instances {
        let n = instance.generators.len();
        let by_dimension = faces(&instance.rows(), D);
        let counts: Vec<usize> = by_dimension.iter().map(BTreeSet::len).collect();
        let most: Vec<usize> = (0..D).map(|k| in_general_position(n, D, k)).collect();
        let found = || format!("{:?} in R^{D}: {counts:?}", instance.generators);
        if counts.iter().zip(&most).any(|(count, most)| count > most) || instance.is_general && counts[..D] != most[..]
        {
            return Err(found());
        }
        let alternating: i64 =
            (0..).zip(&counts[..D]).map(|(k, &count)| if k % 2 == 0 { 1 } else { -1 } * count as i64).sum();
        let covectors: Vec<BTreeSet<Signs>> = faces_by_dimension(&doubles(&instance.generators))
            .iter()
            .map(|faces| faces.iter().map(|face| face.iter().map(|sign| *sign as i8).collect()).collect())
            .collect();
        if alternating != 1 - (-1i64).pow(D as u32) || covectors != by_dimension {
            return Err(found());
        }
        general += usize::from(instance.is_general);
        all += counts[..D].iter().sum::<usize>();
    }
    Ok(format!(
        "of {} bodies of R^{D}, {general} of them in general position, the {all} faces of all dimensions are as many \
         as general position has or fewer, and are the covectors of the arrangement",
        instances.len()
    ))
}

/// The number of faces of dimension k of a zonotope of n generators in general position: two for each choice of k
/// generators and each of the vertices that the others leave around it.
fn in_general_position(n: usize, dimension: usize, k: usize) -> usize {
    let choose = |n: usize, k: usize| (0..k).fold(1, |product, i| product * (n - i) / (i + 1));
    let rest = n - k - 1;
    2 * choose(n, k) * (0..dimension - k).map(|i| choose(rest, i.min(rest)) * usize::from(i <= rest)).sum::<usize>()
}
