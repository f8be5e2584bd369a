//! Zonogons of least area.

use ::verifier::{Certificate, ExactMinArea, MinAreaAnswer, MinAreaProof, Proved, Verdict};

use super::fraction;
use crate::enclosing::min_area_zonogon::MinAreaZonogon;
use crate::enclosing::min_area_zonogon::exact::exact_optimum;

/// Checks a zonogon of least area, but for its exact centre and the dimension of the set of optimal centres.
pub fn check_min_area(points: &[[f64; 2]], answer: &MinAreaZonogon) -> Verdict<MinAreaProof> {
    let written = MinAreaAnswer {
        area: answer.value,
        center: answer.body.center(),
        generators: answer.body.generators().to_vec(),
        lower_bound: answer.lower_bound,
        certificate: certificate(answer),
    };
    ::verifier::check_min_area(points, &written)
}

/// Checks the optimum without any rounding that stands behind an answer, its centre with it. The optimum takes O(h)
/// rational operations for h vertices of the hull.
pub fn check_exact_min_area(points: &[[f64; 2]], answer: &MinAreaZonogon) -> Verdict<Proved> {
    let optimum = exact_optimum(answer);
    let exact = ExactMinArea {
        area: fraction(&optimum.area),
        center: optimum.center.each_ref().map(fraction),
        generators: optimum.generators.iter().map(|generator| generator.each_ref().map(fraction)).collect(),
    };
    ::verifier::check_exact_min_area(points, &certificate(answer), &exact)
}

fn certificate(answer: &MinAreaZonogon) -> Certificate {
    Certificate {
        hull: answer.proof.hull().indices().iter().map(|index| index.get()).collect(),
        farthest: answer.proof.farthest().iter().map(|farthest| farthest.vertex().get()).collect(),
        coefficients: answer.proof.certificate().signs.iter().map(|&sign| f64::from(sign)).collect(),
        basis: answer.proof.certificate().basis.iter().map(|edge| edge.position()).collect(),
    }
}
