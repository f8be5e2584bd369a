//! Section 5.2, hierarchical method, quoted from [2].

use rand::RngExt;
use rand_pcg::Pcg64Mcg;
use zonotope::reduction::{Method, Problem, contains, hausdorff::excess};
use zonotope::zonotope::Zonotope;

use crate::claim::{Check, CheckContext, Claim, ClaimKind, Place, Tried, Verdict};
use crate::instances::polygons::generator;

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "zonoid-approximation",
    place: Place { section: "5.2", label: "hierarchical method, quoted from [2]" },
    kind: ClaimKind::Statement,
    statement: "Every zonoid of R^d is within eps of its diameter of a zonotope with O(d / eps^(2 + tau)) generators, \
        for any tau > 0",
    code: &["zonotope::reduction::by_clusters"],
    figures: &["reduction-error"],
    check: Check::Run(check),
    tried: Tried::On(&["random bodies of R^2 to R^4"]),
    ..Claim::LISTED
};

/// Generators of the bodies that stand for zonoids, which are limits of zonotopes.
const GENERATORS: usize = 600;

/// The distance that cluster sums reach with k generators, and the constant c with which k = c d / eps² there.
fn check(context: &CheckContext) -> Verdict {
    let mut random = generator(context.seed, 86);
    let found = [
        reached::<2>(&mut random, &[4, 8, 16]),
        reached::<3>(&mut random, &[6, 12, 24]),
        reached::<4>(&mut random, &[8, 16]),
    ];
    match found.into_iter().collect::<Result<Vec<String>, String>>() {
        Ok(sentences) => Verdict::Holds(format!(
            "sums of clusters, which contain the body exactly, reach eps with k = c d / eps^2 generators, of bodies of \
             {GENERATORS} random ones: {}",
            sentences.join("; ")
        )),
        Err(reason) => Verdict::Inconclusive(reason),
    }
}

fn reached<const D: usize>(random: &mut Pcg64Mcg, counts: &[usize]) -> Result<String, String> {
    let rows = (0..GENERATORS).map(|_| std::array::from_fn(|_| random.random_range(-1.0..=1.0))).collect();
    let body = Zonotope::<D>::new([0.0; D], rows).map_err(|error| error.to_string())?;
    let point = Zonotope::<D>::new([0.0; D], Vec::new()).map_err(|error| error.to_string())?;
    let diameter = 2.0 * excess(&body, &point, 0.05).lower;
    let mut constants = Vec::new();
    for &count in counts {
        let problem = Problem::new(&body, count).map_err(|error| error.to_string())?;
        let reduced = Method::Clusters.reduce(&problem).map_err(|error| error.to_string())?.body;
        if contains(&reduced, &body) != Some(true) {
            return Err(format!("{count} generators of R^{D} do not contain the body"));
        }
        let epsilon = excess(&reduced, &body, 0.1).upper / diameter;
        constants.push(count as f64 * epsilon * epsilon / D as f64);
    }
    let is_falling = constants.windows(2).all(|pair| pair[1] <= pair[0]);
    let shown: Vec<String> =
        counts.iter().zip(&constants).map(|(count, constant)| format!("{constant:.4} for k = {count}")).collect();
    let sentence = format!("d = {D}: c = {}", shown.join(", "));
    if is_falling { Ok(sentence) } else { Err(format!("{sentence}: it does not fall")) }
}
