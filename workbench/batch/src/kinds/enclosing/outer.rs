//! The points that a body has to contain to contain all: of many points in the plane or in space, the corners of their
//! convex hull.

use zonotope::hull::convex_hull;
use zonotope::hull::in_space::hull_corners;

/// From this number of points on the hull is computed. The search for a zonotope reads its points some hundred times,
/// but leaves out inner ones of fewer points by itself.
const HULL_POINTS: usize = 10_000;

/// Points, or of many points some that have the same convex hull.
#[derive(Debug)]
pub(super) struct OuterPoints<const D: usize> {
    points: Vec<[f64; D]>,
    /// The places of the points among all, in increasing order; `None` if these are all.
    places: Option<Vec<usize>>,
}

impl<const D: usize> OuterPoints<D> {
    /// Those of the points of a question.
    pub(super) fn of(points: Vec<[f64; D]>) -> Self {
        let corners = if points.len() < HULL_POINTS { None } else { corners(&points) };
        let Some(places) = corners.filter(|corners| corners.len() < points.len()) else {
            return Self { points, places: None };
        };
        Self { points: places.iter().map(|&place| points[place]).collect(), places: Some(places) }
    }

    /// The points that are to be enclosed.
    pub(super) fn points(&self) -> &[[f64; D]] {
        &self.points
    }

    /// The place of a point among all points of the question.
    pub(super) fn place(&self, index: usize) -> usize {
        self.places.as_ref().map_or(index, |places| places[index])
    }

    /// The name of the points in a refusal.
    pub(super) fn described(&self) -> String {
        let count = self.points.len();
        match &self.places {
            Some(_) => format!("{count} corners of the points' hull"),
            None if (2..=3).contains(&D) && count >= HULL_POINTS => {
                format!("{count} points, of which their hull leaves out none")
            }
            None => format!("{count} points"),
        }
    }
}

/// The corners of the hull in the plane and in space; `None` in other dimensions.
fn corners<const D: usize>(points: &[[f64; D]]) -> Option<Vec<usize>> {
    match D {
        2 => {
            let points: Vec<[f64; 2]> = points.iter().map(|p| [p[0], p[1]]).collect();
            let hull = convex_hull(&points, &mut ()).ok()?;
            let mut corners: Vec<usize> = hull.indices().iter().map(|index| index.get()).collect();
            corners.sort_unstable();
            Some(corners)
        }
        3 => hull_corners(&points.iter().map(|p| [p[0], p[1], p[2]]).collect::<Vec<[f64; 3]>>()).ok(),
        _ => None,
    }
}
