//! The facets of a body in general position that look up, with the crossings of lines that are dual to them.

use dashu_ratio::RBig;

use crate::definitions::plane::Point;
use crate::definitions::space::{Body, Vector};
use crate::instances::bodies::{BodyInstance, bodies_in_general_position};

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

/// Bodies in general position no two of whose generators have parallel projections: every pair spans a facet that looks
/// up.
pub(crate) fn tilings(random: &mut rand_pcg::Pcg64Mcg, count: usize) -> Vec<(BodyInstance, Body, Vec<UpperFacet>)> {
    let instances = bodies_in_general_position(random, count).into_iter();
    instances
        .filter_map(|instance| {
            let body = instance.body();
            let facets = upper_facets(&body);
            let pairs = body.generators.len() * (body.generators.len() - 1) / 2;
            (facets.len() == pairs).then_some((instance, body, facets))
        })
        .collect()
}

fn upper_facets(body: &Body) -> Vec<UpperFacet> {
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
