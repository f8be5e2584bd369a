//! The search halves the candidate vertices.

use experiments::families;
use zonotope::enclosing::min_area_zonogon::min_area_enclosing_zonogon_with;
use zonotope::lad::Method;
use zonotope::tally::{Operation, OperationCounts};

use crate::claim::{Check, CheckContext, Claim, ClaimKind, Place, Verdict};

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "halving-search",
    place: Place { section: "4.1", label: "before Theorem 4.5" },
    kind: ClaimKind::Statement,
    statement: "Each step of the search halves the candidate vertices by slope selection, in O(n log n) time, so O(log n) steps find the minimum",
    code: &["zonotope::lad::by_slope_selection", "zonotope::arrangement::slope_selection"],
    figures: &["scaling-kernel-operations", "scaling-kernel-times"],
    check: Check::Run(check),
    ..Claim::LISTED
};

/// Counts the steps of the paper's search against the number of halvings that n (n - 1) / 2 vertices allow.
fn check(context: &CheckContext) -> Verdict {
    let Some(method) = Method::from_name("by_slope_selection") else {
        return Verdict::Inconclusive("the paper's own search is not among the methods".to_owned());
    };
    let mut steps = Vec::new();
    for id in ["circle", "random_convex", "regular_polygon"] {
        let Some(family) = families::find(id) else {
            return Verdict::Inconclusive(format!("there is no family {id}"));
        };
        let mut most = 0;
        for exponent in 4..=11 {
            let n: u64 = 1 << exponent;
            let points = family.generate(1 << exponent, context.seed);
            let mut counts = OperationCounts::default();
            let answer = min_area_enclosing_zonogon_with(method, &points, context.seed, &mut counts);
            if let Err(error) = answer {
                return Verdict::Inconclusive(format!("{id}, n = {n}: {error}"));
            }
            let taken = counts.get(Operation::SearchStep);
            let halvings = u64::from((n * (n - 1) / 2).ilog2()) + 1;
            if taken > halvings {
                return Verdict::Inconclusive(format!("{id}, n = {n}: {taken} steps, {halvings} halvings"));
            }
            most = most.max(taken);
        }
        steps.push(format!("at most {most} on {id}"));
    }
    Verdict::Holds(format!(
        "vertical lines searched for n = 2^4 to 2^11: {}; never more than halving n (n - 1) / 2 vertices takes",
        steps.join(", ")
    ))
}
