//! Section 5.2, hierarchical method, quoted from [7].

use experiments::fit::GrowthModel;

use crate::claim::{Check, CheckContext, Claim, ClaimKind, Place, Tried, Verdict};
use crate::growth;
use families::clouds::spiral::spread_over_sphere;

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "convex-approximation",
    place: Place { section: "5.2", label: "hierarchical method, quoted from [7]" },
    kind: ClaimKind::Statement,
    statement: "Every convex body of R^3 is within eps of its diameter, in Hausdorff distance, of a convex body with \
        O(1/eps) vertices",
    code: &["zonotope::reduction"],
    check: Check::Run(check),
    tried: Tried::On(&["the ball"]),
    ..Claim::LISTED
};

/// The ball, and the ellipsoids that it is mapped to, within polytopes whose vertices are spread evenly over it: a map
/// that shortens every vector but those along one axis shortens distances and keeps the diameter.
fn check(_context: &CheckContext) -> Verdict {
    let samples: Vec<(f64, f64)> =
        [16, 24, 32, 48, 64, 96].into_iter().map(|count| (count as f64, distance_from_ball(count) / 2.0)).collect();
    let products: Vec<String> =
        samples.iter().map(|(count, distance)| format!("{:.2} for {count:.0}", count * distance)).collect();
    let what = "distances of polytopes of 16 to 96 vertices from the ball, in diameters";
    match growth::evidence_on(what, &samples, GrowthModel::Inverse) {
        Ok(sentence) => Verdict::Holds(format!(
            "{sentence}; eps times the number of vertices is {}; so it is at most for every ellipsoid, other bodies \
             were not tried",
            products.join(", ")
        )),
        Err(sentence) => Verdict::Inconclusive(sentence),
    }
}

/// The reach of the ball beyond the hull of points of its surface: 1 less the least distance of a facet's plane. Of
/// the planes through three points those of facets have all points on one side.
fn distance_from_ball(count: usize) -> f64 {
    let points = spread_over_sphere(count);
    let mut least = 1.0f64;
    for (third, c) in points.iter().enumerate() {
        for (second, b) in points[..third].iter().enumerate() {
            for a in &points[..second] {
                least = least.min(facet_distance([a, b, c], &points).unwrap_or(1.0));
            }
        }
    }
    1.0 - least
}

/// The distance from the origin of the plane through three points, if all points are on one side of it.
fn facet_distance([a, b, c]: [&[f64; 3]; 3], points: &[[f64; 3]]) -> Option<f64> {
    let [u, v] = [b, c].map(|end| [0, 1, 2].map(|k| end[k] - a[k]));
    let normal = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
    let along = |p: &[f64; 3]| (0..3).map(|k| normal[k] * p[k]).sum::<f64>();
    let (offset, length) = (along(a), along(&normal).sqrt());
    let slack = 1e-12 * length;
    let is_facet = match offset > 0.0 {
        true => points.iter().all(|p| along(p) <= offset + slack),
        false => points.iter().all(|p| along(p) >= offset - slack),
    };
    is_facet.then_some(offset.abs() / length)
}
