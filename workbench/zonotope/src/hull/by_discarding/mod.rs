//! Planar convex hull, by discarding: points inside the hull of a sample are dropped in one pass, the others are put in
//! order around the hull by buckets and scanned once.
//!
//! # Source
//! Discarding: Akl and Toussaint, A fast convex hull algorithm, 1978, with the hull of a sample in place of a
//! quadrilateral, and columns in place of edge tests. Order: Andrew, 1979, with bucket sort. The paper takes the hull
//! for granted ("our input can be assumed to be a convex polygon", Section 4.1) and needs O(n log n).
//!
//! # Method
//! 1. One pass finds the bounding box and refuses coordinates that are not finite.
//! 2. The hull of every (sqrt(n)/4)-th point, by monotone chains. If it has more than half of them as vertices, few
//!    points are inside and step 3 is left out.
//! 3. The box is cut into columns of equal width; for each a span of ordinates that is inside that hull for certain
//!    (`interior`). A second pass drops the points within the span of their column: a look-up and two comparisons.
//! 4. The remaining points go, by the side of the line from the first to the last of them and by column, into buckets
//!    that follow each other counter-clockwise around the hull; each bucket is sorted (`ring`).
//! 5. One scan in that order keeps a stack of vertices that turn left (Graham).
//!
//! # Complexity
//! n points, m of them left by step 3: O(n + m log m) time in the worst case, O(n + m) expected if the abscissas have a
//! bounded density. In a fixed disc m is of order n^{2/3} + n/200, on a circle m = n. Memory besides the input: 20m
//! bytes for the points in order, which become the answer, 12m for buckets and positions, and at most 24m more while
//! one bucket is sorted.
//!
//! # Numerics
//! All decisions are exact; step 3 drops a point only when rounding cannot matter. −0 equals 0. Vertices are input
//! points, bit for bit. If the width of the box is not a normal number or its inverse overflows, steps 3 and 4 are
//! replaced by a sort.
//!
//! # Checked by
//! [`brute_force`](super::brute_force) and the crate `verifier`.
//!
//! # Example
//! ```
//! // a parabola, and as many points above it
//! let parabola = (-500..=500).map(f64::from).map(|x| [x, x * x]);
//! let points: Vec<_> = parabola.flat_map(|[x, y]| [[x, y], [x, y / 2.0 + 125_000.0]]).collect();
//! let hull = zonotope::hull::by_discarding::convex_hull(&points, &mut ())?;
//! assert_eq!(hull.vertex_count(), 1001);
//! assert_eq!(hull.vertices()[0], [-500.0, 250_000.0]);
//! # Ok::<(), zonotope::hull::HullError>(())
//! ```

mod bounds;
mod columns;
mod interior;
mod ring;

use super::error::{HullError, check_count};
use super::polygon::ConvexHull;
use super::sites;
use crate::numeric::non_finite::NonFinite;
use crate::tally::{Operation, Tally};
use bounds::Bounds;
use columns::Columns;
use interior::Interior;
use ring::Candidates;

/// Up to this number, points are sorted at once.
const DIRECT_SORT_LIMIT: usize = 64;

/// Up to this number, points left by the discarding are sorted at once.
const CANDIDATE_SORT_LIMIT: usize = 512;

/// From this number on, more columns pay for their table.
const FINER_COLUMNS_FROM: usize = 1 << 15;

/// The convex hull.
///
/// Orientation tests are counted and, for each pass, the points read.
///
/// # Errors
/// See the module.
pub fn convex_hull(points: &[[f64; 2]], tally: &mut impl Tally) -> Result<ConvexHull, HullError> {
    check_count(points.len())?;
    tally.add(Operation::PointRead, points.len() as u64);
    let Some(bounds) = Bounds::of(points) else {
        // finite unless the pass over the box was wrong about it, and then the hull is still right
        NonFinite::check_list("point", points)?;
        return super::by_monotone_chain::convex_hull(points, tally);
    };
    let outside = if points.len() <= DIRECT_SORT_LIMIT {
        None
    } else if points.len() < FINER_COLUMNS_FROM {
        points_outside_sample::<256>(points, &bounds, tally)
    } else {
        points_outside_sample::<1024>(points, &bounds, tally)
    };
    Ok(match outside {
        Some(outside) => hull_of(points, &bounds, outside.len(), || outside.iter().copied(), tally),
        None => hull_of(points, &bounds, points.len(), || 0..points.len() as u32, tally),
    })
}

/// Steps 2 and 3: the positions of the points that are not certainly inside the hull of a sample; `None` if that is not
/// worth while.
fn points_outside_sample<const COLUMNS: usize>(
    points: &[[f64; 2]],
    bounds: &Bounds,
    tally: &mut impl Tally,
) -> Option<Vec<u32>> {
    if bounds.low[0] == bounds.high[0] {
        let is_end = |at: &u32| [bounds.low[1], bounds.high[1]].contains(&points[*at as usize][1]);
        return Some((0..points.len() as u32).filter(is_end).collect());
    }
    let columns = Columns::new(bounds, COLUMNS)?;
    let stride = (points.len().isqrt() / 4).max(1);
    let sample = sites::sorted(points, (0..points.len() as u32).step_by(stride));
    let polygon = sites::hull_of_sorted(&sample, tally);
    if 2 * polygon.vertex_count() > sample.len() {
        return None;
    }
    let interior = Interior::<COLUMNS>::new(&polygon, columns, bounds)?;
    tally.add(Operation::PointRead, points.len() as u64);
    Some(interior.points_outside(points))
}

/// Steps 4 and 5, for the points at `count` positions that include all vertices of the hull.
fn hull_of<I: Iterator<Item = u32>>(
    points: &[[f64; 2]],
    bounds: &Bounds,
    count: usize,
    positions: impl Fn() -> I,
    tally: &mut impl Tally,
) -> ConvexHull {
    // about four candidates a bucket on either side; fewer make the sort cheaper but not the whole
    let columns =
        if count > CANDIDATE_SORT_LIMIT { Columns::new(bounds, (count / 4).next_power_of_two()) } else { None };
    match columns {
        Some(columns) => Candidates { points, count, positions }.hull(bounds, columns, tally),
        None => sites::hull_of_sorted(&sites::sorted(points, positions()), tally),
    }
}

#[cfg(test)]
mod tests;
