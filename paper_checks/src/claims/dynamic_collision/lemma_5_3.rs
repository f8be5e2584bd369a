//! Lemma 5.3: more space for faster membership queries.

use experiments::fit::GrowthModel;
use rand::RngExt;
use rand_pcg::Pcg64Mcg;
use zonotope::collision::prepared::by_cutting::PreparedByCutting;
use zonotope::tally::{Operation, OperationCounts};
use zonotope::zonotope::Zonotope;

use crate::claim::{Check, CheckContext, Claim, ClaimKind, Place, Tried, Verdict};
use crate::growth;
use crate::instances::bodies::{LocatedPoint, PLACES, bodies, bodies_in_general_position, located_point};
use crate::instances::polygons::generator;
use crate::proofs::locations::proof_of;

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "lemma-5.3",
    place: Place { section: "5.2", label: "Lemma 5.3" },
    kind: ClaimKind::Lemma,
    statement: "For n <= m <= n^2, a structure of O(m) space answers membership in a zonotope of n generators in \
        O((n^2/m) log^2 n) time",
    code: &["zonotope::collision::prepared::by_cutting", "zonotope::arrangement::cutting"],
    figures: &["cutting-and-image", "query-trade-off"],
    check: Check::Run(check),
    tried: Tried::Growth(&["random bodies"]),
    ..Claim::LISTED
};

/// Queries of each body whose operations are counted.
const QUERIES: usize = 30;

/// With the least space, the most, and what is between them, queries are decided as by the definition, with proofs;
/// their operations and the bytes held fit the bounds.
fn check(context: &CheckContext) -> Verdict {
    let methods = ["by_cutting", "by_cutting_least_space", "by_cutting_most_space"];
    let verdict = growth::verdict(context, &CLAIM, decision_evidence(context), growth_evidence, &methods);
    growth::but_for(verdict, "m that is no power of n, and with m = n^2 more than 128 generators")
}

fn decision_evidence(context: &CheckContext) -> Result<String, String> {
    let mut random = generator(context.seed, 81);
    let mut instances = bodies(&mut random, 40);
    instances.extend(bodies_in_general_position(&mut random, 14));
    let mut counts = [0; 3];
    for instance in &instances {
        let (body, zonotope) = (instance.body(), instance.in_doubles());
        let n = body.generators.len() as u64;
        let prepared = |space| PreparedByCutting::new(zonotope.clone(), space, context.seed, &mut ());
        let prepared: Vec<PreparedByCutting> = [n, n * n.isqrt(), n * n]
            .into_iter()
            .map(prepared)
            .collect::<Result<_, _>>()
            .map_err(|error| format!("{}: {error}", instance.name))?;
        for trial in 0..9 {
            let LocatedPoint { point, target, place: truth } = located_point(&mut random, &body, trial);
            for prepared in &prepared {
                let answer = prepared.locate(point).map_err(|error| error.to_string())?;
                let place = || format!("{}, r = {}: {target}", instance.name, prepared.r());
                if answer.status().name() != PLACES[truth] {
                    return Err(format!("{} is {}", place(), answer.status()));
                }
                proof_of(&answer, &target, &body.generators).map_err(|reason| format!("{}: {reason}", place()))?;
            }
            counts[truth] += 1;
        }
    }
    let [inside, boundary, outside] = counts;
    Ok(format!(
        "{inside} points inside, {boundary} on the boundary and {outside} outside of {} bodies, flat and empty ones \
         among them, each with m = n, about n^1.5 and n^2: decided as by the definition, with proofs",
        instances.len()
    ))
}

/// A power of n that the space takes: its name, its exponent in halves, and the exponents of the sizes n = 2^k.
const SPACES: [(&str, u32, [u32; 4]); 3] =
    [("m = n", 2, [4, 6, 8, 10]), ("m = n^1.5", 3, [4, 6, 8, 10]), ("m = n^2", 4, [4, 5, 6, 7])];

/// Bytes that a unit of m takes at most: of bodies whose sums two doubles hold, three hundred were seen.
const BYTES_A_UNIT: f64 = 400.0;

/// Operations of a query over the bound, and bytes over m, each along three powers of n.
fn growth_evidence(context: &CheckContext) -> Result<String, String> {
    let mut random = generator(context.seed, 82);
    let mut evidence = Vec::new();
    for (name, halves, exponents) in SPACES {
        let (mut operations, mut most) = (Vec::new(), 0.0f64);
        for (exponent, _) in exponents.into_iter().flat_map(|exponent| [(exponent, 0), (exponent, 1)]) {
            let (n, space) = (1u32 << exponent, 1u64 << (exponent * halves / 2));
            let (cost, held) = cost_of_queries(n as usize, space, context.seed, &mut random)?;
            let (n, m) = (f64::from(n), space as f64);
            operations.push((n, cost / (n * n / m * f64::from(exponent) * f64::from(exponent))));
            most = most.max(held / m);
        }
        let (from, to) = (1 << exponents[0], 1 << exponents[3]);
        let of_queries = format!("queries near the boundary with {name}, n = {from} to {to}, over (n^2/m) log^2 n");
        evidence.push(growth::evidence(&of_queries, &operations, GrowthModel::Constant)?);
        if most > BYTES_A_UNIT {
            return Err(format!("{most:.0} bytes a unit of m with {name}"));
        }
        evidence.push(format!("there at most {most:.0} bytes a unit of m"));
    }
    Ok(evidence.join("; "))
}

/// The mean number of operations of queries about a random body, near its boundary, and the bytes of its structure.
fn cost_of_queries(n: usize, space: u64, seed: u64, random: &mut Pcg64Mcg) -> Result<(f64, f64), String> {
    let mut vector = || -> [f64; 3] { std::array::from_fn(|_| random.random_range(-1.0..=1.0)) };
    let rows = (0..n).map(|_| vector()).collect();
    let body = Zonotope::new([0.0; 3], rows).map_err(|error| error.to_string())?;
    let points: Vec<[f64; 3]> = (0..QUERIES).map(|_| body.support(vector()).point().map(|c| 0.9 * c)).collect();
    let prepared = PreparedByCutting::new(body, space, seed, &mut ()).map_err(|error| error.to_string())?;
    let mut counts = OperationCounts::default();
    for point in points {
        prepared.facet(point, &mut counts).map_err(|error| error.to_string())?;
    }
    let total: u64 = Operation::ALL.iter().map(|&operation| counts.get(operation)).sum();
    Ok((total as f64 / QUERIES as f64, prepared.bytes() as f64))
}
