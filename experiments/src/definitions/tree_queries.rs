//! What a query to a tree over directions reads, against the number of generators.

use super::collision_methods::{PROVED, checked};
use super::repeated_queries::questions;
use crate::definition::{Case, Experiment, FitPlan, Measurement, PerProfile, Quantity, Tabulated, Variant, Verdict};
use crate::fit::GrowthModel;
use crate::seed::Digest;
use zonotope::collision::by_lad;
use zonotope::collision::prepared::DirectionTree;
use zonotope::tally::{Operation, OperationCounts};
use zonotope::zonotope::Zonotope;

const FAMILIES: &[&str] = &["random_bodies", "heavy_tailed_bodies", "polar_bodies", "near_plane_bodies"];

/// What a query to a tree over directions reads, against the number of generators.
pub const EXPERIMENT: Experiment = Experiment {
    id: "direction-tree-queries",
    title: "Repeated queries: a tree over directions",
    question: "What does a query read to a tree over the directions of the generators, of a body that stays and is \
               asked about again and again, and what does the kernel read without a tree? `reads` a query are nodes \
               and generators. Each answer is compared with the question's construction, and its proof is checked.",
    claims: &["corollary-5.4"],
    families: FAMILIES,
    real_inputs: &[],
    sizes: PerProfile {
        quick: &[1 << 10, 1 << 11, 1 << 12, 1 << 13, 1 << 14],
        full: &[1 << 10, 1 << 12, 1 << 14, 1 << 16, 1 << 18, 1 << 20],
    },
    instances: PerProfile { quick: 1, full: 2 },
    variants: &[
        Variant { id: "by_direction_tree", title: "Tree over directions", largest: PerProfile::both(usize::MAX) },
        Variant { id: "by_lad", title: "Kernel without a tree", largest: PerProfile::both(usize::MAX) },
    ],
    measure,
    table: Tabulated::MedianAtLargest,
    timing: None,
    fits: &[
        FitPlan {
            quantity: Quantity::Value("reads"),
            variant: "by_direction_tree",
            families: FAMILIES,
            models: GrowthModel::POWERS,
            bound: None,
        },
        FitPlan {
            quantity: Quantity::Value("reads"),
            variant: "by_lad",
            families: FAMILIES,
            models: GrowthModel::ALL,
            bound: Some(GrowthModel::Linear),
        },
    ],
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
                let measured = tree.gauge_counted(question.to, &mut counts).map_err(|error| error.to_string())?;
                (measured.value, measured.location.expand())
            }
            None => {
                let gauge = by_lad::gauge_counted(&question.displacement(), &mut counts);
                (gauge.value, gauge.location)
            }
        };
        digest = digest.floats(&[value]).bytes(location.status().name().as_bytes());
        asked += 1;
        verdict = verdict.and(checked(&question, &location));
    }
    let read = [Operation::GeneratorRead, Operation::LineEvaluation, Operation::PartEvaluation];
    let reads = read.map(|operation| counts.get(operation)).iter().sum::<u64>() as f64 / f64::from(asked.max(1));
    let measurement = Measurement::new(&counts, digest.finish(), verdict)
        .with_value("reads", reads)
        .with_value("passes", reads / case.n as f64);
    Ok(match &tree {
        Some(tree) => measurement.with_value("bytes", tree.bytes() as f64),
        None => measurement,
    })
}
