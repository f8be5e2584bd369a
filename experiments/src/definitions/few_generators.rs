//! The least length of a zonotope around a mesh with few generators.

use std::sync::OnceLock;

use crate::definition::{Case, Experiment, Measurement, PerProfile, TimedWork, Timing, Variant, Verdict};
use crate::seed::Digest;
use families::clouds::Cloud;
use zonotope::enclosing::min_total_length::{Method, MinLengthZonotope, few_generators};
use zonotope::hull::in_space::solid_hull;
use zonotope::interop::verifier::check_min_length_all_at_any_ratio;
use zonotope::tally::OperationCounts;

/// The meshes.
pub const MESHES: [&str; 5] = ["teapot", "assimp_spider", "assimp_wuson", "cgal_cow", "cgal_fandisk"];

/// The variant whose answer has as many generators as the method leaves; its bound is that of all others.
const ANY_NUMBER: &str = "any_number";

/// The lower bound of all lengths is within this ratio of the least length.
const EPSILON: f64 = 1e-3;

/// Vertices of the largest mesh that the quick profile encloses.
const QUICK_VERTICES: usize = 800;

/// The least length of a zonotope around a mesh with few generators.
pub const EXPERIMENT: Experiment = Experiment {
    id: "few-generators",
    title: "Zonotopes of few generators around meshes",
    question: "How short is the shortest zonotope that is found around a mesh with K generators or fewer? `ratio` is \
               its length over a lower bound for zonotopes of any number, proven, `excess` what the ratio exceeds \
               that of equal lengths by, and `volume_ratio` its exact volume over that of the hull. That no zonotope \
               with K generators is shorter is not proven. The first variant has the time of the bound, the others \
               have that of the search alone.",
    claims: &["question-generator-count"],
    families: &[],
    real_inputs: &MESHES,
    sizes: PerProfile::both(&[]),
    instances: PerProfile::both(1),
    variants: &[
        everywhere(ANY_NUMBER, "Any number: the bound"),
        everywhere("at_most_3", "K = 3"),
        everywhere("at_most_4", "K = 4"),
        everywhere("at_most_5", "K = 5"),
        everywhere("at_most_6", "K = 6"),
        in_full("at_most_8", "K = 8"),
        in_full("at_most_10", "K = 10"),
        in_full("at_most_12", "K = 12"),
        in_full("at_most_16", "K = 16"),
        in_full("at_most_20", "K = 20"),
    ],
    measure,
    timing: Some(Timing { sizes: PerProfile::both(&[]), repetitions: PerProfile::both(1), prepare }),
    ..Experiment::COUNTED
};

/// A variant of both profiles, of the quick one on small meshes.
const fn everywhere(id: &'static str, title: &'static str) -> Variant {
    Variant { id, title, largest: PerProfile { quick: QUICK_VERTICES, full: usize::MAX } }
}

/// A variant of the full profile.
const fn in_full(id: &'static str, title: &'static str) -> Variant {
    Variant { id, title, largest: PerProfile { quick: 0, full: usize::MAX } }
}

/// The largest number of generators in a variant; `None` where any number may be.
pub fn most_generators(variant: &str) -> Option<usize> {
    variant.strip_prefix("at_most_")?.parse().ok()
}

/// The zonotope of no bounded number of generators around each mesh, and the bound: the same for all variants.
static SHORTEST: [OnceLock<Result<MinLengthZonotope<3>, String>>; MESHES.len()] =
    [const { OnceLock::new() }; MESHES.len()];

/// The corners of the hull of a mesh, and its volume.
fn corners(case: &Case) -> Result<(Vec<[f64; 3]>, f64), String> {
    let Cloud::Space(vertices) = case.cloud()? else { return Err("only points of space are enclosed".to_owned()) };
    let hull = solid_hull(&vertices).map_err(|error| error.to_string())?.ok_or("the mesh lies in a plane")?;
    Ok((hull.vertices().into_iter().map(|corner| vertices[corner]).collect(), hull.volume(&vertices)))
}

fn bound(points: &[[f64; 3]]) -> Result<MinLengthZonotope<3>, String> {
    Method::default().solve(points, EPSILON, &mut ()).map_err(|error| error.to_string())
}

/// The answer for any number of generators, which is found once for each mesh.
fn shortest(case: &Case, points: &[[f64; 3]]) -> Result<MinLengthZonotope<3>, String> {
    match MESHES.iter().position(|mesh| *mesh == case.family) {
        Some(place) => SHORTEST[place].get_or_init(|| bound(points)).clone(),
        None => bound(points),
    }
}

fn few(points: &[[f64; 3]], shortest: MinLengthZonotope<3>, most: usize) -> Result<MinLengthZonotope<3>, String> {
    few_generators::shortest_of_few(points, shortest, EPSILON, most).map_err(|error| error.to_string())
}

fn digest(answer: &MinLengthZonotope<3>) -> u64 {
    let digest = Digest::default().floats(answer.body.generators().as_flattened());
    digest.floats(&[answer.value, answer.lower_bound]).finish()
}

fn measure(case: &Case) -> Result<Measurement, String> {
    let (points, hull_volume) = corners(case)?;
    let shortest = shortest(case, &points)?;
    let answer = match most_generators(case.variant) {
        Some(most) => few(&points, shortest, most)?,
        None => shortest,
    };
    let checked = check_min_length_all_at_any_ratio(&points, EPSILON, &answer);
    let verdict = Verdict::of_verifier("check_min_length_all_at_any_ratio", checked);
    let volume = answer.body.exact_volume().to_f64();
    Ok(Measurement::new(&OperationCounts::default(), digest(&answer), verdict)
        .with_value("generators", answer.body.generators().len() as f64)
        .with_value("ratio", answer.ratio())
        .with_value("excess", answer.ratio() - 1.0)
        .with_value("volume_ratio", volume / hull_volume))
}

fn prepare(case: &Case) -> Result<TimedWork, String> {
    let (points, _) = corners(case)?;
    let Some(most) = most_generators(case.variant) else {
        return Ok(Box::new(move |stopwatch| Ok(digest(&stopwatch.lap("total", || bound(&points))?))));
    };
    let shortest = shortest(case, &points)?;
    Ok(Box::new(move |stopwatch| {
        let shortest = shortest.clone();
        Ok(digest(&stopwatch.lap("total", || few(&points, shortest, most))?))
    }))
}
