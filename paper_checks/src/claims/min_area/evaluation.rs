//! Section 4.1, sixth paragraph.

use experiments::fit::GrowthModel;
use zonotope::enclosing::centered_zonogon::CenteredZonogon;
use zonotope::hull::antipodal::farthest_vertices;
use zonotope::hull::convex_hull;
use zonotope::tally::OperationCounts;

use crate::claim::{Check, CheckContext, Claim, ClaimKind, Place, Tried, Verdict};
use crate::definitions::plane::{Point, zonogon_area};
use crate::growth;
use crate::instances::polygons::{generator, polygons, random_center};
use crate::proofs::library::{double, doubles};

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "evaluation-in-linear-time",
    place: Place { section: "4.1", label: "sixth paragraph" },
    kind: ClaimKind::Statement,
    statement: "Given the polygon H and O, Z(O) and f(O) are computed in O(n) time",
    code: &["zonotope::enclosing::centered_zonogon"],
    figures: &["polygon-and-reflection"],
    check: Check::Run(check),
    tried: Tried::Growth(&["points on a circle"]),
    ..Claim::LISTED
};

const SIZES: [usize; 5] = [1 << 8, 1 << 10, 1 << 12, 1 << 14, 1 << 16];

/// Compares f(O) with the area of a hull of all points and reflections, and counts the operations from H to Z(O).
fn check(context: &CheckContext) -> Verdict {
    let areas = match area_evidence(context) {
        Ok(evidence) => evidence,
        Err(witness) => return Verdict::Refuted(witness),
    };
    match growth_evidence(context) {
        Ok(growth) => Verdict::Holds(format!("{areas}; {growth}")),
        Err(reason) => Verdict::Inconclusive(format!("{areas}; {reason}")),
    }
}

fn area_evidence(context: &CheckContext) -> Result<String, String> {
    let mut random = generator(context.seed, 51);
    let mut tried = 0;
    for instance in polygons(&mut random, 40) {
        for _ in 0..3 {
            let center = double(&random_center(&mut random, &instance.polygon));
            let hull = convex_hull(&doubles(&instance.polygon), &mut ()).map_err(|error| error.to_string())?;
            let farthest = farthest_vertices(&hull, &mut ());
            let area = CenteredZonogon::new(&hull, &farthest, center, &mut ()).exact_area().to_rational();
            let expected = zonogon_area(&instance.polygon, &Point::exactly(center));
            if area != expected {
                return Err(format!("{}: f({center:?}) is {expected}, not {area}", instance.name));
            }
            tried += 1;
        }
    }
    Ok(format!("f(O) is the area of the hull of points and reflections for {tried} centres"))
}

fn growth_evidence(context: &CheckContext) -> Result<String, String> {
    let circle = families::points::find("circle").ok_or("there is no family of circles")?;
    let mut samples = Vec::new();
    for n in SIZES {
        for instance in 0..2 {
            let hull = convex_hull(&circle.generate(n, context.seed + instance), &mut ())
                .map_err(|error| error.to_string())?;
            let mut counts = OperationCounts::default();
            let farthest = farthest_vertices(&hull, &mut counts);
            CenteredZonogon::new(&hull, &farthest, hull.vertices()[0], &mut counts);
            samples.push(growth::sample(hull.edge_count(), &counts));
        }
    }
    growth::evidence("farthest vertices and Z(O) together", &samples, GrowthModel::Linear)
}
