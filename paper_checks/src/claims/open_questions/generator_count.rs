//! Section 7, third question.

use families::clouds;
use zonotope::enclosing::{min_length, min_length_of_few};

use crate::claim::{Check, CheckContext, Claim, ClaimKind, Place, Tried, Verdict};
use crate::proofs::lengths::check_shortest;

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "question-generator-count",
    place: Place { section: "7", label: "third question" },
    kind: ClaimKind::OpenQuestion,
    statement: "How many generators does that zonotope have?",
    remedy: Some(
        "by total length in place of volume, the shortest zonotope that is found of at most K generators has a proven \
            ratio to the least one of any number; how many the zonotope of least volume has stays open",
    ),
    code: &["zonotope::enclosing::min_total_length::few_generators"],
    figures: &["few-generators", "least-volume"],
    check: Check::Run(check),
    tried: Tried::On(&["solids"]),
};

/// The relative excess that a length may have over the least one.
const EPSILON: f64 = 0.01;

/// The numbers of generators that are tried.
const COUNTS: [usize; 3] = [3, 4, 6];

/// The Platonic solids but the cube, which is a zonotope of three generators itself.
const SOLIDS: [&str; 4] = ["tetrahedron", "octahedron", "icosahedron", "dodecahedron"];

/// Few generators around solids by total length, with the ratios proven.
fn check(_: &CheckContext) -> Verdict {
    match SOLIDS.into_iter().map(around).collect::<Result<Vec<String>, String>>() {
        Err(reason) => Verdict::Inconclusive(reason),
        Ok(found) => Verdict::InPart(format!(
            "for total length in place of volume: generators within 1 % of the least, and proven ratios of \
             zonotopes of at most {}, {} and {} generators: {}",
            COUNTS[0],
            COUNTS[1],
            COUNTS[2],
            found.join("; ")
        )),
    }
}

/// The number of generators within the ratio around a solid, and the ratios of fewer, with their proofs checked.
fn around(name: &str) -> Result<String, String> {
    let points = clouds::solid(name).ok_or_else(|| format!("no solid is called {name}"))?;
    let within = min_length(&points, EPSILON).map_err(|error| error.to_string())?;
    check_shortest(&points, &within).map_err(|defect| format!("{name}: {defect}"))?;
    if within.ratio() > 1.0 + EPSILON {
        return Err(format!("{name}: ratio {}", within.ratio()));
    }
    let ratio = |most: usize| {
        let few = min_length_of_few(&points, EPSILON, most).map_err(|error| error.to_string())?;
        check_shortest(&points, &few).map_err(|defect| format!("{name} with {most}: {defect}"))?;
        let count = few.body.generators().len();
        if count > most { Err(format!("{name}: {count} generators, not {most}")) } else { Ok(few.ratio()) }
    };
    let ratios: Vec<String> =
        COUNTS.into_iter().map(|most| Ok(format!("{:.3}", ratio(most)?))).collect::<Result<_, String>>()?;
    Ok(format!("{name} {}, then {}", within.body.generators().len(), ratios.join(", ")))
}
