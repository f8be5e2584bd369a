//! Points on a line: the least area is zero.

use super::answer::{AreaProof, MinAreaZonogon};
use crate::enclosing::answer::{Effort, Enclosing};
use crate::enclosing::bisectors::Bisectors;
use crate::enclosing::centered_zonogon::CenteredZonogon;
use crate::enclosing::outward::round_outward_exactly;
use crate::hull::ConvexHull;
use crate::lad::{LadCertificate, Minimizer};
use crate::numeric::dyadic::Dyadic;
use crate::numeric::exact_linear::doubles;
use crate::zonotope::Zonotope;

/// The answer for points on a line, whose hull is one point, or two that span all the others.
///
/// It is the segment between the two if its midpoint and its half-length are doubles. Else, if its length is one, it is
/// the segment twice as long with the first point in its middle. Else it is the smallest zonogon around the segment
/// that can be rounded to doubles, whose area is not zero.
pub(super) fn around_segment(hull: ConvexHull) -> MinAreaZonogon {
    let (first, last) = (hull.vertices()[0], hull.vertices()[hull.vertex_count() - 1]);
    let exact_ends = [first, last].map(|p| p.map(Dyadic::from_f64));
    let sum = [0, 1].map(|i| &exact_ends[0][i] + &exact_ends[1][i]);
    let length = [0, 1].map(|i| &exact_ends[1][i] - &exact_ends[0][i]);
    let halves = |v: &[Dyadic; 2]| v.clone().map(|c| c.scaled(-1));
    let flat = match (doubles(&halves(&sum)), doubles(&halves(&length)), doubles(&length)) {
        (Some(center), Some(generator), _) => Some((center, generator)),
        (_, _, Some(generator)) => Some((first, generator)),
        _ => None,
    };
    let (zonogon, area) = match flat {
        Some((center, generator)) => {
            let generators = if generator == [0.0, 0.0] { Vec::new() } else { vec![generator] };
            (Zonotope::new(center, generators).expect("both are doubles"), 0.0)
        }
        None => rounded(&hull, [0, 1].map(|i| halves(&sum)[i].to_f64())),
    };
    let proof = AreaProof {
        minimizer: Minimizer::Plane,
        face_dimension: if length.iter().all(Dyadic::is_zero) { 2 } else { 1 },
        hull,
        farthest: Vec::new(),
        certificate: LadCertificate { signs: Vec::new(), basis: Vec::new() },
    };
    Enclosing { body: zonogon, value: area, lower_bound: 0.0, proof, effort: Effort::default() }
}

/// The smallest zonogon with a centre around a segment, rounded outward, and its area, rounded up.
fn rounded(hull: &ConvexHull, center: [f64; 2]) -> (Zonotope<2>, f64) {
    let frame = Bisectors::new(hull, &[]).frame;
    let rounded = round_outward_exactly(&CenteredZonogon::new(hull, &[], center, &mut ()), &frame);
    (rounded.zonogon, rounded.area_above)
}
