//! The points that are extreme along a facet normal: the only ones that the paper's program needs.

use std::collections::BTreeSet;

use super::normals::facet_normals;
use crate::enclosing::fixed_directions::farthest::farthest;
use crate::tally::{Operation, Tally};

/// The farthest point along every facet normal of the directions and along its opposite, in increasing order: the scan
/// of Theorem 4.6, O(n k^{d−1}). Ties and near ties are decided by rounded heights, which suits a guess.
pub(crate) fn extreme_points<const D: usize>(
    rank: usize,
    points: &[[f64; D]],
    directions: &[[f64; D]],
    tally: &mut dyn Tally,
) -> Vec<usize> {
    let normals = facet_normals(rank, directions);
    tally.add(Operation::ScanRead, points.len() as u64 * normals.len() as u64);
    let found = farthest(points, 0..points.len(), &normals);
    let found: BTreeSet<usize> = found.into_iter().flatten().map(|far| far.point).collect();
    found.into_iter().collect()
}
