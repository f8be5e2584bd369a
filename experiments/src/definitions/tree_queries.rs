//! The reads of a query to a tree over directions, against the number of generators.

use super::PRUNED_BODY_SIZES;
use super::collision_methods::{PROVED, checked, passes};
use super::repeated_queries::questions;
use crate::definition::{Bound, Case, Experiment, FitPlan, Measurement, PerProfile, Quantity, Variant, Verdict};
use crate::fit::GrowthModel;
use crate::seed::Digest;
use zonotope::collision::by_lad;
use zonotope::collision::prepared::DirectionTree;
use zonotope::tally::OperationCounts;
use zonotope::zonotope::Zonotope;

const FAMILIES: &[&str] = &["random_bodies", "heavy_tailed_bodies", "polar_bodies", "near_plane_bodies"];

/// The reads of a query to a tree over directions, against the number of generators.
pub const EXPERIMENT: Experiment = Experiment {
    id: "direction-tree-queries",
    title: "Repeated queries: a tree over directions",
    question: "What does a query read to a tree over the directions of the generators, of a body that stays and is \
               asked about again and again, and what does the kernel read without a tree? `reads` a query are nodes \
               and generators. Each answer is compared with the question's construction, and its proof is checked.",
    claims: &["corollary-5.4"],
    families: FAMILIES,
    sizes: PRUNED_BODY_SIZES,
    instances: PerProfile { quick: 4, full: 2 },
    variants: &[
        Variant::at_all_sizes("by_direction_tree", "Tree over directions"),
        Variant::at_all_sizes("by_lad", "Kernel without a tree"),
    ],
    measure,
    fits: &[
        FitPlan::new(Quantity::Value("reads"), "by_direction_tree", FAMILIES, GrowthModel::POWERS),
        FitPlan::new(Quantity::Value("passes"), "by_lad", FAMILIES, GrowthModel::ALL)
            .within(Bound::own(GrowthModel::Constant))
            .at_least(GrowthModel::Constant),
    ],
    ..Experiment::COUNTED
};

fn measure(case: &Case) -> Result<Measurement, String> {
    let generators = case.body()?;
    let body = Zonotope::new([0.0; 3], generators.clone()).map_err(|error| error.to_string())?;
    let tree = (case.variant == "by_direction_tree").then(|| DirectionTree::new(&body));
    let mut counts = OperationCounts::default();
    let (mut digest, mut verdict, mut asked) = (Digest::default(), Verdict::Correct(PROVED.to_owned()), 0);
    for question in questions(&generators, case.instance_seed) {
        let (value, location) = match &tree {
            Some(tree) => {
                let measured = tree.gauge(question.to, &mut counts).map_err(|error| error.to_string())?;
                (measured.value, measured.location.expand())
            }
            None => {
                let gauge = by_lad::gauge(&question.displacement(), &mut counts);
                (gauge.value, gauge.location)
            }
        };
        digest = digest.floats(&[value]).bytes(location.status().name().as_bytes());
        asked += 1;
        verdict = verdict.and(checked(&question, &location));
    }
    let passes = passes(&counts, case.n) / f64::from(asked.max(1));
    let measurement = Measurement::new(&counts, digest.finish(), verdict)
        .with_value("reads", passes * case.n as f64)
        .with_value("passes", passes);
    Ok(match &tree {
        Some(tree) => measurement.with_value("bytes", tree.bytes() as f64),
        None => measurement,
    })
}
