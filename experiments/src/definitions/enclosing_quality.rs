//! The quality with which zonotopes enclose solids, random hulls and real inputs.

use crate::definition::{Case, Experiment, Measurement, PerProfile, Variant, Verdict};
use crate::seed::Digest;
use families::clouds::Cloud;
use zonotope::collision::{Query, by_lad, by_lad_in_r4};
use zonotope::enclosing::min_total_length::{Method, MinLengthZonotope, few_generators};
use zonotope::hull::in_space::solid_hull;
use zonotope::tally::OperationCounts;
use zonotope::zonotope::{Zonotope, combinatorics};

/// The quality with which zonotopes enclose solids, random hulls and real inputs.
pub const EXPERIMENT: Experiment = Experiment {
    id: "enclosing-quality",
    title: "How well zonotopes enclose: solids, random hulls, meshes, flowers",
    question: "How much longer and larger than necessary are zonotopes around each input? The zonotope is one of the \
               least total length within the ratio asked for, of as few generators as are found; `ratio` is its \
               length over a proven lower bound for all zonotopes. `volume_ratio` and `box_volume_ratio` compare its \
               volume and that of the box along the axes with the hull's.",
    claims: &["question-approximation-quality", "theorem-4.7"],
    families: &["ball_3", "sphere_3"],
    real_inputs: &[
        "tetrahedron",
        "octahedron",
        "cube",
        "icosahedron",
        "dodecahedron",
        "assimp_spider",
        "assimp_wuson",
        "cgal_cow",
        "cgal_fandisk",
        "teapot",
        "iris",
    ],
    sizes: PerProfile { quick: &[8, 16, 32], full: &[8, 16, 32, 64, 128] },
    instances: PerProfile { quick: 1, full: 3 },
    variants: &[
        Variant::at_all_sizes("within_1e-2", "ε = 0.01"),
        Variant { id: "within_1e-4", title: "ε = 0.0001", largest: PerProfile { quick: 0, full: usize::MAX } },
    ],
    refuses,
    measure,
    ..Experiment::COUNTED
};

/// Flat points have no hull whose volume a zonotope's could be compared with.
fn refuses(points: &Cloud) -> Option<&'static str> {
    match points {
        Cloud::Plane(_) => Some("it compares volumes, and the points are points of the plane"),
        Cloud::Space(points) if matches!(solid_hull(points), Ok(None)) => {
            Some("it compares volumes, and the points lie in a plane")
        }
        Cloud::Space(_) | Cloud::Four(_) => None,
    }
}

fn measure(case: &Case) -> Result<Measurement, String> {
    match case.cloud()? {
        Cloud::Space(points) => measure_in_space(case, &points),
        Cloud::Four(points) => {
            let is_inside = |body: &Zonotope<4>, p: [f64; 4]| {
                Query::of_point(p, body).is_ok_and(|d| by_lad_in_r4::locate(&d, &mut ()).is_member())
            };
            Ok(enclosed(case, &points, is_inside)?.0)
        }
        Cloud::Plane(_) => Err("the plane has an experiment of its own".to_owned()),
    }
}

fn measure_in_space(case: &Case, points: &[[f64; 3]]) -> Result<Measurement, String> {
    let hull = solid_hull(points).map_err(|error| error.to_string())?.ok_or("the points lie in a plane")?;
    let corners: Vec<[f64; 3]> = hull.vertices().into_iter().map(|vertex| points[vertex]).collect();
    let is_inside = |body: &Zonotope<3>, p: [f64; 3]| {
        Query::of_point(p, body).is_ok_and(|d| by_lad::locate(&d, &mut ()).is_member())
    };
    let (measurement, answer) = enclosed(case, &corners, is_inside)?;
    let hull_volume = hull.volume(points);
    let volume = combinatorics(&answer.body).measure.to_f64_fast();
    let range = |c: usize| {
        let values = corners.iter().map(|p| p[c]);
        values.clone().fold(f64::NEG_INFINITY, f64::max) - values.fold(f64::INFINITY, f64::min)
    };
    Ok(measurement
        .with_value("hull_vertices", corners.len() as f64)
        .with_value("volume_ratio", volume / hull_volume)
        .with_value("box_volume_ratio", range(0) * range(1) * range(2) / hull_volume))
}

fn enclosed<const D: usize>(
    case: &Case,
    points: &[[f64; D]],
    is_inside: impl Fn(&Zonotope<D>, [f64; D]) -> bool,
) -> Result<(Measurement, MinLengthZonotope<D>), String> {
    let epsilon: f64 = case
        .variant
        .strip_prefix("within_")
        .and_then(|epsilon| epsilon.parse().ok())
        .ok_or_else(|| format!("{} names no precision", case.variant))?;
    let mut counts = OperationCounts::default();
    let answer = Method::default().solve(points, epsilon, &mut counts).map_err(|error| error.to_string())?;
    let answer = few_generators::fewest(points, answer, epsilon);
    let outside = points.iter().position(|p| !is_inside(&answer.body, *p));
    let checked = match outside {
        Some(point) => Err(format!("point {point} is outside")),
        None if answer.ratio() > 1.0 + epsilon => Err(format!("the ratio {} is above 1 + {epsilon}", answer.ratio())),
        None => Ok(()),
    };
    let digest = Digest::default().floats(answer.body.generators().as_flattened());
    let digest = digest.floats(&[answer.value, answer.lower_bound]).finish();
    let measurement = Measurement::new(&counts, digest, Verdict::of_check("exact membership and the ratio", checked))
        .with_value("ratio", answer.value / answer.lower_bound)
        .with_value("length", answer.value)
        .with_value("generators", answer.body.generators().len() as f64)
        .with_value("directions", answer.effort.rows as f64);
    Ok((measurement, answer))
}
