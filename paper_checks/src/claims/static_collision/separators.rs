//! The separators of the tiling.

use dashu_ratio::RBig;
use experiments::fit::GrowthModel;
use zonotope::arrangement::DualArrangement;
use zonotope::arrangement::separator::separator;
use zonotope::tally::OperationCounts;

use crate::claim::{Check, CheckContext, Claim, ClaimKind, Place, Tried, Verdict};
use crate::definitions::plane::Point;
use crate::definitions::ratio::integer;
use crate::definitions::space::Body;
use crate::definitions::upper_hull::{UpperFacet, project};
use crate::growth;
use crate::instances::bodies::tilings;
use crate::instances::bodies::{doubles, random_vector};
use crate::instances::polygons::generator;

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "separators",
    place: Place { section: "5.1", label: "separators" },
    kind: ClaimKind::Statement,
    statement: "The chain of the projected generators in the order in which the vertical line L_k meets their lines \
        separates the first k tiles from the others, and is built in O(n log n) time",
    code: &["zonotope::arrangement::separator"],
    figures: &["paper-figure-1", "separators"],
    check: Check::Run(check),
    tried: Tried::Growth(&["random bodies"]),
    ..Claim::LISTED
};

/// Builds each chain from the definition, looks on which side every tile lies, and asks the library for the same chain.
fn check(context: &CheckContext) -> Verdict {
    let sides = match side_evidence(context) {
        Ok(evidence) => evidence,
        Err(witness) => return Verdict::Refuted(witness),
    };
    match growth_evidence(context) {
        Ok(growth) => Verdict::Holds(format!("{sides}; {growth}")),
        Err(reason) => Verdict::Inconclusive(format!("{sides}; {reason}")),
    }
}

fn side_evidence(context: &CheckContext) -> Result<String, String> {
    let mut random = generator(context.seed, 45);
    let (mut chains, mut tiles, mut tilings_seen) = (0, 0, 0);
    for (instance, body, mut facets) in tilings(&mut random, 35) {
        facets.sort_by(|a, b| a.crossing.x.cmp(&b.crossing.x));
        let ambiguous = facets.windows(2).any(|pair| pair[0].crossing.x == pair[1].crossing.x)
            || instance.generators.iter().any(|generator| generator[1] == 0);
        if ambiguous {
            continue;
        }
        tilings_seen += 1;
        let rows: Vec<[f64; 3]> = instance.generators.iter().copied().map(doubles).collect();
        let dual = DualArrangement::new(&rows).map_err(|error| error.to_string())?;
        for k in 0..=facets.len() {
            let chain = chain(&body, &facets, k);
            let name = || format!("{}, separator {k}", instance.name);
            for (index, facet) in facets.iter().enumerate() {
                let side = if index < k { -1 } else { 1 };
                if !facet.tile.iter().all(|corner| is_beside(&chain, &body, corner, side)) {
                    return Err(format!("{}: the tile {:?}", name(), facet.pair));
                }
                tiles += 1;
            }
            let found =
                separator(&dual, k as u64, context.seed, &mut ()).map_err(|error| format!("{}: {error}", name()))?;
            let points: Vec<Point> = found.rational_points().into_iter().map(|[x, y]| Point::new(x, y)).collect();
            if points != chain {
                return Err(format!("{}: the library's chain is another one", name()));
            }
            chains += 1;
        }
    }
    Ok(format!(
        "{chains} chains of {tilings_seen} tilings have the first k tiles on their left and the others on their right \
         ({tiles} sides), and the library builds the same chains"
    ))
}

/// The chain about the origin: from the top, a step of −2 v' for each line in the order in which L_k meets them from
/// top to bottom.
fn chain(body: &Body, facets: &[UpperFacet], k: usize) -> Vec<Point> {
    let x = match (k.checked_sub(1).map(|last| &facets[last].crossing.x), facets.get(k).map(|next| &next.crossing.x)) {
        (Some(last), Some(next)) => (last + next) / integer(2),
        (Some(last), None) => last + integer(1),
        (None, Some(next)) => next - integer(1),
        (None, None) => integer(0),
    };
    let mut steps: Vec<(RBig, Point)> = body
        .generators
        .iter()
        .map(|generator| {
            let [a, b, c] = &generator.0;
            let projected = project(generator);
            let upward = if *b < RBig::ZERO { Point::at(0, 0).plus(&integer(-1), &projected) } else { projected };
            (-(a * &x + c) / b, upward)
        })
        .collect();
    steps.sort_by(|(one, _), (other, _)| other.cmp(one));
    let top = steps.iter().fold(Point::at(0, 0), |sum, (_, step)| sum.plus(&integer(1), step));
    let mut chain = vec![top];
    for (_, step) in &steps {
        chain.push(chain[chain.len() - 1].plus(&integer(-2), step));
    }
    chain
}

/// Whether a corner of a tile of the body lies on the chain or on its left (−1) or right (1).
fn is_beside(chain: &[Point], body: &Body, corner: &Point, side: i64) -> bool {
    let corner = project(&body.center).to(corner);
    chain.windows(2).any(|pair| {
        let (above, below) = (&pair[0], &pair[1]);
        let spans = below.y <= corner.y && corner.y <= above.y;
        let turn = below.to(above).cross(&below.to(&corner));
        spans && integer(side) * turn <= RBig::ZERO
    })
}

/// The operations of one separator against n log n.
fn growth_evidence(context: &CheckContext) -> Result<String, String> {
    let mut random = generator(context.seed, 46);
    let mut samples = Vec::new();
    for exponent in 6..=13 {
        let n = 1 << exponent;
        let rows: Vec<[f64; 3]> = (0..n).map(|_| doubles(random_vector(&mut random, 1 << 20))).collect();
        let dual = DualArrangement::new(&rows).map_err(|error| error.to_string())?;
        for part in 1..4 {
            let k = dual.lines().vertex_count() / 4 * part;
            let mut counts = OperationCounts::default();
            separator(&dual, k, context.seed, &mut counts).map_err(|error| error.to_string())?;
            samples.push(growth::sample(n, &counts));
        }
    }
    growth::evidence("one separator of 2^6 to 2^13 generators", &samples, GrowthModel::Linearithmic)
}
