//! Planar convex hull, by monotone chains: sort by x, then one scan builds the hull below and the hull above.
//!
//! # Source
//! Andrew, Another efficient algorithm for convex hulls in two dimensions, 1979. The paper takes the hull for granted
//! ("our input can be assumed to be a convex polygon", Section 4.1).
//!
//! # Method
//! 1. Sort the points lexicographically, equal ones by their position in the input.
//! 2. Scan them. The side of the line from the first to the last point decides to which chain a point goes; points on
//!    that line are dropped.
//! 3. Appending to a chain, drop its last vertex while the turn there is not strictly to the left (to the right,
//!    above).
//!
//! # Complexity
//! n points: O(n log n) time for the sort, then at most 3n orientation tests; 24n bytes for the sorted points and at
//! most 8n for the chains, besides the answer.
//!
//! # Numerics
//! All decisions are exact; −0 equals 0. Vertices are input points, bit for bit.
//!
//! # Checked by
//! [`brute_force`](super::brute_force) and the crate `verifier`.
//!
//! # Example
//! ```
//! let points = [[1.0, 1.0], [0.0, 0.0], [2.0, 0.0], [1.0, 0.0], [0.0, 2.0]];
//! let hull = zonotope::hull::by_monotone_chain::convex_hull(&points, &mut ())?;
//! assert_eq!(hull.vertices(), [[0.0, 0.0], [2.0, 0.0], [0.0, 2.0]]);
//! # Ok::<(), zonotope::hull::HullError>(())
//! ```

use super::error::{HullError, check_count};
use super::polygon::{ConvexHull, PointIndex};
use super::sites::{self, Site};
use crate::numeric::non_finite::NonFinite;
use crate::tally::Tally;

/// The convex hull.
///
/// Orientation tests are counted.
///
/// # Errors
/// See the module.
pub fn convex_hull(points: &[[f64; 2]], tally: &mut impl Tally) -> Result<ConvexHull, HullError> {
    check_count(points.len())?;
    NonFinite::check_list("point", points)?;
    let mut sorted: Vec<Site> =
        points.iter().enumerate().map(|(at, &point)| Site { point, index: PointIndex::new(at) }).collect();
    sites::sort(&mut sorted);
    Ok(sites::hull_of_sorted(&sorted, tally))
}
