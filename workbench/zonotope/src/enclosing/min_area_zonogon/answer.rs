//! The answer: a zonogon in doubles, the exact optimum behind it, and what proves it.

use thiserror::Error;

use crate::hull::antipodal::FarthestVertex;
use crate::hull::{ConvexHull, HullError};
use crate::lad::LadCertificate;
use crate::numeric::Rational;
use crate::numeric::dyadic::Dyadic;
use crate::zonotope::Zonotope;

/// Why points are refused.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum MinAreaError {
    /// The points have no convex hull: there are none, too many, or one is not finite.
    #[error(transparent)]
    Points(#[from] HullError),
}

/// A zonogon that contains every input point exactly, its area within a stated distance of the least possible.
#[derive(Debug, Clone)]
pub struct MinAreaZonogon {
    /// The zonogon, rounded outward.
    pub zonogon: Zonotope<2>,
    /// An upper bound of its area; infinite where areas leave the range of doubles.
    pub area: f64,
    /// A lower bound of the area of every zonogon that contains the points.
    pub lower_bound: f64,
    /// The optimal centre in homogeneous coordinates [X, Y, W], W > 0: (X / W, Y / W), exactly.
    pub optimal_center: [Dyadic; 3],
    /// The dimension of the set of optimal centres: 0 when the centre is unique.
    pub face_dimension: u8,
    /// The convex hull of the points.
    pub hull: ConvexHull,
    /// The farthest vertex of each edge of the hull; empty when the hull has no area.
    pub farthest: Vec<FarthestVertex>,
    /// Coefficients δ_t, one for each edge of the hull, that prove the lower bound; empty when the hull has no area.
    pub certificate: LadCertificate,
}

impl MinAreaZonogon {
    /// The optimal centre, exactly.
    pub fn exact_center(&self) -> [Rational; 2] {
        let [x, y, w] = self.optimal_center.clone().map(|v| v.to_rational());
        [x / &w, y / w]
    }

    /// How far the area may exceed the least possible one, relative to the lower bound; zero when both are zero.
    pub fn relative_gap(&self) -> f64 {
        if self.area == self.lower_bound { 0.0 } else { (self.area - self.lower_bound) / self.lower_bound }
    }
}
