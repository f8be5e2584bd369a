//! The error of each rule of order reduction against the number of generators.

use crate::definition::{Bound, Case, Experiment, FitPlan, Measurement, PerProfile, Quantity, Variant, Verdict};
use crate::fit::GrowthModel;
use crate::seed::Digest;
use zonotope::reduction::hausdorff::excess;
use zonotope::reduction::{Method, Problem, contains};
use zonotope::tally::OperationCounts;
use zonotope::zonotope::Zonotope;

/// Generators of each body before it is reduced.
pub const GENERATORS: usize = 1000;

/// The bounds of a Hausdorff distance are wanted within this part of it.
const WIDTH: f64 = 0.01;

const FAMILIES: &[&str] = &["random_bodies", "heavy_tailed_bodies", "lattice_bodies"];

/// The error of each rule of order reduction against the number of generators.
pub const EXPERIMENT: Experiment = Experiment {
    id: "reduction-error",
    title: "Order reduction: error against generators",
    question: "How far from the body is each rule's reduction, against the number of generators? n is the number k \
               of generators that a body of 1,000 is reduced to; `error` is the proven upper bound of the Hausdorff \
               distance in terms of the diameter, `error_from_below` the lower one. Each reduction has to contain \
               the body, which is decided exactly. The law of Lemma 5.5 has an experiment of its own, as its patches \
               take the counts of grids alone.",
    claims: &["lemma-5.5", "ball-approximation", "zonoid-approximation", "variable-complexity"],
    families: FAMILIES,
    sizes: PerProfile { quick: &[16, 32, 64, 128, 256], full: &[16, 25, 32, 45, 64, 90, 128, 181, 256] },
    instances: PerProfile { quick: 1, full: 2 },
    variants: &[
        variant("lemma_5_5", "Lemma 5.5: patches of directions"),
        variant("cluster", "Fitted cluster sums"),
        variant("girard", "Girard"),
        variant("combastel", "Combastel"),
        variant("pca", "Principal axes"),
        variant("scott", "Scott"),
        variant("adaptive", "Adaptive"),
    ],
    measure,
    fits: &[
        falling("lemma_5_5"),
        falling("cluster").within(Bound::own(GrowthModel::Inverse)),
        falling("girard"),
        falling("combastel"),
        falling("pca"),
        falling("scott"),
        falling("adaptive"),
    ],
    ..Experiment::COUNTED
};

const fn variant(id: &'static str, title: &'static str) -> Variant {
    Variant::at_all_sizes(id, title)
}

const fn falling(variant: &'static str) -> FitPlan {
    FitPlan::new(Quantity::Value("error"), variant, FAMILIES, GrowthModel::FALLING)
}

/// Shared with the experiment on the lemma alone.
pub(super) fn measure(case: &Case) -> Result<Measurement, String> {
    let method = Method::from_id(case.variant).ok_or_else(|| format!("no rule is called {}", case.variant))?;
    let generators = case.body_family()?.generate(GENERATORS, case.instance_seed);
    let body = Zonotope::new([0.0; 3], generators).map_err(|error| error.to_string())?;
    let point = Zonotope::new([0.0; 3], Vec::new()).map_err(|error| error.to_string())?;
    let problem = Problem::new(&body, case.n).map_err(|error| error.to_string())?;
    let reduced = method.reduce(&problem).map_err(|error| error.to_string())?.body;
    let (distance, diameter) = (excess(&reduced, &body, WIDTH), 2.0 * excess(&body, &point, WIDTH).lower);
    let contained = match contains(&reduced, &body) {
        Some(true) => Ok(()),
        Some(false) => Err("it does not contain the body"),
        None => Err("whether it contains the body is too much to decide"),
    };
    let verdict = Verdict::of_check("containment, decided exactly", contained);
    let digest = Digest::default().floats(reduced.generators().as_flattened()).finish();
    Ok(Measurement::new(&OperationCounts::default(), digest, verdict)
        .with_value("generators", reduced.generators().len() as f64)
        .with_value("error", distance.upper / diameter)
        .with_value("error_from_below", distance.lower / diameter))
}
