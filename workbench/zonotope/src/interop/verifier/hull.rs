//! Convex hulls.

use ::verifier::{ConvexHullProof, Verdict};

use crate::hull::ConvexHull;

/// Checks a convex hull: its indices, and that its vertices are the points that they name.
pub fn check_convex_hull(points: &[[f64; 2]], hull: &ConvexHull) -> Verdict<ConvexHullProof> {
    let indices: Vec<usize> = hull.indices().iter().map(|index| index.get()).collect();
    // bits, so that the sign of a zero counts
    let bits = |point: &[f64; 2]| point.map(f64::to_bits);
    let named = |(vertex, &index): (&[f64; 2], &usize)| points.get(index).map(bits) == Some(bits(vertex));
    match hull.vertices().iter().zip(&indices).position(|pair| !named(pair)) {
        Some(vertex) => Verdict::Wrong(format!("vertex {vertex} of the hull is not the point that it names")),
        None => ::verifier::check_convex_hull(points, &indices),
    }
}
