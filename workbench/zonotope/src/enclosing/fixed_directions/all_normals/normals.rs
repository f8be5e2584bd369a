//! The facet normals of all zonotopes along some directions: one for each subset of d − 1 directions that has one.

use crate::zonotope::ray_exit::dot;

/// The rounded unit normals, one of each pair of opposite ones, of the independent (rank − 1)-subsets of k directions
/// whose coordinates beyond the first `rank` are zero. There are at most C(k, rank − 1) of them.
pub(crate) fn facet_normals<const D: usize>(rank: usize, directions: &[[f64; D]]) -> Vec<[f64; D]> {
    let mut found = Vec::new();
    let Some(size) = rank.checked_sub(1) else { return found };
    let mut subset: Vec<usize> = (0..size).collect();
    while subset.last().is_none_or(|&last| last < directions.len()) {
        let rows: Vec<&[f64; D]> = subset.iter().map(|&i| &directions[i]).collect();
        let columns: Vec<usize> = (0..rank).collect();
        let mut normal = [0.0; D];
        for (c, component) in normal.iter_mut().enumerate().take(rank) {
            let others: Vec<usize> = columns.iter().copied().filter(|&other| other != c).collect();
            let minor = determinant(&rows, &others);
            *component = if c % 2 == 0 { minor } else { -minor };
        }
        let length = dot(&normal, &normal).sqrt();
        if length > 0.0 {
            found.push(normal.map(|c| c / length));
        }
        let Some(moving) = (0..size).rev().find(|&i| subset[i] + size - i < directions.len()) else { break };
        subset[moving] += 1;
        for i in moving + 1..size {
            subset[i] = subset[i - 1] + 1;
        }
    }
    found
}

fn determinant<const D: usize>(rows: &[&[f64; D]], columns: &[usize]) -> f64 {
    match (rows, columns) {
        ([], _) => 1.0,
        ([a], [x]) => a[*x],
        ([a, b], [x, y]) => a[*x] * b[*y] - a[*y] * b[*x],
        ([row, rest @ ..], _) => columns.iter().enumerate().fold(0.0, |sum, (i, &column)| {
            let others: Vec<usize> = columns.iter().copied().filter(|&other| other != column).collect();
            let term = row[column] * determinant(rest, &others);
            if i % 2 == 0 { sum + term } else { sum - term }
        }),
    }
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
