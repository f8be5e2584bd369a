//! Section 5.2, hierarchical method, quoted from [1].

use experiments::fit::GrowthModel;
use zonotope::zonotope::Zonotope;
use zonotope::zonotope::faces::{Faces, faces};

use crate::claim::{Check, CheckContext, Claim, ClaimKind, Place, Tried, Verdict};
use crate::growth;
use families::clouds::spiral::spread_over_hemisphere;

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "ball-approximation",
    place: Place { section: "5.2", label: "hierarchical method, quoted from [1]" },
    kind: ClaimKind::Statement,
    statement: "The unit ball of R^3 is within Hausdorff distance eps of a zonotope with O(1/eps) generators",
    code: &["zonotope::zonotope::faces", "zonotope::reduction"],
    check: Check::Run(check),
    tried: Tried::Scope("the unit ball"),
    ..Claim::LISTED
};

/// Zonotopes with generators of one length along directions spread evenly, scaled to lie as far outside of the ball as
/// inside: half the difference of their largest and least support value is their distance from it.
fn check(_context: &CheckContext) -> Verdict {
    let mut samples = Vec::new();
    for count in [8, 16, 32, 64, 128] {
        match distance_from_ball(count) {
            Ok(distance) => samples.push((count as f64, distance)),
            Err(reason) => return Verdict::Inconclusive(reason),
        }
    }
    let products: Vec<String> =
        samples.iter().map(|(count, distance)| format!("{:.3} for {count}", count * distance)).collect();
    let what = "distances of zonotopes of 8 to 128 generators spread evenly from the ball";
    match growth::evidence_on(what, &samples, GrowthModel::Inverse) {
        Ok(sentence) => {
            Verdict::Holds(format!("{sentence}; eps times the number of generators is {}", products.join(", ")))
        }
        Err(sentence) => Verdict::Inconclusive(sentence),
    }
}

/// The Hausdorff distance of the unit ball and a zonotope of some generators. The support function is largest at a
/// vertex and least, over unit vectors, at a facet normal.
fn distance_from_ball(count: usize) -> Result<f64, String> {
    let body = Zonotope::new([0.0; 3], spread_over_hemisphere(count)).map_err(|error| error.to_string())?;
    let lattice = match faces(&body, &mut ()).map_err(|error| error.to_string())? {
        Faces::Solid(lattice) => lattice,
        _ => return Err(format!("{count} directions do not span space")),
    };
    let norm = |v: &[f64; 3]| v.iter().map(|c| c * c).sum::<f64>().sqrt();
    let outer = lattice.points().iter().map(norm).fold(0.0, f64::max);
    let mut inner = f64::INFINITY;
    let generators = body.generators();
    for (index, a) in generators.iter().enumerate() {
        for b in &generators[..index] {
            let normal = [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
            let reach: f64 =
                generators.iter().map(|v| (0..3).map(|k| v[k] * normal[k]).sum::<f64>().abs()).sum::<f64>();
            inner = inner.min(reach / norm(&normal));
        }
    }
    Ok((outer - inner) / (outer + inner))
}
