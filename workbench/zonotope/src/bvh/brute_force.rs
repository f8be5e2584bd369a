//! All pairs of triangles of two meshes that meet, and their distance, by looking at every pair.
//!
//! # Statement
//! Input: two meshes under poses. Output: the pairs of triangles with a common point, closed, in increasing order;
//! the square of the distance of the meshes.
//!
//! # Source
//! No part of the paper: the truth that hierarchies are held to.
//!
//! # Method
//! The linear program of [`super::triangles::brute_force`] for every pair whose boxes along
//! the axes meet.
//!
//! # Complexity
//! O(m n) for m and n triangles.
//!
//! # Shapes
//! Pairs are positions of triangles from 0, of the first mesh and of the second.
//!
//! # Numerics
//! Exact throughout.
//!
//! # Checked by
//! Pairs of triangles worked out by hand.
//!
//! # Example
//! ```
//! use zonotope::bvh::{Mesh, brute_force::all_pairs};
//! let corner = vec![[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
//! let mesh = Mesh::new(corner, vec![[0, 1, 2], [1, 2, 3]])?;
//! assert_eq!(all_pairs(&mesh, &mesh), [[0, 0], [0, 1], [1, 0], [1, 1]]); // triangles of a mesh share an edge
//! # Ok::<(), zonotope::bvh::MeshError>(())
//! ```

use super::mesh::PlacedMesh;
use super::triangles;
use crate::numeric::Rational;
use crate::numeric::dyadic::Dyadic;
use crate::numeric::exact_linear::ExactVector;

/// All pairs of triangles that meet.
pub fn all_pairs<'a>(a: impl Into<PlacedMesh<'a>>, b: impl Into<PlacedMesh<'a>>) -> Vec<[usize; 2]> {
    let [a, b] = [a.into(), b.into()].map(|placed| {
        let corners = (0..placed.mesh().triangles().len()).map(|triangle| placed.exact_corners(triangle));
        corners.map(|corners| (extents(&corners), corners)).collect::<Vec<_>>()
    });
    let pair = |i: usize, j: usize| {
        let ((box_a, a), (box_b, b)) = (&a[i], &b[j]);
        let near = box_a.iter().zip(box_b).all(|([low, high], [from, to])| low <= to && from <= high);
        (near && triangles::brute_force::meet(a, b)).then_some([i, j])
    };
    let (rows, columns) = (a.len(), b.len());
    (0..rows).flat_map(|i| (0..columns).map(move |j| (i, j))).filter_map(|(i, j)| pair(i, j)).collect()
}

/// The square of the distance of two meshes; 0 where they meet.
pub fn square_of_distance<'a>(a: impl Into<PlacedMesh<'a>>, b: impl Into<PlacedMesh<'a>>) -> Rational {
    let [a, b] = [a.into(), b.into()].map(|placed| {
        let corners = (0..placed.mesh().triangles().len()).map(|triangle| placed.exact_corners(triangle));
        corners.collect::<Vec<_>>()
    });
    let squares = a.iter().flat_map(|a| b.iter().map(|b| triangles::brute_force::square_of_distance(a, b)));
    squares.min().expect("meshes have triangles")
}

/// The extents of three points along the axes.
fn extents(corners: &[ExactVector; 3]) -> [[Dyadic; 2]; 3] {
    [0, 1, 2].map(|axis| {
        let along = || corners.iter().map(|corner| &corner[axis]);
        [along().min(), along().max()].map(|end| end.expect("three corners").clone())
    })
}
