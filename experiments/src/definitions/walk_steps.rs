//! The cost of a step from facet to facet, against the number of generators.

use crate::definition::{
    Bound, Case, Experiment, FitPlan, Measurement, PerProfile, Quantity, TimedWork, Timing, Variant, Verdict,
};
use crate::fit::GrowthModel;
use crate::seed::Digest;
use zonotope::arrangement::facet_walk::{FacetName, FacetWalk, HullWalk, Method, ScanWalk, WalkError};
use zonotope::tally::OperationCounts;

/// Steps of each walk.
const STEPS: usize = 1000;

const FAMILIES: &[&str] = &["random_bodies", "polar_bodies", "heavy_tailed_bodies"];

const SIZES: PerProfile<&[usize]> = PerProfile {
    quick: &[1 << 6, 1 << 8, 1 << 10, 1 << 11, 1 << 12, 1 << 13, 1 << 14],
    full: &[1 << 6, 1 << 8, 1 << 10, 1 << 12, 1 << 13, 1 << 14, 1 << 15, 1 << 16],
};

/// The cost of a step from facet to facet, against the number of generators.
pub const EXPERIMENT: Experiment = Experiment {
    id: "walk-steps",
    title: "Walking from facet to facet: time of a step",
    question: "What does a step from facet to facet cost, by dynamic hulls and by a pass over the generators? There \
               are 1,000 steps over the boundary, across edges that lead on and around the body; `bytes` are what \
               the hulls hold. The facets that the walks of both methods visit are compared.",
    claims: &["lemma-5.6"],
    families: FAMILIES,
    sizes: SIZES,
    instances: PerProfile::both(1),
    variants: &[
        Variant::at_all_sizes("by_dynamic_hull", "Dynamic hulls"),
        Variant::at_all_sizes("by_scan", "A pass over the generators"),
    ],
    measure,
    timing: Some(Timing { sizes: SIZES, repetitions: PerProfile::both(3), prepare }),
    fits: &[
        FitPlan::new(
            Quantity::Time("walk"),
            "by_dynamic_hull",
            FAMILIES,
            &[GrowthModel::Constant, GrowthModel::LogSquared, GrowthModel::SquareRoot, GrowthModel::Linear],
        )
        // A clock sees caches as well: the lemma's bound is held to counts of orientation tests by its claim.
        .within(Bound::own(GrowthModel::LogSquared)),
        FitPlan::new(Quantity::Time("walk"), "by_scan", FAMILIES, GrowthModel::ALL)
            .within(Bound::own(GrowthModel::Linear)),
        FitPlan::of_operations("by_dynamic_hull", FAMILIES)
            .of(Quantity::Value("bytes"))
            .within(Bound::of_paper(GrowthModel::Linear, "Lemma 5.6"))
            .at_least(GrowthModel::Linear),
    ],
    ..Experiment::COUNTED
};

/// A walk that goes straight on: across the edge opposite to that by which it came, but every seventh time across the
/// next one. So it goes around the body and does not stay on one belt of facets.
fn walked(walk: &mut dyn FacetWalk) -> Result<Digest, WalkError> {
    let mut digest = Digest::default();
    let mut came_by = walk.edges()[0];
    for step in 0..STEPS {
        let edges = walk.edges();
        let back = edges.iter().position(|edge| edge.generator == came_by.generator && *edge != came_by).unwrap_or(0);
        let turned = usize::from(step % 7 == 6);
        let edge = (back + edges.len() / 2 + turned) % edges.len();
        came_by = edges[edge];
        walk.step(edge)?;
        digest = named(digest, walk.facet());
    }
    Ok(digest)
}

fn named(digest: Digest, facet: FacetName) -> Digest {
    [facet.first as u64, facet.second as u64, facet.normal.sign() as u64].into_iter().fold(digest, Digest::word)
}

fn measure(case: &Case) -> Result<Measurement, String> {
    let generators = case.body()?;
    let found = |error: WalkError| error.to_string();
    let mut hulls = HullWalk::new(&generators).map_err(found)?;
    let mut scan = ScanWalk::new(&generators).map_err(found)?;
    let [by_hulls, by_scan] = [walked(&mut hulls).map_err(found)?.finish(), walked(&mut scan).map_err(found)?.finish()];
    let agreed = if by_hulls == by_scan { Ok(()) } else { Err("the methods visit different facets") };
    let verdict = Verdict::of_check("the facets of the other method", agreed);
    let measurement = Measurement::new(&OperationCounts::default(), by_hulls, verdict);
    Ok(match case.variant {
        "by_dynamic_hull" => measurement.with_value("bytes", hulls.bytes() as f64),
        _ => measurement,
    })
}

fn prepare(case: &Case) -> Result<TimedWork, String> {
    let generators = case.body()?;
    let method = Method::from_id(case.variant).ok_or_else(|| format!("no walk is called {}", case.variant))?;
    Ok(Box::new(move |stopwatch| {
        let mut walk = method.walk(&generators).map_err(|error| error.to_string())?;
        let digest = stopwatch.lap("walk", || walked(walk.as_mut())).map_err(|error| error.to_string())?;
        Ok(digest.finish())
    }))
}
