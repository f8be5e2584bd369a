//! The depth to which two nested hierarchies are descended, against the gap between the bodies.

use super::collision_methods::PROVED;
use crate::definition::{Bound, Case, Experiment, FitPlan, Measurement, PerProfile, Quantity, Variant, Verdict};
use crate::fit::GrowthModel;
use crate::seed::{self, Digest};
use families::source::RandomSource;
use zonotope::collision::hierarchy::Hierarchy;
use zonotope::collision::{Query, Status};
use zonotope::interop::verifier::check_location;
use zonotope::tally::OperationCounts;
use zonotope::zonotope::Zonotope;
use zonotope::zonotope::pose::Pose;

/// Generators of each of the two bodies.
const GENERATORS: usize = 4096;

/// Directions in which one body is moved, for each instance.
const DIRECTIONS: usize = 6;

const FAMILIES: &[&str] = &["random_bodies", "heavy_tailed_bodies", "near_plane_bodies"];

/// The depth to which two nested hierarchies are descended, against the gap between the bodies.
pub const EXPERIMENT: Experiment = Experiment {
    id: "hierarchy-levels",
    title: "Hierarchical method: levels against the gap between the bodies",
    question: "How far are two nested hierarchies descended, against the gap between the bodies? Two bodies of 4,096 \
               generators; n is 1/g where one is moved, from the distance at which they touch, by the part g of it, \
               apart or into the other. `visited` are pairs of levels, `reads` the generators that the kernel reads, \
               `share_read` their part of all. Each status is compared with the construction, and each proof is one \
               about the bodies themselves.",
    claims: &["summary-repeated-tests", "variable-complexity"],
    families: FAMILIES,
    sizes: PerProfile {
        quick: &[2, 8, 32, 128, 256, 512, 1024, 2048],
        full: &[2, 4, 8, 16, 32, 64, 128, 256, 512, 1024, 2048, 4096, 8192, 16384, 32768],
    },
    instances: PerProfile { quick: 2, full: 4 },
    variants: &[
        Variant::at_all_sizes("apart", "Bodies apart"),
        Variant::at_all_sizes("overlapping", "Bodies that overlap"),
    ],
    measure,
    fits: &[reads("apart"), reads("overlapping")],
    ..Experiment::COUNTED
};

const fn reads(variant: &'static str) -> FitPlan {
    FitPlan::new(Quantity::Value("reads"), variant, FAMILIES, GrowthModel::POWERS)
        .within(Bound::own(GrowthModel::Linear))
}

fn measure(case: &Case) -> Result<Measurement, String> {
    let body = |part: &str| {
        let generators = case.body_family()?.generate(GENERATORS, seed::seed_of(case.instance_seed, part));
        Zonotope::new([0.0; 3], generators).map_err(|error| error.to_string())
    };
    let (fixed, moving) = (body("fixed")?, body("moving")?);
    let sum = fixed.minkowski_sum_with_reflection(&moving).map_err(|error| error.to_string())?;
    let [first, second] = [&fixed, &moving].map(|body| Hierarchy::new(body.clone()));
    let still = Pose::from_translation([0.0; 3]).map_err(|error| error.to_string())?;
    let mut random = RandomSource::new(case.instance_seed);
    let is_apart = case.variant == "apart";
    let gap = 1.0 / case.n as f64;
    let factor = if is_apart { 1.0 + gap } else { 1.0 - gap };
    let mut counts = OperationCounts::default();
    let (mut digest, mut verdict) = (Digest::default(), Verdict::Correct(PROVED.to_owned()));
    let (mut visited, mut reads) = (0, 0);
    for _ in 0..DIRECTIONS {
        let direction = [0; 3].map(|_| random.signed_unit());
        let translation = sum.support(direction).point().map(|c| factor * c);
        let pose = Pose::from_translation(translation).map_err(|error| error.to_string())?;
        let descent = first.at(&still).intersection(&second.at(&pose), &mut counts);
        visited += descent.visited();
        reads += descent.generators_read();
        digest = digest.bytes(descent.status().name().as_bytes()).word(descent.generators_read());
        let moved = moving.translated(translation).map_err(|error| error.to_string())?;
        let is_right = descent.status() == if is_apart { Status::Outside } else { Status::Inside };
        verdict = verdict.and(match is_right {
            true => Verdict::of_verifier(PROVED, check_location(&Query::between(&fixed, &moved), &descent.location())),
            false => Verdict::Wrong(format!("{}, moved by {translation:?}", descent.status().name())),
        });
    }
    let mean = |total: f64| total / DIRECTIONS as f64;
    Ok(Measurement::new(&counts, digest.finish(), verdict)
        .with_value("visited", mean(f64::from(visited)))
        .with_value("levels", first.level_count() as f64)
        .with_value("reads", mean(reads as f64))
        .with_value("share_read", mean(reads as f64) / (2 * GENERATORS) as f64))
}
