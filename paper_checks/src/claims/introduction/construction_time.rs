//! Section 1: the time in which a zonotope is constructed.

use experiments::families::bodies;
use experiments::fit::GrowthModel;
use zonotope::tally::OperationCounts;
use zonotope::zonotope::Zonotope;
use zonotope::zonotope::faces::{Faces, faces_counted};

use crate::claim::{Check, CheckContext, Claim, ClaimKind, Place, Tried, Verdict};
use crate::growth;

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "construction-time",
    place: Place { section: "1", label: "fourth paragraph" },
    kind: ClaimKind::Statement,
    statement: "Zonotopes of R^d can be constructed within the time O(n^(d-1)), that of their size",
    code: &["zonotope::zonotope::faces"],
    check: Check::Run(check),
    tried: Tried::Growth(FAMILIES),
    ..Claim::LISTED
};

const FAMILIES: &[&str] = &["random_bodies", "heavy_tailed_bodies"];

/// The operations of the sweep beside n², and beside the facets that it lists.
fn check(context: &CheckContext) -> Verdict {
    let found: Result<Vec<String>, String> = FAMILIES.iter().map(|family| growth_on(family, context.seed)).collect();
    match found {
        Ok(sentences) => Verdict::InPart(format!(
            "{}; the library's sweep sorts along each circle, in O(n^2 log n), and these sizes do not tell a \
             logarithm; the construction that the paper refers to was not tried",
            sentences.join("; ")
        )),
        Err(reason) => {
            Verdict::Inconclusive(format!("{reason}; the sweep is not the construction that is referred to"))
        }
    }
}

fn growth_on(family: &str, seed: u64) -> Result<String, String> {
    let bodies = bodies::find(family).ok_or_else(|| format!("no bodies are called {family}"))?;
    let mut samples = Vec::new();
    for exponent in 4..=8 {
        let n = 1 << exponent;
        for instance in 0..2 {
            let body =
                Zonotope::new([0.0; 3], bodies.generate(n, seed + instance)).map_err(|error| error.to_string())?;
            let mut counts = OperationCounts::default();
            let Faces::Solid(lattice) = faces_counted(&body, &mut counts).map_err(|error| error.to_string())? else {
                return Err(format!("{family} of {n} generators are flat"));
            };
            if lattice.facet_count() != n * (n - 1) {
                return Err(format!("{family} of {n} generators have {} facets", lattice.facet_count()));
            }
            samples.push(growth::sample(n, &counts));
        }
    }
    growth::evidence(&format!("the faces of {family} of 2^4 to 2^8 generators"), &samples, GrowthModel::Quadratic)
}
