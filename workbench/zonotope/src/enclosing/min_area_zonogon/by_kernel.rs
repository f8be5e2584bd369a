//! Minimum-area enclosing zonogon, by the kernel on the lines ℓ_t.
//!
//! # Statement
//! Input: points of the plane, at least one, finite. Output: a zonogon in doubles that contains every point exactly, an
//! upper bound of its area, a lower bound for every enclosing zonogon, the optimal centre exactly and its certificate.
//! For points on a line the area is zero: the answer is their segment, where doubles can express it. The optimal centre
//! need not be unique; the answer holds the dimension of the set of optimal centres.
//!
//! # Source
//! Section 4.1, Theorem 4.5. Departures: the search over the arrangement is the kernel's (the paper's own search is one
//! of its methods); the area is convex, not only unimodal; the centre is rounded to doubles, and the loss is bounded by
//! the certificate.
//!
//! # Method
//! 1. Compute the convex hull and the farthest vertex of each edge, which determine the lines ℓ_t.
//! 2. The kernel minimises Σ |e_t × (X − P_s − P_t)|: the optimal centre and coefficients δ_t.
//! 3. Round the centre to doubles, the best of the nearest ones, take Z(O) there, round it outward.
//! 4. Lower bound: f(O) minus ½ Σ (|v_t| − δ_t v_t) with v_t = e_t × (2O − P_s − P_t), a sum over the few edges whose
//!    δ_t is not the sign of v_t. It holds because f grows by ½ Σ |v_t| and Σ δ_t e_t = 0.
//!
//! # Complexity
//! n points, h hull vertices: O(n log n) for the hull, expected O(h) for the rest with
//! [`by_pruning`](crate::lad::by_pruning), O(h log² h) with the paper's search; space O(n). The paper: O(n log² n).
//!
//! # Shapes
//! `points`: n × 2, any order, duplicates allowed; `generators`: half-lengths, in the order of their angles but for at
//! most two that make up for rounding.
//!
//! # Numerics
//! The optimal centre and all signs are exact. Relative gap: about 1e-16 for few vertices and 2e-14 for many, on hulls
//! that are neither thin nor far from the origin; it grows with (diameter + distance from the origin) · perimeter /
//! area, as no double is nearer to the optimal centre. Always certified by `lower_bound`; use [`exact`](super::exact)
//! where doubles are not enough.
//!
//! # Errors
//! [`MinAreaError::Points`] ⇔ no points, too many, or a coordinate that is not finite.
//!
//! # Checked by
//! [`brute_force`](super::brute_force); the check of such answers in the crate `verifier`.
//!
//! # Example
//! ```
//! use zonotope::enclosing::min_area_zonogon::by_kernel::min_area_by_kernel;
//! use zonotope::lad::Method;
//!
//! // around a triangle the best zonogon is a parallelogram of twice its area
//! let points = [[0.0, 0.0], [2.0, 0.0], [0.0, 2.0]];
//! let answer = min_area_by_kernel(Method::Pruning, &points, 0, &mut ())?;
//! assert_eq!(answer.value, 4.0);
//! assert_eq!(answer.proof.face_dimension(), 2); // any centre in the medial triangle will do
//! # Ok::<(), zonotope::enclosing::min_area_zonogon::MinAreaError>(())
//! ```

use super::answer::{AreaProof, MinAreaError, MinAreaZonogon};
use super::rounded_center::{Kernel, RoundedCenter};
use super::segment::around_segment;
use crate::enclosing::answer::{Effort, Enclosing};
use crate::enclosing::bisectors::Bisectors;
use crate::hull::antipodal::{FarthestVertex, farthest_vertices};
use crate::hull::{ConvexHull, convex_hull};
use crate::lad::{self, LadOptimum};
use crate::tally::Tally;
use crate::zonotope::Zonotope;

/// The zonogon of least area by a chosen method of the kernel, counting operations. `seed` decides the time, never the
/// area.
///
/// # Errors
/// When there are no points, too many, or one is not finite.
pub fn min_area_by_kernel(
    kernel: lad::Method,
    points: &[[f64; 2]],
    seed: u64,
    tally: &mut impl Tally,
) -> Result<MinAreaZonogon, MinAreaError> {
    let hull = convex_hull(points, tally)?;
    if !hull.has_area() {
        return Ok(around_segment(hull));
    }
    let farthest = farthest_vertices(&hull, tally);
    let bisectors = Bisectors::new(&hull, &farthest);
    let problem = bisectors.kernel_problem();
    let outcome = kernel.minimize(&problem, seed, tally);
    let optimum = outcome.into_optimum().expect("an area is never negative, so the objective is bounded");
    let kernel = Kernel { bisectors: &bisectors, problem: &problem, optimum: &optimum };
    let mut rounded = Rounded::around(&RoundedCenter::nearest(&kernel), &kernel, &hull, &farthest);
    if rounded.is_loose()
        && let Some(center) = RoundedCenter::best_nearby(&kernel)
    {
        let nearby = Rounded::around(&center, &kernel, &hull, &farthest);
        if nearby.lower_bound >= rounded.lower_bound && nearby.area <= rounded.area {
            rounded = nearby;
        }
    }
    let Rounded { zonogon, area, lower_bound } = rounded;
    let LadOptimum { face_dimension, certificate, minimizer, .. } = optimum;
    drop(problem);
    let effort = Effort { rows: hull.edge_count(), rounds: 1, ..Effort::default() };
    let proof = AreaProof { minimizer, face_dimension, hull, farthest, certificate };
    Ok(Enclosing { body: zonogon, value: area, lower_bound, proof, effort })
}

/// A zonogon in doubles with its bounds.
struct Rounded {
    zonogon: Zonotope<2>,
    area: f64,
    lower_bound: f64,
}

impl Rounded {
    fn around(center: &RoundedCenter, kernel: &Kernel, hull: &ConvexHull, farthest: &[FarthestVertex]) -> Self {
        let outward = center.outward(hull, farthest, &kernel.bisectors.frame);
        let least = if outward.area_below < f64::MAX {
            center.less_gap(kernel, outward.area_below)
        } else {
            center.exact_area_less_gap(kernel, hull, farthest)
        };
        let lower_bound = least.max(0.0);
        Self { zonogon: outward.zonogon, area: outward.area_above, lower_bound }
    }

    fn is_loose(&self) -> bool {
        self.area - self.lower_bound > GAP_TO_ROUND_AGAIN * self.area
    }
}

/// If the area exceeds its lower bound by more than this share, other doubles near the centre are tried.
const GAP_TO_ROUND_AGAIN: f64 = 1e-13;
