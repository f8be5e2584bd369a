//! Shared parts of the figures of section 4.1: a polygon with its lines ℓ_t, the area f of Z(O), and its level sets.

use zonotope::enclosing::area_function::AreaFunction;
use zonotope::enclosing::bisectors::{Bisectors, Candidate};
use zonotope::enclosing::centered_zonogon::CenteredZonogon;
use zonotope::enclosing::min_area;
use zonotope::enclosing::min_area_zonogon::MinAreaZonogon;
use zonotope::hull::antipodal::{FarthestVertex, farthest_vertices};
use zonotope::hull::{ConvexHull, HullError, convex_hull};
use zonotope::lad::by_slope_selection::SearchStep;

/// A line of the arrangement as it is drawn: a point on it, and its direction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DrawnLine {
    /// A point on the line.
    pub point: [f64; 2],
    /// The direction of the line, which is not zero.
    pub direction: [f64; 2],
}

/// The convex hull of finitely many points, with what section 4.1 derives from it.
#[derive(Clone, Debug)]
pub struct Polygon {
    points: Vec<[f64; 2]>,
    hull: ConvexHull,
    farthest: Vec<FarthestVertex>,
}

impl Polygon {
    /// The hull of the points of a figure.
    ///
    /// # Panics
    /// If there are none, or one is not finite: a figure's points are written in its file.
    pub fn of_figure(points: &[[f64; 2]]) -> Self {
        Self::of(points).expect("a figure's points are finite and not none because they are written down")
    }

    /// The hull of points.
    ///
    /// # Errors
    /// If there are none, too many, or one is not finite.
    pub fn of(points: &[[f64; 2]]) -> Result<Self, HullError> {
        let hull = convex_hull(points, &mut ())?;
        let farthest = farthest_vertices(&hull, &mut ());
        Ok(Self { points: points.to_vec(), hull, farthest })
    }

    /// The hull's vertices, counter-clockwise from the lexicographically smallest.
    pub fn vertices(&self) -> &[[f64; 2]] {
        self.hull.vertices()
    }

    /// Z(O).
    pub fn centered_zonogon(&self, center: [f64; 2]) -> CenteredZonogon<'_> {
        CenteredZonogon::new(&self.hull, &self.farthest, center, &mut ())
    }

    /// f(O), the area of Z(O).
    pub fn area_at(&self, center: [f64; 2]) -> f64 {
        self.centered_zonogon(center).exact_area().to_f64()
    }

    /// The zonogon of least area.
    pub fn optimum(&self) -> MinAreaZonogon {
        min_area(&self.points).expect("the points were accepted by the hull already")
    }

    /// The polygons of the centres O with f(O) at most each of the levels.
    pub fn level_sets(&self, levels: &[f64]) -> Vec<Vec<[f64; 2]>> {
        AreaFunction::new(&self.hull, &self.farthest).level_sets(levels)
    }

    /// The vertices of the arrangement of the lines ℓ_t.
    pub fn candidates(&self) -> Vec<Candidate> {
        self.bisectors().candidates()
    }

    /// The vertical lines of the search of Theorem 4.5.
    pub fn search(&self, seed: u64) -> Vec<SearchStep> {
        self.bisectors().search_by_slope_selection(seed)
    }

    fn bisectors(&self) -> Bisectors<'_> {
        Bisectors::new(&self.hull, &self.farthest)
    }

    /// The area of the hull.
    pub fn area(&self) -> f64 {
        polygon_area(self.vertices())
    }

    /// The lines ℓ_t, one for each edge.
    pub fn lines(&self) -> Vec<DrawnLine> {
        let bisectors = self.bisectors();
        (0..self.hull.edge_count())
            .map(|t| {
                let [from, to] = bisectors.midpoints(t);
                DrawnLine { point: from, direction: [to[0] - from[0], to[1] - from[1]] }
            })
            .collect()
    }
}

/// The area of a polygon with its corners in counter-clockwise order, rounded: for labels.
pub fn polygon_area(corners: &[[f64; 2]]) -> f64 {
    let Some((&origin, others)) = corners.split_first() else { return 0.0 };
    let from_origin = |point: [f64; 2]| [point[0] - origin[0], point[1] - origin[1]];
    let fans = others.windows(2).map(|pair| {
        let (a, b) = (from_origin(pair[0]), from_origin(pair[1]));
        (a[0] * b[1] - a[1] * b[0]) / 2.0
    });
    fans.sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    const TRIANGLE: [[f64; 2]; 3] = [[0.0, 0.0], [2.0, 0.0], [0.0, 2.0]];

    #[test]
    fn a_triangle_needs_twice_its_area() {
        let triangle = Polygon::of_figure(&TRIANGLE);
        assert_eq!(triangle.area(), 2.0);
        assert_eq!(triangle.area_at([1.0, 1.0]), 4.0);
        assert!((triangle.optimum().value - 4.0).abs() < 1e-9);
    }

    #[test]
    fn lines_join_midpoints() {
        let lines = Polygon::of_figure(&TRIANGLE).lines();
        assert_eq!(lines[0], DrawnLine { point: [0.0, 1.0], direction: [1.0, 0.0] });
    }
}
