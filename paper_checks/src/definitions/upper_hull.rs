//! The facets of a body in general position that look up, with the crossings of lines that are dual to them.

use dashu_ratio::RBig;

use crate::definitions::plane::Point;
use crate::definitions::space::{Body, Vector};

/// A facet that looks up.
#[derive(Clone, Debug)]
pub(crate) struct UpperFacet {
    /// The two generators that span it, in increasing order.
    pub(crate) pair: [usize; 2],
    /// The crossing of the lines a x + b y + c = 0 of the two generators (a, b, c).
    pub(crate) crossing: Point,
    /// The corners of its projection, counter-clockwise.
    pub(crate) tile: Vec<Point>,
}

pub(crate) fn upper_facets(body: &Body) -> Vec<UpperFacet> {
    let looking_up = body.facets().into_iter().filter(|facet| facet.normal.0[2] > RBig::ZERO);
    looking_up
        .map(|facet| {
            let [x, y, z] = &facet.normal.0;
            UpperFacet {
                pair: [facet.spanning[0], facet.spanning[1]],
                crossing: Point::new(x / z, y / z),
                tile: facet.corners.iter().map(project).collect(),
            }
        })
        .collect()
}

/// The projection along the z axis.
pub(crate) fn project(vector: &Vector) -> Point {
    Point::new(vector.0[0].clone(), vector.0[1].clone())
}

/// a x + b y + c at a point, for the generator (a, b, c).
pub(crate) fn line_value(generator: &Vector, point: &Point) -> RBig {
    let [a, b, c] = &generator.0;
    a * &point.x + b * &point.y + c
}
