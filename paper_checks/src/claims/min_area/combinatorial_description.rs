//! The runs of Z(O).

use crate::claim::{Check, CheckContext, Claim, ClaimKind, Place, Tried, Verdict};
use crate::definitions::plane::Point;
use crate::definitions::runs::{Run, runs};
use crate::instances::polygons::{generator, listed, polygons, random_center};
use crate::proofs::library::{centered_zonogon, double};

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "combinatorial-description",
    place: Place { section: "4.1", label: "fifth paragraph" },
    kind: ClaimKind::Statement,
    statement: "Z(O) is a circular sequence of runs of consecutive points and runs of consecutive reflected points, in \
        turn",
    code: &["zonotope::enclosing::centered_zonogon"],
    figures: &["paper-figure-2"],
    check: Check::Run(check),
    tried: Tried::On(&["random polygons", "degenerate polygons"]),
    ..Claim::LISTED
};

/// Reads the runs off the hull; they are consecutive on H, odd in number, and opposite runs are reflections.
fn check(context: &CheckContext) -> Verdict {
    let mut random = generator(context.seed, 4);
    let mut tried = 0;
    let mut longest = 0;
    for instance in polygons(&mut random, 60) {
        let polygon = &instance.polygon;
        for _ in 0..6 {
            let rounded = double(&random_center(&mut random, polygon));
            let center = Point::exactly(rounded);
            let Some(runs) = runs(polygon, &center) else {
                continue;
            };
            if !is_description(polygon, &center, &runs) {
                return Verdict::Refuted(format!("{} about {center}", listed(polygon)));
            }
            if centered_zonogon(polygon, rounded).1 != 2 * runs.len() {
                return Verdict::Refuted(format!("the library's description of {} about {center}", instance.name));
            }
            tried += 1;
            longest = longest.max(runs.len());
        }
    }
    Verdict::Holds(format!(
        "{tried} zonogons are k runs of consecutive points and k of consecutive reflected points in turn; opposite \
         runs are reflections, so k is odd (at most {longest} here); the library finds as many"
    ))
}

fn is_description(polygon: &[Point], center: &Point, runs: &[Run]) -> bool {
    let consecutive = |run: &mut dyn Iterator<Item = Point>| {
        let indices: Vec<Option<usize>> = run.map(|vertex| polygon.iter().position(|point| *point == vertex)).collect();
        indices.windows(2).all(|pair| match pair {
            [Some(one), Some(next)] => (one + 1) % polygon.len() == *next,
            _ => false,
        })
    };
    let mirrored = |run: &Run| run.reflected.iter().map(|vertex| vertex.reflected_through(center)).collect::<Vec<_>>();
    let k = runs.len();
    k % 2 == 1
        && runs.iter().enumerate().all(|(s, run)| {
            consecutive(&mut run.original.iter().cloned())
                && consecutive(&mut mirrored(run).into_iter())
                && mirrored(run) == runs[(s + k.div_ceil(2)) % k].original
        })
}
