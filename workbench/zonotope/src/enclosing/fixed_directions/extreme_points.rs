//! The points that are extreme along a facet normal: the only ones that the paper's program needs.

use std::collections::BTreeSet;

use super::facet_descent::dot;
use super::normals::facet_normals;
use crate::tally::{Operation, Tally};

/// For every facet normal of the directions, both ways, the farthest point: the scan of Theorem 4.6, O(n k^{d−1}). In increasing order. Ties and
/// near ties are decided by rounded heights.
pub(crate) fn extreme_points<const D: usize>(
    rank: usize,
    points: &[[f64; D]],
    directions: &[[f64; D]],
    tally: &mut impl Tally,
) -> Vec<usize> {
    let mut found = BTreeSet::new();
    for normal in facet_normals(rank, directions) {
        tally.add(Operation::PointRead, points.len() as u64);
        let (mut low, mut high) = ((f64::INFINITY, 0), (f64::NEG_INFINITY, 0));
        for (j, point) in points.iter().enumerate() {
            let height = dot(&normal, point);
            if height < low.0 {
                low = (height, j);
            }
            if height > high.0 {
                high = (height, j);
            }
        }
        found.extend([low.1, high.1]);
    }
    found.into_iter().collect()
}
