//! Which points have the hull of all, whatever dimension they span.

use super::by_quickhull::hull_around;
use super::simplex::{Spanned, plane_axes, spanned};
use crate::hull::error::{HullError, check_count};
use crate::numeric::non_finite::NonFinite;

/// The positions of points that have the same convex hull as all of them, in increasing order: the vertices of the
/// hull, and perhaps a few points on its edges and facets where others lie on these. Of points in a plane and on a line
/// they are the vertices alone.
///
/// # Errors
/// If there are no points, too many, or one is not finite.
///
/// # Example
/// ```
/// use zonotope::hull::in_space::hull_corners;
/// let square = [[0.0, 0.0, 1.0], [2.0, 0.0, 1.0], [1.0, 1.0, 1.0], [2.0, 2.0, 1.0], [0.0, 2.0, 1.0]];
/// assert_eq!(hull_corners(&square), Ok(vec![0, 1, 3, 4]));
/// # Ok::<(), zonotope::hull::HullError>(())
/// ```
pub fn hull_corners(points: &[[f64; 3]]) -> Result<Vec<usize>, HullError> {
    check_count(points.len())?;
    NonFinite::check_list("point", points)?;
    // A projection along an axis keeps the points of a line or a plane apart if it keeps those apart that span it.
    let shadow_axes = match spanned(points) {
        Spanned::Place(place) => return Ok(vec![place]),
        Spanned::Space(simplex) => return Ok(hull_around(points, simplex).vertices()),
        Spanned::Line([a, b]) => {
            (0..3).find(|&axis| points[a][axis] != points[b][axis]).map(|axis| [axis, (axis + 1) % 3])
        }
        Spanned::Plane(corners) => plane_axes(&corners.map(|corner| points[corner])),
    };
    let [i, j] = shadow_axes.expect("points that differ do so along an axis, points off a line along two");
    let shadow: Vec<[f64; 2]> = points.iter().map(|p| [p[i], p[j]]).collect();
    let mut corners: Vec<usize> =
        crate::hull::convex_hull(&shadow, &mut ())?.indices().iter().map(|index| index.get()).collect();
    corners.sort_unstable();
    Ok(corners)
}
