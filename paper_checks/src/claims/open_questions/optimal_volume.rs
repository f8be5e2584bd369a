//! Section 7, second question.

use families::clouds;
use zonotope::bvh::volumes::least_volume::local_optima;
use zonotope::hull::in_space::solid_hull;
use zonotope::zonotope::Zonotope;

use crate::claim::{Check, CheckContext, Claim, ClaimKind, Place, Tried, Verdict};

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "question-optimal-volume",
    place: Place { section: "7", label: "second question" },
    kind: ClaimKind::OpenQuestion,
    statement: "How fast can the zonotope of least volume be computed?",
    remedy: Some(
        "the volume is no convex function of the generators: descents by linear programs from different starts end in \
            different local optima, and no search here proves one of them to be the least. A proven bound is the \
            volume of the hull; by total length the problem is solved with a proof",
    ),
    code: &["zonotope::bvh::volumes::least_volume"],
    figures: &["least-volume"],
    check: Check::Run(check),
    tried: Tried::On(&["solids"]),
};

/// Starts of each search.
const STARTS: usize = 24;

/// The most generators of a search.
const GENERATORS: usize = 6;

/// The Platonic solids but the cube, which is the least zonotope around itself.
const SOLIDS: [&str; 4] = ["tetrahedron", "octahedron", "icosahedron", "dodecahedron"];

/// Local optima around solids, each of which contains its points exactly.
fn check(context: &CheckContext) -> Verdict {
    match SOLIDS.into_iter().map(|name| around(name, context.seed)).collect::<Result<Vec<String>, String>>() {
        Err(reason) => Verdict::Inconclusive(reason),
        Ok(found) => Verdict::InPart(format!(
            "local optima of at most {GENERATORS} generators from {STARTS} random starts, smallest and largest volume \
             over that of the hull: {}",
            found.join("; ")
        )),
    }
}

fn around(name: &str, seed: u64) -> Result<String, String> {
    let points = clouds::solid(name).ok_or_else(|| format!("no solid is called {name}"))?;
    let hull = solid_hull(&points).map_err(|error| error.to_string())?.ok_or("the points lie in a plane")?;
    let [least, most] = volumes(&points, &local_optima(&points, GENERATORS, STARTS, seed))?;
    let hull = hull.volume(&points);
    if least < hull {
        return Err(format!("{name}: a zonotope is smaller than the hull"));
    }
    Ok(format!("{name} {:.3} to {:.3}", least / hull, most / hull))
}

/// The least and the largest volume of bodies, all of which contain the points.
fn volumes(points: &[[f64; 3]], bodies: &[Zonotope<3>]) -> Result<[f64; 2], String> {
    let is_inside = |body: &Zonotope<3>| points.iter().all(|point| body.contains(*point) == Ok(true));
    if bodies.is_empty() || !bodies.iter().all(is_inside) {
        return Err("no local optimum, or one that misses a point".to_owned());
    }
    let volumes = bodies.iter().map(|body| body.exact_volume().to_f64());
    Ok(volumes.fold([f64::INFINITY, 0.0], |[least, most], volume| [least.min(volume), most.max(volume)]))
}
