//! Lemma 5.5: a zonotope of few generators near one of many.

use experiments::fit::GrowthModel;
use zonotope::reduction::by_patches::{patch_count, patches_within};
use zonotope::reduction::{contains, hausdorff::excess};
use zonotope::zonotope::Zonotope;

use crate::claim::{Check, CheckContext, Claim, ClaimKind, Place, Tried, Verdict};
use crate::growth;
use crate::instances::bodies::{doubles, random_vector};
use crate::instances::polygons::generator;

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "lemma-5.5",
    place: Place { section: "5.2", label: "Lemma 5.5" },
    kind: ClaimKind::Lemma,
    statement: "Every zonotope A of R^3 has a zonotope B with O(1/eps^2) generators and Hausdorff distance at most eps \
        D(A), computed in O(n) time",
    code: &["zonotope::reduction::by_patches", "zonotope::reduction::hausdorff"],
    figures: &["reduction-error", "reductions"],
    check: Check::Run(check),
    tried: Tried::Growth(&["random bodies"]),
    ..Claim::LISTED
};

/// Generators of each body: more than there are patches for most precisions.
const GENERATORS: usize = 3000;

/// 1/eps.
const INVERSE_PRECISIONS: [u32; 5] = [2, 3, 4, 6, 8];

/// The distance is bounded from above and the diameter from below; the patches grow like 1/eps².
fn check(context: &CheckContext) -> Verdict {
    growth::verdict(context, &CLAIM, distance_evidence(context), |_| patch_evidence(), &["lemma_5_5"])
}

fn distance_evidence(context: &CheckContext) -> Result<String, String> {
    let mut random = generator(context.seed, 85);
    let mut found = Vec::new();
    for reach in [5, 100, 100_000] {
        let rows = (0..GENERATORS).map(|_| doubles(random_vector(&mut random, reach))).collect();
        let body = Zonotope::new([0.0; 3], rows).map_err(|error| error.to_string())?;
        let point = Zonotope::new([0.0; 3], Vec::new()).map_err(|error| error.to_string())?;
        let diameter = 2.0 * excess(&body, &point, 0.01).lower;
        for inverse in INVERSE_PRECISIONS {
            let epsilon = 1.0 / f64::from(inverse);
            let reduced = patches_within(&body, epsilon, &mut ()).map_err(|error| error.to_string())?.body;
            let error = excess(&reduced, &body, 0.01).upper / diameter;
            let generators = reduced.generators().len();
            if contains(&reduced, &body) != Some(true) || error > epsilon {
                return Err(format!("coordinates to {reach}, eps = 1/{inverse}: an error of {error}"));
            }
            if generators > GENERATORS.min(patch_count(3, epsilon) as usize + 3) {
                return Err(format!("coordinates to {reach}, eps = 1/{inverse}: {generators} generators"));
            }
            if reach == 100 {
                found.push(format!("{generators} for 1/{inverse}, which reach {error:.3}"));
            }
        }
    }
    Ok(format!(
        "bodies of {GENERATORS} generators, by way of shares that are exact: {}; the time is that of finding the patch \
         of each generator once",
        found.join(", ")
    ))
}

/// The patches that a precision takes, beside the square of 1/eps.
fn patch_evidence() -> Result<String, String> {
    let samples: Vec<(f64, f64)> =
        (2..=64).map(|inverse| (f64::from(inverse), patch_count(3, 1.0 / f64::from(inverse)))).collect();
    growth::evidence_on("patches for 1/eps = n = 2 to 64", &samples, GrowthModel::Quadratic)
}
