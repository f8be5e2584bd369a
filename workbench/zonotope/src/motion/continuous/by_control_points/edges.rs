//! Normals of an edge of each body: the facets of the difference of both that are a parallelogram of two generators.

use super::super::SeparatingDirection;
use super::super::gap::Stretch;
use crate::motion::quaternion::{image, polar_rotation, sum, transposed_image};
use crate::numeric::linear::{cross, dot, max_norm};
use crate::numeric::scaling::{binary_exponent, scale_by_power_of_two};

/// The number of edges of each body that are tried.
const EDGE_LIMIT: usize = 2;

/// The least cosine of the angle between a direction and the normal of a pair of edges that is tried.
const LEAST_COSINE: f64 = 0.75;

/// The normals of pairs of edges that are nearly orthogonal to a direction in the middle of a stretch, on its side.
pub(super) fn normals(stretch: &Stretch<'_, f64>, u: [f64; 3]) -> impl Iterator<Item = SeparatingDirection> {
    let rotations = stretch.arcs.each_ref().map(|arc| {
        let middle = sum(&arc.turns[0], &arc.turns[1]);
        polar_rotation(&middle, &middle)
    });
    let edges = |i: usize| orthogonal_edges(stretch.bodies[i].edges(), &transposed_image(&rotations[i], &u));
    let (first, second) = (edges(0), edges(1));
    let pairs = first.into_iter().flat_map(move |e| second.clone().into_iter().map(move |f| [e, f]));
    pairs.filter_map(move |[e, f]| {
        let normal = cross(&image(&rotations[0], &e), &image(&rotations[1], &f));
        let along = dot(&normal, &u);
        let is_near = along * along >= LEAST_COSINE * LEAST_COSINE * dot(&normal, &normal) * dot(&u, &u);
        is_near.then(|| SeparatingDirection::Edges([if along < 0.0 { e.map(|c| -c) } else { e }, f]))
    })
}

/// The edges most nearly orthogonal to a direction.
fn orthogonal_edges(edges: Vec<[f64; 3]>, direction: &[f64; 3]) -> Vec<[f64; 3]> {
    let cosine = |g: [f64; 3]| (dot(&g, direction).abs() / dot(&g, &g).sqrt(), g);
    let mut nearest: Vec<_> = edges.into_iter().map(cosine).filter(|(cosine, _)| !cosine.is_nan()).collect();
    if EDGE_LIMIT < nearest.len() {
        nearest.select_nth_unstable_by(EDGE_LIMIT, |a, b| a.0.total_cmp(&b.0));
        nearest.truncate(EDGE_LIMIT);
    }
    nearest.sort_by(|a, b| a.0.total_cmp(&b.0));
    nearest.into_iter().map(|(_, g)| of_ordinary_size(g)).collect()
}

/// The generator times a power of two, the largest coordinate between 1 and 2: products of directions must not vanish.
fn of_ordinary_size(g: [f64; 3]) -> [f64; 3] {
    let exponent = binary_exponent(max_norm(&g)).unwrap_or(0);
    g.map(|c| scale_by_power_of_two(c, -i64::from(exponent)))
}
