//! Corollary 5.4: distances in the metric of a zonotope.

use dashu_ratio::RBig;
use experiments::fit::GrowthModel;
use rand::RngExt;
use zonotope::collision::prepared::{DirectionTree, by_cutting::PreparedByCutting};
use zonotope::tally::OperationCounts;
use zonotope::zonotope::Zonotope;

use crate::claim::{Check, CheckContext, Claim, ClaimKind, Place, Tried, Verdict};
use crate::definitions::ratio::exactly;
use crate::definitions::space::{Body, Vector};
use crate::growth;
use crate::instances::bodies::{bodies_in_general_position, doubles, random_vector};
use crate::instances::polygons::generator;

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "corollary-5.4",
    place: Place { section: "5.2", label: "Corollary 5.4" },
    kind: ClaimKind::Corollary,
    statement: "For n <= m <= n^2, a structure of O(m) space built in O(m log n) time gives the distance of two points \
        in the metric of a zonotope in O((n^2/m) log^2 n) time",
    code: &["zonotope::collision::prepared::by_cutting", "zonotope::collision::prepared::by_direction_tree"],
    figures: &["query-trade-off"],
    check: Check::Run(check),
    tried: Tried::Growth(&["random bodies"]),
    ..Claim::LISTED
};

/// Distances by both structures are those of the definition; building fits m log n, and queries are those of
/// Lemma 5.3, where they are counted.
fn check(context: &CheckContext) -> Verdict {
    let methods = ["by_cutting", "by_cutting_least_space", "by_cutting_most_space"];
    let verdict = growth::verdict(context, &CLAIM, distance_evidence(context), growth_evidence, &methods);
    growth::but_for(verdict, "building with m = n^2, and m that is no power of n")
}

/// The largest u · p / h(u) over the normals of facets: how many times a body about the origin must be taken.
fn gauge(body: &Body, displacement: &Vector) -> Option<RBig> {
    body.normals().iter().map(|normal| normal.dot(displacement) / body.reach(normal)).max()
}

fn distance_evidence(context: &CheckContext) -> Result<String, String> {
    let mut random = generator(context.seed, 83);
    let instances = bodies_in_general_position(&mut random, 28);
    let mut pairs = 0;
    for instance in &instances {
        let body = Body::about_origin(&instance.generators);
        let rows = instance.generators.iter().copied().map(doubles).collect();
        let zonotope = Zonotope::new([0.0; 3], rows).map_err(|error| error.to_string())?;
        let n = instance.generators.len() as u64;
        let tree = DirectionTree::new(&zonotope);
        let prepared = |space| PreparedByCutting::new(zonotope.clone(), space, context.seed, &mut ());
        let prepared: Vec<PreparedByCutting> =
            [n, n * n].into_iter().map(prepared).collect::<Result<_, _>>().map_err(|error| error.to_string())?;
        for _ in 0..20 {
            let [p, q] = [(); 2].map(|()| random_vector(&mut random, 50));
            let displacement = [0, 1, 2].map(|k| q[k] - p[k]);
            let truth = gauge(&body, &Vector::at(displacement)).ok_or("a body without facets")?;
            let of_tree = tree.gauge(doubles(displacement), &mut ()).map_err(|error| error.to_string())?;
            let mut values = vec![(of_tree.value, of_tree.error)];
            for prepared in &prepared {
                values.push(prepared.facet(doubles(displacement), &mut ()).map_err(|error| error.to_string())?.value());
            }
            for (value, error) in values {
                let [low, high] = [-1, 1].map(|sign| exactly(value) + exactly(error) * RBig::from(sign));
                if truth < low || high < truth {
                    return Err(format!("{}: {displacement:?} is at {truth}, not {value}", instance.name));
                }
            }
            pairs += 1;
        }
    }
    Ok(format!(
        "{pairs} pairs of points in the metrics of {} bodies, m = n and n^2: the largest u · (q - p) / h(u) over all \
         facet normals is within the error that the structures state",
        instances.len()
    ))
}

/// The operations of building the structure, over m log n.
fn growth_evidence(context: &CheckContext) -> Result<String, String> {
    let mut random = generator(context.seed, 84);
    let mut evidence = Vec::new();
    for (name, halves) in [("m = n", 2), ("m = n^1.5", 3)] {
        let mut samples = Vec::new();
        for half_doublings in 10..=20 {
            for _ in 0..3 {
                let n = (1u64 << half_doublings).isqrt();
                let space = n.pow(halves).isqrt();
                let rows = (0..n).map(|_| std::array::from_fn(|_| random.random_range(-1.0..=1.0))).collect();
                let body = Zonotope::new([0.0; 3], rows).map_err(|error| error.to_string())?;
                let mut counts = OperationCounts::default();
                PreparedByCutting::new(body, space, context.seed, &mut counts).map_err(|error| error.to_string())?;
                let (n, operations) = growth::sample(n as usize, &counts);
                samples.push((n, operations / (space as f64 * libm::log2(n))));
            }
        }
        let building = format!("building with {name}, over m log n");
        evidence.push(growth::evidence(&building, &samples, GrowthModel::Constant)?);
    }
    Ok(evidence.join("; "))
}
