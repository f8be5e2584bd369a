//! Operations and time of each collision method against the number of generators.

use super::{BODY_SIZES, PRUNED_BODIES, TIMED_BODY_SIZES, collision_methods};
use crate::definition::{
    Bound, Case, Experiment, FitPlan, Measurement, PerProfile, Quantity, TimedWork, Timing, Variant, Verdict,
};
use crate::fit::GrowthModel;
use zonotope::tally::OperationCounts;

const FAMILIES: &[&str] = &["random_bodies", "heavy_tailed_bodies", "lattice_bodies", "near_plane_bodies"];

/// Operations and time of each collision method against the number of generators.
pub const EXPERIMENT: Experiment = Experiment {
    id: "collision-scaling",
    title: "Collision: growth with the number of generators",
    question: "How do operations and time of each method grow with the number of generators, on bodies whose facets \
               have four sides and on bodies with parallel, coplanar and uneven generators? The instances are just \
               inside, with certified gaps of 1e-3, 1e-6, 1e-9 and 1e-12, so that no method can end early; each \
               status is compared with the question's construction, and each proof is checked. `passes` are the reads \
               of the kernel over the number of generators, from the size on at which it prunes: smaller bodies are \
               evaluated at once, so that its operations have no law across both. Beside the exact methods stand our \
               own GJK and the feasibility programs of two engines, which compute in floating point.",
    claims: &["theorem-5.2", "lemma-5.1", "summary-intersection"],
    families: FAMILIES,
    sizes: BODY_SIZES,
    instances: PerProfile { quick: 16, full: 4 },
    variants: &[
        Variant::at_all_sizes("by_lad", "Kernel: exact gauge"),
        Variant {
            id: "by_slope_selection",
            title: "Theorem 5.2: the paper's search",
            largest: PerProfile { quick: 1 << 10, full: 1 << 14 },
        },
        Variant {
            id: "by_explicit_faces",
            title: "Explicit faces",
            largest: PerProfile { quick: 1 << 8, full: 1 << 10 },
        },
        Variant::at_all_sizes("by_gjk", "Our GJK in floating point"),
        Variant {
            id: "clarabel",
            title: "Feasibility by clarabel",
            largest: PerProfile { quick: 1 << 10, full: 1 << 12 },
        },
        Variant {
            id: "microlp",
            title: "Feasibility by microlp",
            largest: PerProfile { quick: 1 << 10, full: 1 << 12 },
        },
    ],
    measure,
    timing: Some(Timing { sizes: TIMED_BODY_SIZES, repetitions: PerProfile::both(3), prepare }),
    fits: &[
        FitPlan::new(Quantity::Value("passes"), "by_lad", FAMILIES, GrowthModel::ALL)
            .within(Bound::own(GrowthModel::Constant))
            .at_least(GrowthModel::Constant)
            .from(PRUNED_BODIES),
        FitPlan::of_operations("by_slope_selection", FAMILIES)
            .within(Bound::of_paper(GrowthModel::LinearLogSquared, "Theorem 5.2"))
            .at_least(GrowthModel::Linear),
        FitPlan::of_operations("by_explicit_faces", FAMILIES).within(Bound::own(GrowthModel::Quadratic)),
    ],
    ..Experiment::COUNTED
};

fn measure(case: &Case) -> Result<Measurement, String> {
    let question = collision_methods::question(case, collision_methods::JUST_INSIDE)?;
    let mut counts = OperationCounts::default();
    if collision_methods::is_rounded(case.variant) {
        let answer = collision_methods::guess(case.variant, &question.displacement(), case.seed, &mut counts)?;
        let verdict =
            Verdict::Unchecked("in floating point: what it gets wrong is counted in wrong-answers".to_owned());
        return Ok(Measurement::new(&counts, answer.map_or(2, u64::from), verdict));
    }
    let reply = collision_methods::ask(case.variant, &question.displacement(), case.seed, &mut counts)?;
    let measurement = Measurement::new(&counts, reply.digest(), reply.verdict(&question))
        .with_value("passes", collision_methods::passes(&counts, case.n));
    Ok(match reply.gauge {
        Some(gauge) => measurement.with_value("gauge", gauge),
        None => measurement,
    })
}

fn prepare(case: &Case) -> Result<TimedWork, String> {
    let question = collision_methods::question(case, collision_methods::JUST_INSIDE)?;
    let (variant, seed) = (case.variant, case.seed);
    Ok(Box::new(move |stopwatch| {
        let displacement = question.displacement();
        if collision_methods::is_rounded(variant) {
            let answer = stopwatch.lap("total", || collision_methods::guess(variant, &displacement, seed, &mut ()))?;
            return Ok(answer.map_or(2, u64::from));
        }
        let reply = stopwatch.lap("total", || collision_methods::ask(variant, &displacement, seed, &mut ()))?;
        Ok(reply.digest())
    }))
}
