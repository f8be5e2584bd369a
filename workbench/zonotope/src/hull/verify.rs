//! Independent check of a convex hull, by its definition: every vertex is an input point, every corner turns strictly left, the
//! boundary goes around once, and every input point is inside.
//!
//! It shares with the methods only the sign of a cross product. O(n log h) time for n points and h vertices.

use thiserror::Error;

use super::polygon::{ConvexHull, PointIndex, VertexIndex};
use crate::numeric::orientation::{Turn, orientation};

/// Why a polygon is not the hull of the points.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum HullDefect {
    /// The input has no such point, or another one there.
    #[error("vertex {} is not the input point that it names", .0.get())]
    NotAnInputPoint(VertexIndex),
    /// The same point occurs earlier in the input.
    #[error("vertex {} does not name its first occurrence, input point {}", .0.get(), .1.get())]
    NotFirstOccurrence(VertexIndex, PointIndex),
    /// The corner does not turn strictly left.
    #[error("the corner at vertex {} does not turn strictly left", .0.get())]
    NotConvex(VertexIndex),
    /// The first vertex is not the smallest, or the boundary goes around more than once.
    #[error("the boundary does not rise to one largest vertex and fall back at vertex {}", .0.get())]
    NotMonotone(VertexIndex),
    /// An input point is outside.
    #[error("input point {} is outside", .0.get())]
    PointOutside(PointIndex),
}

/// Checks that `hull` is the convex hull of `points`, in the form that [`ConvexHull`] promises.
///
/// # Errors
/// The first defect found.
pub fn verify(points: &[[f64; 2]], hull: &ConvexHull) -> Result<(), HullDefect> {
    let vertices = hull.vertices();
    let count = vertices.len();
    for (at, (vertex, index)) in vertices.iter().zip(hull.indices()).enumerate() {
        // bits, so that the sign of a zero counts
        if points.get(index.get()).map(|point| point.map(f64::to_bits)) != Some(vertex.map(f64::to_bits)) {
            return Err(HullDefect::NotAnInputPoint(VertexIndex::new(at)));
        }
    }
    let largest = (1..count).take_while(|&at| vertices[at - 1] < vertices[at]).count();
    if let Some(at) = (largest + 1..count).find(|&at| vertices[at - 1] <= vertices[at] || vertices[at] <= vertices[0]) {
        return Err(HullDefect::NotMonotone(VertexIndex::new(at)));
    }
    if count >= 3 {
        for at in 0..count {
            let corner = [at, (at + 1) % count, (at + 2) % count].map(|at| vertices[at]);
            if orientation(corner[0], corner[1], corner[2]) != Turn::Left {
                return Err(HullDefect::NotConvex(VertexIndex::new((at + 1) % count)));
            }
        }
    }
    let lower: Vec<usize> = (0..=largest).collect();
    let upper: Vec<usize> = std::iter::once(0).chain((largest..count).rev()).collect();
    for (at, &point) in points.iter().enumerate() {
        for (chain, inner) in [(&lower, Turn::Left), (&upper, Turn::Right)] {
            check_point(point, PointIndex::new(at), hull, chain, inner)?;
        }
    }
    Ok(())
}

/// Checks that a point is not outside of a chain of vertices that increases lexicographically.
fn check_point(
    point: [f64; 2],
    index: PointIndex,
    hull: &ConvexHull,
    chain: &[usize],
    inner: Turn,
) -> Result<(), HullDefect> {
    let vertices = hull.vertices();
    let outside = Err(HullDefect::PointOutside(index));
    let after = chain.partition_point(|&at| vertices[at] <= point);
    if after == 0 {
        return outside;
    }
    let before = chain[after - 1];
    if vertices[before] == point {
        let is_first = hull.indices()[before] <= index;
        return if is_first { Ok(()) } else { Err(HullDefect::NotFirstOccurrence(VertexIndex::new(before), index)) };
    }
    if after == chain.len() {
        return outside;
    }
    let turn = orientation(vertices[before], vertices[chain[after]], point);
    if turn == inner || turn == Turn::Straight { Ok(()) } else { outside }
}
