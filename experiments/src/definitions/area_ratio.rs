//! The ratio of the smallest enclosing zonogon to the hull.

use super::{REAL_INPUTS, min_area_scaling};
use crate::definition::{Case, Experiment, Measurement, PerProfile, Variant, Verdict};
use zonotope::interop::verifier::check_min_area;
use zonotope::tally::OperationCounts;

/// The ratio of the smallest enclosing zonogon to the hull.
pub const EXPERIMENT: Experiment = Experiment {
    id: "area-ratio",
    title: "Minimum-area enclosing zonogon: area against the hull",
    question: "How much larger than the convex hull is the smallest zonogon around each input? `area_ratio` is the \
               ratio of the areas, `relative_gap` the certified distance from the optimum.",
    claims: &["theorem-4.5", "flat-point-sets", "fixed-center-optimum"],
    families: &[
        "circle",
        "ellipse",
        "ellipse_thin",
        "random_convex",
        "regular_polygon",
        "gaussian",
        "clustered",
        "disc",
        "lattice",
        "symmetric",
    ],
    real_inputs: REAL_INPUTS,
    sizes: PerProfile {
        quick: &[3, 4, 5, 8, 16, 32, 64, 256, 1024, 4096],
        full: &[3, 4, 5, 6, 7, 8, 12, 16, 24, 32, 48, 64, 128, 256, 512, 1024, 4096],
    },
    instances: PerProfile { quick: 5, full: 25 },
    variants: &[Variant::at_all_sizes("by_pruning", "Pruning")],
    measure,
    ..Experiment::COUNTED
};

fn measure(case: &Case) -> Result<Measurement, String> {
    let points = case.points()?;
    let mut counts = OperationCounts::default();
    let method = min_area_scaling::method(case)?;
    let answer = method.solve(&points, case.seed, &mut counts).map_err(|error| error.to_string())?;
    let verdict = Verdict::of_verifier("check_min_area", check_min_area(&points, &answer));
    let measurement = Measurement::new(&counts, min_area_scaling::digest(&answer), verdict)
        .with_value("hull_vertices", answer.proof.hull().vertex_count() as f64)
        .with_value("face_dimension", f64::from(answer.proof.face_dimension()))
        .with_value("area", answer.value);
    if !answer.proof.hull().has_area() {
        return Ok(measurement);
    }
    let hull_area = area(answer.proof.hull().vertices());
    Ok(measurement
        .with_value("relative_gap", answer.relative_gap())
        .with_value("hull_area", hull_area)
        .with_value("area_ratio", answer.value / hull_area))
}

/// The area of a convex polygon, rounded: a fan of triangles from the first vertex.
fn area(vertices: &[[f64; 2]]) -> f64 {
    let arms: Vec<[f64; 2]> = vertices.iter().map(|v| [v[0] - vertices[0][0], v[1] - vertices[0][1]]).collect();
    arms.windows(2).map(|arm| arm[0][0] * arm[1][1] - arm[0][1] * arm[1][0]).sum::<f64>() / 2.0
}
