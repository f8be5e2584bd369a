//! The answer: a zonogon in doubles, the exact optimum behind it, and what proves it.

use thiserror::Error;

use crate::enclosing::answer::Enclosing;
use crate::enclosing::bisectors::Bisectors;
use crate::hull::antipodal::FarthestVertex;
use crate::hull::{ConvexHull, HullError};
use crate::lad::{LadCertificate, Minimizer};
use crate::numeric::Rational;
use crate::numeric::dyadic::Dyadic;

/// Why points are refused.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum MinAreaError {
    /// The points have no convex hull: there are none, too many, or one is not finite.
    #[error(transparent)]
    Points(#[from] HullError),
}

/// A zonogon that contains every input point exactly, its area within a stated distance of the least possible.
pub type MinAreaZonogon = Enclosing<2, AreaProof>;

/// What proves a lower bound of the area: the hull, its lines ℓ_t and the optimum of the kernel's problem for them.
///
/// The parts fit together, since methods alone put them together; [`exact_optimum`](super::exact::exact_optimum) rests
/// on that.
#[derive(Debug, Clone, PartialEq)]
pub struct AreaProof {
    pub(super) minimizer: Minimizer,
    pub(super) face_dimension: u8,
    pub(super) hull: ConvexHull,
    pub(super) farthest: Vec<FarthestVertex>,
    pub(super) certificate: LadCertificate,
}

impl AreaProof {
    /// The optimal centre in homogeneous coordinates [X, Y, W], W > 0: (X / W, Y / W), exactly. It is computed at each
    /// call: two lines ℓ_t say it as well, and few ask for it.
    pub fn optimal_center(&self) -> [Dyadic; 3] {
        if !self.hull.has_area() {
            let ends = [self.hull.vertices()[0], self.hull.vertices()[self.hull.vertex_count() - 1]];
            let sum = [0, 1].map(|axis| Dyadic::from_f64(ends[0][axis]) + Dyadic::from_f64(ends[1][axis]));
            let [x, y] = sum;
            return [x, y, Dyadic::from_f64(2.0)];
        }
        let bisectors = Bisectors::new(&self.hull, &self.farthest);
        let problem = bisectors.kernel_problem();
        bisectors.frame.center_of(&self.minimizer.homogeneous_point(|line| problem.exact_line(line)))
    }

    /// The optimal centre, exactly.
    pub fn exact_center(&self) -> [Rational; 2] {
        let [x, y, w] = self.optimal_center().map(|v| v.to_rational());
        [x / &w, y / w]
    }

    /// The dimension of the set of optimal centres: 0 when the centre is unique.
    pub fn face_dimension(&self) -> u8 {
        self.face_dimension
    }

    /// The convex hull of the points.
    pub fn hull(&self) -> &ConvexHull {
        &self.hull
    }

    /// The farthest vertex of each edge of the hull; empty when the hull has no area.
    pub fn farthest(&self) -> &[FarthestVertex] {
        &self.farthest
    }

    /// Coefficients δ_t, one for each edge of the hull, that prove the lower bound; empty when the hull has no area.
    pub fn certificate(&self) -> &LadCertificate {
        &self.certificate
    }
}
