//! Operations and time of each collision method against the number of generators.

use super::{BODY_SIZES, collision_methods};
use crate::definition::{Case, Experiment, FitPlan, Measurement, PerProfile, TimedWork, Timing, Variant};
use crate::fit::GrowthModel;
use zonotope::tally::OperationCounts;

const FAMILIES: &[&str] = &["random_bodies", "heavy_tailed_bodies", "lattice_bodies", "near_plane_bodies"];

/// Operations and time of each collision method against the number of generators.
pub const EXPERIMENT: Experiment = Experiment {
    id: "collision-scaling",
    title: "Collision: growth with the number of generators",
    question: "The exact gauge by the kernel grows like n, on bodies whose facets have four sides and on bodies with parallel, coplanar \
               and very uneven generators. The instances alternate between near contact (certified gap 1e-9, both sides) and clear \
               cases; every status agrees with the question's construction, and every proof is checked.",
    claims: &["theorem-5.2", "lemma-5.1", "summary-intersection"],
    families: FAMILIES,
    real_inputs: &[],
    sizes: BODY_SIZES,
    instances: PerProfile::both(4),
    variants: &[Variant { id: "by_lad", title: "Kernel: exact gauge", largest: PerProfile::both(usize::MAX) }],
    measure,
    timing: Some(Timing { sizes: BODY_SIZES, repetitions: PerProfile::both(3), prepare }),
    fits: &[FitPlan::of_operations("by_lad", FAMILIES, Some(GrowthModel::Linear))],
};

fn measure(case: &Case) -> Result<Measurement, String> {
    let question = collision_methods::question(case)?;
    let mut counts = OperationCounts::default();
    let reply = collision_methods::ask(case.variant, &question.displacement(), &mut counts)?;
    let measurement = Measurement::new(&counts, reply.digest(), reply.verdict(&question));
    Ok(match reply.gauge {
        Some(gauge) => measurement.with_value("gauge", gauge),
        None => measurement,
    })
}

fn prepare(case: &Case) -> Result<TimedWork, String> {
    let question = collision_methods::question(case)?;
    let variant = case.variant;
    Ok(Box::new(move |stopwatch| {
        let displacement = question.displacement();
        let reply = stopwatch.lap("total", || collision_methods::ask(variant, &displacement, &mut ()))?;
        Ok(reply.digest())
    }))
}
