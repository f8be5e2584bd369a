//! Theorem 4.5: the minimum-area zonogon in O(n log^2 n).

use experiments::fit::GrowthModel;
use zonotope::enclosing::min_area_zonogon::Method;
use zonotope::enclosing::min_area_zonogon::exact::exact_optimum;
use zonotope::tally::OperationCounts;

use crate::claim::{Check, CheckContext, Claim, ClaimKind, Place, Tried, Verdict};
use crate::definitions::plane::{Point, least_area, zonogon_area};
use crate::definitions::ratio::{exactly, integer};
use crate::growth;
use crate::instances::polygons::{Instance, generator, polygons, random_polygon};
use crate::proofs::library::{doubles, encloses};

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "theorem-4.5",
    place: Place { section: "4.1", label: "Theorem 4.5" },
    kind: ClaimKind::Theorem,
    statement: "The minimum-area zonotope containing n points of the plane can be computed in O(n log^2 n) time",
    code: &["zonotope::enclosing::min_area_zonogon", "zonotope::lad::of_lines::by_slope_selection"],
    figures: &[
        "country-outlines",
        "polygon-and-reflection",
        "scaling-kernel-operations",
        "scaling-kernel-times",
        "scaling-min-area-operations",
        "scaling-min-area-times",
        "search-of-theorem-4-5",
    ],
    check: Check::Run(check),
    tried: Tried::Growth(&["random convex polygons"]),
    ..Claim::LISTED
};

/// The answer of every method is the least value over all vertices; operations of the paper's search fit n log^2 n.
fn check(context: &CheckContext) -> Verdict {
    growth::verdict(context, &CLAIM, optimum_evidence(context), growth_evidence, &["by_slope_selection"])
}

fn optimum_evidence(context: &CheckContext) -> Result<String, String> {
    let mut random = generator(context.seed, 18);
    let mut instances = polygons(&mut random, 60);
    instances.extend((0..6).map(|index| Instance {
        name: format!("large random polygon {index}"),
        polygon: random_polygon(&mut random, 3000, 1_000_000),
    }));
    let mut largest = 0;
    for instance in &instances {
        let polygon = &instance.polygon;
        let (least, _) = least_area(polygon);
        for method in Method::ALL {
            let answer = method
                .solve(&doubles(polygon), context.seed, &mut ())
                .map_err(|error| format!("{}: {error}", instance.name))?;
            let center = exact_optimum(&answer).center;
            let center = Point::new(center[0].clone(), center[1].clone());
            let excess = exactly(answer.value) - &least;
            let bounded = exactly(answer.lower_bound) <= least && excess >= integer(0);
            let tight = excess * integer(1_000_000_000_000) <= least;
            if zonogon_area(polygon, &center) != least || !bounded || !tight || !encloses(&answer, polygon) {
                return Err(format!("{} by {method:?}: area {}, least {least}", instance.name, answer.value));
            }
        }
        largest = largest.max(polygon.len());
    }
    Ok(format!(
        "for {} polygons of up to {largest} vertices each of {} methods finds the least area over all vertices of the \
         arrangement, and its zonogon in doubles encloses the points with at most 1e-12 more area",
        instances.len(),
        Method::ALL.len()
    ))
}

/// The operations of the paper's own search on random convex polygons, against n log^2 n.
fn growth_evidence(context: &CheckContext) -> Result<String, String> {
    let family = families::points::find("random_convex").ok_or("the family of random convex polygons is missing")?;
    let method = Method::from_id("by_slope_selection").ok_or("the paper's own search is not among the methods")?;
    let mut samples = Vec::new();
    for exponent in 6..=12 {
        let n = 1 << exponent;
        for instance in 0..2 {
            let points = family.generate(n, context.seed + instance);
            let mut counts = OperationCounts::default();
            method.solve(&points, context.seed, &mut counts).map_err(|error| error.to_string())?;
            samples.push(growth::sample(n, &counts));
        }
    }
    growth::evidence(
        "the search by slope selection on random convex polygons of 2^6 to 2^12 points",
        &samples,
        GrowthModel::LinearLogSquared,
    )
}
