//! The facet normals of all zonotopes along some directions: one for each subset of d − 1 directions that has one.

use crate::numeric::linear::{dot, hyperplane_normal};
use crate::numeric::subsets::for_each_subset;

/// The rounded unit normals, one of each pair of opposite ones, of the independent (rank − 1)-subsets of k directions
/// whose coordinates beyond the first `rank` are zero. There are at most C(k, rank − 1) of them.
pub(crate) fn facet_normals<const D: usize>(rank: usize, directions: &[[f64; D]]) -> Vec<[f64; D]> {
    let mut found = Vec::new();
    let Some(size) = rank.checked_sub(1) else { return found };
    for_each_subset(directions.len(), size, |subset| {
        let rows: Vec<&[f64]> = subset.iter().map(|&i| &directions[i][..rank]).collect();
        let mut normal = [0.0; D];
        normal[..rank].copy_from_slice(&hyperplane_normal(&rows));
        let length = dot(&normal, &normal).sqrt();
        if length > 0.0 {
            found.push(normal.map(|c| c / length));
        }
    });
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn normals_are_orthogonal_to_their_subsets() {
        assert_eq!(facet_normals(1, &[[2.0], [3.0]]), [[1.0]]);
        let axes = [[1.0, 0.0, 0.0], [0.0, 2.0, 0.0], [0.0, 0.0, 3.0], [5.0, 0.0, 0.0]];
        let normals = facet_normals(3, &axes);
        assert_eq!(normals[..3], [[0.0, 0.0, 1.0], [0.0, -1.0, 0.0], [1.0, 0.0, 0.0]]);
        assert_eq!(normals.len(), 5); // the first and the last direction are parallel
        let four = [[1.0, 2.0, 0.5, -1.0], [0.0, 1.0, 3.0, 1.0], [2.0, -1.0, 1.0, 0.25]];
        let normal = facet_normals(4, &four)[0];
        assert!(four.iter().all(|v| dot(v, &normal).abs() < 1e-15));
    }
}
