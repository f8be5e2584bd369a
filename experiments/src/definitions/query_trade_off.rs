//! The cost of a query against the space of the structure of Lemma 5.3.

use super::collision_methods::{PROVED, checked};
use super::repeated_queries::questions;
use crate::definition::{Bound, Case, Experiment, FitPlan, Measurement, PerProfile, Quantity, Variant, Verdict};
use crate::fit::GrowthModel;
use crate::seed::Digest;
use zonotope::collision::prepared::by_cutting::PreparedByCutting;
use zonotope::tally::{Operation, OperationCounts};
use zonotope::zonotope::Zonotope;

/// Generators of each body.
pub const GENERATORS: usize = 1024;

const FAMILIES: &[&str] = &["random_bodies", "heavy_tailed_bodies", "near_plane_bodies"];

/// The cost of a query against the space of the structure of Lemma 5.3.
pub const EXPERIMENT: Experiment = Experiment {
    id: "query-trade-off",
    title: "Repeated queries: time against space",
    question: "What does a query cost against the space of its structure? n is the space m that Lemma 5.3 is given, \
               from as many units as the body has generators (1,024) up. A query finds a trapezoid of the cutting \
               and reads the generators that cross it, `in_trapezoid`, which is the second step of the lemma's proof; \
               `to_find_it` are steps, comparisons and lines looked at to find the trapezoid, and the optimum in it. \
               `operations` are the sum of both, `share_of_bound` their part of (n^2 / m) log^2 n, and `bytes_a_unit` \
               the bytes over m. The bound of the whole query is judged by query-growth, for several n. Each \
               answer is compared with the question's construction, and its proof is checked.",
    claims: &["lemma-5.3", "corollary-5.4"],
    families: FAMILIES,
    sizes: PerProfile {
        quick: &[1 << 10, 1 << 11, 1 << 12, 1 << 13, 1 << 14, 1 << 15, 1 << 16],
        full: &[1 << 10, 1 << 11, 1 << 12, 1 << 13, 1 << 14, 1 << 15, 1 << 16, 1 << 17, 1 << 18, 1 << 19, 1 << 20],
    },
    instances: PerProfile { quick: 2, full: 4 },
    variants: &[Variant::at_all_sizes("by_cutting", "Cutting of the dual plane")],
    measure,
    fits: &[falling("in_trapezoid").within(Bound::own(GrowthModel::Inverse)), falling("operations")],
    ..Experiment::COUNTED
};

const fn falling(value: &'static str) -> FitPlan {
    FitPlan::new(Quantity::Value(value), "by_cutting", FAMILIES, GrowthModel::FALLING)
}

fn measure(case: &Case) -> Result<Measurement, String> {
    measure_with(case, GENERATORS, case.n as u64)
}

/// The questions of a case about a body of some generators, to a structure of some space.
pub(super) fn measure_with(case: &Case, generators: usize, space: u64) -> Result<Measurement, String> {
    let n = generators as f64;
    let generators = case.body_family()?.generate(generators, case.instance_seed);
    let body = Zonotope::new([0.0; 3], generators.clone()).map_err(|error| error.to_string())?;
    let prepared = PreparedByCutting::new(body, space, case.seed, &mut ()).map_err(|error| error.to_string())?;
    let mut counts = OperationCounts::default();
    let (mut digest, mut verdict, mut asked) = (Digest::default(), Verdict::Correct(PROVED.to_owned()), 0);
    for question in questions(&generators, case.instance_seed) {
        let facet = prepared.facet(question.to, &mut counts).map_err(|error| error.to_string())?;
        digest = digest.floats(&[facet.value().0]).bytes(facet.status().name().as_bytes());
        asked += 1;
        let location = prepared.locate(question.to).map_err(|error| error.to_string())?;
        verdict = verdict.and(checked(&question, &location));
    }
    let mean = |operations: &[Operation]| {
        operations.iter().map(|&operation| counts.get(operation)).sum::<u64>() as f64 / f64::from(asked.max(1))
    };
    let to_find_it = mean(&[Operation::SearchStep, Operation::Comparison, Operation::LineEvaluation]);
    let in_trapezoid = mean(&[Operation::GeneratorRead, Operation::PartEvaluation]);
    let bound = n * n / space as f64 * libm::log2(n) * libm::log2(n);
    Ok(Measurement::new(&counts, digest.finish(), verdict)
        .with_value("to_find_it", to_find_it)
        .with_value("in_trapezoid", in_trapezoid)
        .with_value("operations", to_find_it + in_trapezoid)
        .with_value("share_of_bound", (to_find_it + in_trapezoid) / bound)
        .with_value("bytes_a_unit", prepared.bytes() as f64 / space as f64)
        .with_value("trapezoids", prepared.trapezoid_count() as f64))
}
