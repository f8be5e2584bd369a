//! A zonogon of rounded half-edges that contains Z(O), with bounds of both areas.

use crate::enclosing::boundary_vertex::BoundaryVertex;
use crate::numeric::outward::axis_generators;
use crate::zonotope::Zonotope;

/// A zonogon in doubles that contains Z(O), with bounds of both areas.
#[derive(Debug)]
pub(crate) struct Outward {
    /// The zonogon that contains Z(O).
    pub(crate) zonogon: Zonotope<2>,
    /// A lower bound of the area of Z(O).
    pub(crate) area_below: f64,
    /// An upper bound of the area of the zonogon.
    pub(crate) area_above: f64,
}

/// The zonogon of rounded half-edges, widened by the sums of their errors.
pub(super) fn widened(center: [f64; 2], mut generators: Vec<[f64; 2]>, slack: [f64; 2]) -> Zonotope<2> {
    generators.extend(axis_generators(slack));
    Zonotope::new(center, generators).expect("half-edges of finite points are finite")
}

/// The factor 1 for a vertex of the hull and −1 for a reflected one.
#[inline(always)]
pub(super) fn sense(vertex: BoundaryVertex) -> f64 {
    1.0 - 2.0 * f64::from(u8::from(vertex.reflected))
}
