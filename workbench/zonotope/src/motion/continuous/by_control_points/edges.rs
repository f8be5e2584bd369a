//! Normals of an edge of each body: the facets of the difference of both that are a parallelogram of two generators.

use super::super::SeparatingDirection;
use crate::motion::arc::Arc;
use crate::motion::quaternion::{image, polar_rotation, transposed_image};
use crate::numeric::linear::{cross, dot};
use crate::zonotope::Zonotope;

/// The number of edges of each body that are tried.
const EDGE_LIMIT: usize = 2;

/// The normals of pairs of edges that are nearly orthogonal to a direction at the begin of a stretch, on its side.
pub(super) fn normals(
    bodies: [&Zonotope<3>; 2],
    arcs: [&Arc<f64>; 2],
    u: &[f64; 3],
) -> impl Iterator<Item = SeparatingDirection> {
    let rotations = arcs.map(|arc| polar_rotation(&arc.turns[0], &arc.turns[0]));
    let edges = [0, 1].map(|i| orthogonal_generators(bodies[i], &transposed_image(&rotations[i], u)));
    let direction = *u;
    let [first, second] = edges;
    let pairs = first.into_iter().flat_map(move |e| second.clone().into_iter().map(move |f| [e, f]));
    pairs.map(move |[e, f]| {
        let normal = cross(&image(&rotations[0], &e), &image(&rotations[1], &f));
        let e = if dot(&normal, &direction) < 0.0 { e.map(|c| -c) } else { e };
        SeparatingDirection::Edges([e, f])
    })
}

/// The generators most nearly orthogonal to a direction.
fn orthogonal_generators(body: &Zonotope<3>, direction: &[f64; 3]) -> Vec<[f64; 3]> {
    let cosine = |g: &[f64; 3]| (dot(g, direction).abs() / dot(g, g).sqrt(), *g);
    let mut generators: Vec<_> = body.generators().iter().map(cosine).filter(|(cosine, _)| !cosine.is_nan()).collect();
    let limit = EDGE_LIMIT.min(generators.len());
    if limit < generators.len() {
        generators.select_nth_unstable_by(limit, |a, b| a.0.total_cmp(&b.0));
    }
    generators.truncate(limit);
    generators.sort_by(|a, b| a.0.total_cmp(&b.0));
    generators.into_iter().map(|(_, g)| g).collect()
}
