//! Swept volumes: the operations of Theorem 6.1 against the number of generators, and the excess of each volume as the
//! time step shrinks.

use crate::definition::{Bound, Case, Experiment, FitPlan, Measurement, PerProfile, Quantity, Variant, Verdict};
use crate::fit::GrowthModel;
use crate::moving::swept::Placements;
use crate::seed::Digest;
use std::f64::consts::{FRAC_PI_2, TAU};
use zonotope::motion::space_time::brute_force::holds_placement;
use zonotope::motion::space_time::{Method, Sweep, by_farthest_vertex};
use zonotope::tally::OperationCounts;
use zonotope::zonotope::{Zonotope, combinatorics};

use super::LINEAR_SIZES;

const FAMILIES: &[&str] = &["random_bodies", "polar_bodies", "heavy_tailed_bodies"];

/// Generators of the bodies whose volumes are measured.
const GENERATORS: usize = 5;

/// Directions of the plane by which the farthest vertex is checked.
const DIRECTIONS: u32 = 256;

/// The operations of Theorem 6.1 against the number of generators.
pub const OPERATIONS: Experiment = Experiment {
    id: "space-time-scaling",
    title: "Theorem 6.1: operations against the number of generators",
    question: "What does the volume of Theorem 6.1 cost for a body of n generators that turns about an axis and \
               translates? Operations are generators that are read, for their projection and along the boundary of \
               the projected zonogon, and comparisons that sort them. The square is held to the support function \
               along 256 directions orthogonal to the axis.",
    claims: &["theorem-6.1", "farthest-vertex-from-axis"],
    families: FAMILIES,
    sizes: LINEAR_SIZES,
    instances: PerProfile { quick: 3, full: 5 },
    variants: &[Variant::at_all_sizes("by_farthest_vertex", "Theorem 6.1")],
    measure: measure_operations,
    fits: &[FitPlan::of_operations("by_farthest_vertex", FAMILIES)
        .within(Bound::of_paper(GrowthModel::Linearithmic, "Theorem 6.1"))
        .at_least(GrowthModel::Linear)],
    ..Experiment::COUNTED
};

/// The excess of each volume as the time step shrinks.
pub const EXCESS: Experiment = Experiment {
    id: "swept-excess",
    title: "Swept volumes: the excess as the time step shrinks",
    question: "By what part does the volume of each zonotope around a sweep exceed that of the convex hull of sampled \
               placements, as the time step shrinks? A body of 5 generators turns about an axis whose distance \
               from its centre is the sum of its generators' lengths; n is the number of steps of a quarter turn. \
               Placements are held to each volume exactly.",
    claims: &["theorem-6.1"],
    families: FAMILIES,
    sizes: PerProfile::both(&[2, 4, 8, 16, 32, 64, 128]),
    instances: PerProfile { quick: 3, full: 8 },
    variants: &[
        Variant::at_all_sizes("by_farthest_vertex", "Theorem 6.1"),
        Variant::at_all_sizes("by_middle_placement", "From the middle placement"),
        Variant::at_all_sizes("by_least_rectangle", "Least rectangle"),
        Variant::at_all_sizes("by_least_zonogon", "Least zonogon"),
        Variant::at_all_sizes("by_shadow", "Shadow of the body"),
        Variant::at_all_sizes("by_turned_generators", "Turned generators"),
    ],
    measure: measure_excess,
    fits: &[
        FitPlan::new(Quantity::Value("excess"), "by_farthest_vertex", FAMILIES, GrowthModel::FALLING),
        FitPlan::new(Quantity::Value("excess"), "by_middle_placement", FAMILIES, GrowthModel::FALLING),
        FitPlan::new(Quantity::Value("excess"), "by_least_zonogon", FAMILIES, GrowthModel::FALLING),
        FitPlan::new(Quantity::Value("excess"), "by_turned_generators", FAMILIES, GrowthModel::FALLING),
    ],
    ..Experiment::COUNTED
};

/// A body of so many generators whose centre is as far from the z axis as they are long together.
fn body(case: &Case, generators: usize) -> Result<Zonotope<3>, String> {
    let generators = case.body_family()?.generate(generators, case.instance_seed);
    let length = |g: &[f64; 3]| g.iter().map(|c| c * c).sum::<f64>().sqrt();
    let away = generators.iter().map(length).sum();
    Zonotope::new([away, 0.0, 0.0], generators).map_err(|error| error.to_string())
}

fn measure_operations(case: &Case) -> Result<Measurement, String> {
    let body = body(case, case.n)?;
    let angle = 1.0_f64;
    let sweep = Sweep::new([0.0; 3], [0.0, 0.0, 1.0], angle, [1.0, 2.0, 3.0]).map_err(|error| error.to_string())?;
    let mut counts = OperationCounts::default();
    let volume = by_farthest_vertex::volume(&sweep, &body, &mut counts).map_err(|error| error.to_string())?;
    let center = body.center();
    let reach = |i: u32| {
        let (sine, cosine) = libm::sincos(TAU * f64::from(i) / f64::from(DIRECTIONS));
        let along = |v: &[f64; 3]| cosine * v[0] + sine * v[1];
        body.generators().iter().fold(along(&center), |sum, g| sum + along(g).abs())
    };
    let low = (0..DIRECTIONS).map(reach).fold(0.0, f64::max) * 2.0 * libm::sin(angle / 2.0);
    let high = low / libm::cos(TAU / f64::from(2 * DIRECTIONS));
    // the two sides of the square follow the body's generators and half the translation
    let side = |g: &[f64; 3]| (g[0] * g[0] + g[1] * g[1]).sqrt();
    let added = &volume.generators()[body.generators().len()..];
    let sides = added.iter().filter(|g| g[2] == 0.0).map(side);
    let is_radius = |side: f64| (low * (1.0 - 1e-9)..=high * (1.0 + 1e-9)).contains(&side);
    let verdict = match sides.filter(|&side| is_radius(side)).count() {
        2 => Verdict::Correct("support function".to_owned()),
        found => Verdict::Wrong(format!("{found} sides of the square are between {low} and {high}")),
    };
    Ok(Measurement::new(&counts, Digest::default().floats(added.as_flattened()).finish(), verdict))
}

fn measure_excess(case: &Case) -> Result<Measurement, String> {
    let body = body(case, GENERATORS)?;
    let angle = FRAC_PI_2 / case.n as f64;
    let sweep = Sweep::new([0.0; 3], [0.0, 0.0, 1.0], angle, [0.0; 3]).map_err(|error| error.to_string())?;
    let method = Method::from_id(case.variant).ok_or_else(|| format!("no method is called {}", case.variant))?;
    let volume = body.swept_by(&sweep, method).map_err(|error| error.to_string())?;
    let hull = Placements::of(&body, &sweep).hull_volume().ok_or("a body in general position is not flat")?;
    let measure = combinatorics(&volume).measure.to_f64_fast();
    // half the angle of a placement has this tangent, the last one less than the whole by more than rounding
    let tangents = [0.0, 0.3, 0.7, 1.0 - 1e-9].map(|part: f64| libm::tan(part * angle / 2.0));
    let is_held = |t: f64| holds_placement(&volume, &sweep, &body, t, 0.0);
    let verdict = match tangents.into_iter().find(|&t| !is_held(t)) {
        None => Verdict::Correct("exact placements".to_owned()),
        Some(t) => Verdict::Wrong(format!("the placement by twice the angle of tangent {t} is outside")),
    };
    let digest = Digest::default().floats(volume.generators().as_flattened()).finish();
    Ok(Measurement::new(&OperationCounts::default(), digest, verdict).with_value("excess", measure / hull - 1.0))
}
