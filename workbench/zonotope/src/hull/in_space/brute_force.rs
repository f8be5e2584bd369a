//! Convex hull in space, by brute force: the planes through three points that have no points on one side.
//!
//! # Statement
//! Input: points with finite coordinates, in any order, duplicates allowed. Output: for each facet of their convex hull
//! the positions of all points in its plane, in increasing order; the facets in increasing order. Points that do not
//! span space have no facets.
//!
//! # Source
//! The definition of a facet.
//!
//! # Method
//! 1. For every three points that are not on a line, the side of their plane on which each other point lies.
//! 2. If no two are on opposite sides, and one is beside the plane, the points in the plane are a facet.
//!
//! # Complexity
//! O(n⁴) exact determinants.
//!
//! # Shapes
//! `points`: n × 3.
//!
//! # Numerics
//! Exact, in binary numbers of any length.
//!
//! # Errors
//! [`HullError::Empty`] ⇔ no points; [`HullError::NonFinite`] ⇔ a coordinate is NaN or infinite.
//!
//! # Checked by
//! This is the truth; solids whose facets are known, in the tests.
//!
//! # Example
//! ```
//! use zonotope::hull::in_space::brute_force::facets;
//! let [o, x, y, z] = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
//! // a tetrahedron, and a point on one of its faces
//! let facets = facets(&[o, x, y, z, [0.25, 0.25, 0.0]])?;
//! assert_eq!(facets, [vec![0, 1, 2, 4], vec![0, 1, 3], vec![0, 2, 3], vec![1, 2, 3]]);
//! # Ok::<(), zonotope::hull::HullError>(())
//! ```

use std::cmp::Ordering;
use std::collections::BTreeSet;

use crate::hull::error::{HullError, check_count};
use crate::numeric::exact_linear::{ExactVector, cross, difference, dot, exact, is_zero};
use crate::numeric::non_finite::NonFinite;
use crate::numeric::subsets::for_each_subset;

/// The points in the plane of each facet.
///
/// # Errors
/// See the module.
pub fn facets(points: &[[f64; 3]]) -> Result<Vec<Vec<usize>>, HullError> {
    check_count(points.len())?;
    NonFinite::check_list("point", points)?;
    let places: Vec<ExactVector> = points.iter().map(|&p| exact(p)).collect();
    let mut facets: BTreeSet<Vec<usize>> = BTreeSet::new();
    for_each_subset(points.len(), 3, |corners| {
        let from_first = |p: &ExactVector| difference(p, &places[corners[0]]);
        let normal = cross(&from_first(&places[corners[1]]), &from_first(&places[corners[2]]));
        if is_zero(&normal) {
            return;
        }
        let sides: Vec<Ordering> = places.iter().map(|p| dot(&normal, &from_first(p)).sign()).collect();
        if sides.contains(&Ordering::Less) != sides.contains(&Ordering::Greater) {
            facets.insert((0..points.len()).filter(|&p| sides[p] == Ordering::Equal).collect());
        }
    });
    Ok(facets.into_iter().collect())
}
