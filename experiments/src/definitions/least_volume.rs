//! Local optima of the volume of a zonotope around points, from many starts.

use super::few_generators::most_generators;
use crate::definition::{Case, Experiment, Measurement, PerProfile, Variant, Verdict};
use crate::seed::Digest;
use families::clouds::Cloud;
use zonotope::bvh::volumes::least_volume::local_optima;
use zonotope::enclosing::min_length_of_few;
use zonotope::hull::in_space::solid_hull;
use zonotope::tally::OperationCounts;

/// Starts of each search.
const STARTS: usize = 40;

/// The length that the volume is compared with is within this ratio of the least one.
const EPSILON: f64 = 0.01;

/// Vertices of the largest mesh that the quick profile encloses.
const QUICK_VERTICES: usize = 800;

/// The inputs of their own size: solids and meshes.
pub const INPUTS: [&str; 9] = [
    "tetrahedron",
    "octahedron",
    "icosahedron",
    "dodecahedron",
    "teapot",
    "assimp_spider",
    "assimp_wuson",
    "cgal_cow",
    "cgal_fandisk",
];

/// Local optima of the volume.
pub const EXPERIMENT: Experiment = Experiment {
    id: "least-volume",
    title: "Zonotopes of little volume: local optima",
    question: "How small is the smallest zonotope that is found around points with K generators or fewer, from 40 \
               random starts? `volume_ratio` is its volume over that of the hull, a lower bound of every volume, \
               `generators` their number in it, `near` the share of starts whose volume exceeds it by 1 % or less, \
               `worst` the largest local optimum over it, and `by_length` the volume of a short zonotope of as many \
               generators over it. Each K has starts of its own, so that a search with more generators can end in a \
               larger volume; that no zonotope is smaller is not proven.",
    claims: &["question-optimal-volume", "question-generator-count", "question-approximation-quality"],
    real_inputs: &INPUTS,
    families: &["sphere_3"],
    sizes: PerProfile { quick: &[16], full: &[16, 64] },
    instances: PerProfile { quick: 2, full: 4 },
    variants: &[
        up_to("at_most_3", "K = 3"),
        up_to("at_most_4", "K = 4"),
        up_to("at_most_5", "K = 5"),
        up_to("at_most_6", "K = 6"),
        up_to("at_most_8", "K = 8"),
        up_to("at_most_10", "K = 10"),
    ],
    measure,
    ..Experiment::COUNTED
};

const fn up_to(id: &'static str, title: &'static str) -> Variant {
    Variant { id, title, largest: PerProfile { quick: QUICK_VERTICES, full: usize::MAX } }
}

fn measure(case: &Case) -> Result<Measurement, String> {
    let Cloud::Space(points) = case.cloud()? else { return Err("only points of space are enclosed".to_owned()) };
    let most = most_generators(case.variant).ok_or("the variant has no number of generators")?;
    let hull = solid_hull(&points).map_err(|error| error.to_string())?.ok_or("the points lie in a plane")?;
    let corners: Vec<[f64; 3]> = hull.vertices().into_iter().map(|corner| points[corner]).collect();
    let optima = local_optima(&corners, most, STARTS, case.seed);
    let is_outside = optima.iter().any(|body| points.iter().any(|point| body.contains(*point) != Ok(true)));
    let volumes: Vec<f64> = optima.iter().map(|body| body.exact_volume().to_f64()).collect();
    let best = (0..optima.len()).min_by(|&i, &j| volumes[i].total_cmp(&volumes[j])).ok_or("no start led to a body")?;
    let near = volumes.iter().filter(|volume| **volume <= 1.01 * volumes[best]).count();
    let worst = volumes.iter().fold(0.0, |worst: f64, volume| worst.max(*volume));
    let short = min_length_of_few(&corners, EPSILON, most).map_err(|error| error.to_string())?;
    let verdict = match is_outside {
        true => Verdict::Wrong("a point is outside".to_owned()),
        false => Verdict::Correct("every point inside, exactly".to_owned()),
    };
    let digest = Digest::default().floats(optima[best].generators().as_flattened()).finish();
    Ok(Measurement::new(&OperationCounts::default(), digest, verdict)
        .with_value("volume_ratio", volumes[best] / hull.volume(&points))
        .with_value("generators", optima[best].generators().len() as f64)
        .with_value("near", near as f64 / STARTS as f64)
        .with_value("worst", worst / volumes[best])
        .with_value("by_length", short.body.exact_volume().to_f64() / volumes[best]))
}
