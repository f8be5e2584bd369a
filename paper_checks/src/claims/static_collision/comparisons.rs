//! Section 5.1: the comparisons of the search.

use families::bodies;
use zonotope::collision::Query;
use zonotope::collision::by_slope_selection::{self, Hull};
use zonotope::zonotope::Zonotope;

use crate::claim::{Check, CheckContext, Claim, ClaimKind, Place, Tried, Verdict};

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "separator-comparisons",
    place: Place { section: "5.1", label: "separators" },
    kind: ClaimKind::Statement,
    statement: "The binary search on the monotone separators performs O(log n) comparisons against separators",
    code: &["zonotope::collision::by_slope_selection"],
    check: Check::Run(check),
    tried: Tried::On(FAMILIES),
    ..Claim::LISTED
};

const FAMILIES: &[&str] = &["random_bodies", "heavy_tailed_bodies", "lattice_bodies"];

/// Each comparison drops half of the n(n-1)/2 tiles, so there are at most as many as halvings.
fn check(context: &CheckContext) -> Verdict {
    let mut found = Vec::new();
    for n in [16, 64, 256, 1024] {
        match FAMILIES.iter().map(|family| most(family, n, context.seed)).collect::<Result<Vec<_>, _>>() {
            Err(reason) => return Verdict::Inconclusive(reason),
            Ok(counts) => {
                let halvings = (n * (n - 1) / 2).ilog2() as usize + 1;
                let most = counts.into_iter().max().unwrap_or(0);
                if most > halvings {
                    return Verdict::Refuted(format!("{most} comparisons for n = {n}, which has {halvings} halvings"));
                }
                found.push(format!("{most} for n = {n} ({halvings} halvings)"));
            }
        }
    }
    Verdict::Holds(format!("the most comparisons of a search in one tiling: {}", found.join(", ")))
}

/// The most comparisons of searches about points near the boundary of a body.
fn most(family: &str, n: usize, seed: u64) -> Result<usize, String> {
    let bodies = bodies::find(family).ok_or_else(|| format!("no bodies are called {family}"))?;
    let body = Zonotope::new([0.0; 3], bodies.generate(n, seed)).map_err(|error| error.to_string())?;
    let mut most = 0;
    for direction in [[1.0, 2.0, 3.0], [-3.0, 1.0, 0.5], [0.1, -0.2, 1.0]] {
        let point = body.support(direction).point().map(|c| 0.9 * c);
        let question = Query::of_point(point, &body).map_err(|error| error.to_string())?;
        let steps = by_slope_selection::trace(&question, seed).steps;
        for hull in [Hull::Upper, Hull::Lower] {
            most = most.max(steps.iter().filter(|step| step.hull == hull).count());
        }
    }
    Ok(most)
}
