//! Answers to "the convex hull of points of the plane".
//!
//! The vertices are points of the question, in the order of the boundary. Every corner turns strictly left, the
//! boundary goes around once, and no point lies outside: so nothing convex that contains the points is smaller.

use std::fmt::{self, Display};

use crate::exact::grid::check_finite;
use crate::exact::plain_point::PlainPoint;
use crate::exact::polygon::ConvexPolygon;
use crate::verdict::Verdict;

/// The size of a proved hull.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct ConvexHullProof {
    /// The number of points that it contains.
    pub points: usize,
    /// The number of its vertices.
    pub vertices: usize,
}

impl Display for ConvexHullProof {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "a convex polygon of {} vertices that contains all {} points", self.vertices, self.points)
    }
}

/// Proves that the points of the given indices, from 0, are the vertices of the convex hull of the points,
/// counter-clockwise from the lexicographically smallest and none of them on an edge; or says what fails. O(n log h)
/// time for n points and h vertices.
pub fn check_convex_hull(points: &[[f64; 2]], hull: &[usize]) -> Verdict<ConvexHullProof> {
    let checked = check_finite("the question", points.as_flattened()).and_then(|()| check_hull(points, hull));
    checked.map(|()| ConvexHullProof { points: points.len(), vertices: hull.len() }).into()
}

/// The check of a hull of finite points.
pub(crate) fn check_hull(points: &[[f64; 2]], hull: &[usize]) -> Result<(), String> {
    if let Some(wrong) = hull.iter().find(|&&index| index >= points.len()) {
        return Err(format!("certificate: hull names point {wrong}, which does not exist"));
    }
    let vertices = hull.iter().map(|&index| PlainPoint::new(points[index])).collect();
    let polygon = ConvexPolygon::from_vertices(vertices)
        .ok_or("certificate: hull is not a convex polygon, counter-clockwise from its smallest vertex")?;
    match points.iter().position(|&point| !polygon.contains(&PlainPoint::new(point))) {
        Some(outside) => Err(format!("certificate: point {} lies outside the hull", outside + 1)),
        None => Ok(()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_square_by_hand() {
        let points = [[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0], [1.0, 1.0], [1.0, 2.0]];
        let complaint = |hull: &[usize]| check_convex_hull(&points, hull).proof().expect_err("something is wrong");
        let proof = check_convex_hull(&points, &[0, 1, 2, 3]).proof();
        assert_eq!(proof, Ok(ConvexHullProof { points: 6, vertices: 4 }));
        assert!(complaint(&[0, 1, 2]).contains("point 4 lies outside"));
        assert!(complaint(&[0, 2]).contains("point 2 lies outside"));
        assert!(complaint(&[0]).contains("point 2 lies outside"));
        assert!(complaint(&[0, 1, 2, 9]).contains("point 9, which does not exist"));
        for polygon in [&[1, 2, 3, 0][..], &[0, 3, 2, 1], &[0, 1, 4, 2, 3], &[0, 1, 2, 5, 3], &[0, 1, 1, 2, 3], &[]] {
            assert!(complaint(polygon).contains("not a convex polygon"), "{polygon:?}");
        }
        let twice: Vec<usize> = [0, 1, 2, 3].repeat(2);
        assert!(complaint(&twice).contains("not a convex polygon"), "twice around");
    }

    #[test]
    fn rounding_is_no_reason() {
        // The middle point is off the line by less than any sum of doubles near it can say.
        let high = f64::from_bits(1);
        let points = [[0.0, 0.0], [1e300, high], [2e300, high]];
        assert!(check_convex_hull(&points, &[0, 2, 1]).is_right());
        assert!(check_convex_hull(&points, &[0, 2]).is_wrong());
        let huge = [[-f64::MAX, -f64::MAX], [f64::MAX, -f64::MAX], [0.0, f64::MAX], [-0.0, 0.0]];
        assert!(check_convex_hull(&huge, &[0, 1, 2]).is_right());
    }

    #[test]
    fn numbers_that_are_none() {
        assert!(check_convex_hull(&[[f64::NAN, 0.0]], &[0]).is_wrong());
        assert!(check_convex_hull(&[], &[]).is_wrong());
        assert!(check_convex_hull(&[[0.0, -0.0], [-0.0, 0.0]], &[1]).is_right(), "zero has one place");
    }
}
