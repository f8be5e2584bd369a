//! The exact optimum: the zonogon of least area in rationals, without rounding.

use super::answer::MinAreaZonogon;
use crate::enclosing::bisectors::Bisectors;
use crate::enclosing::centered_zonogon::{BoundaryVertex, CenteredZonogon};
use crate::numeric::Rational;
use crate::numeric::dyadic::Dyadic;

/// The zonogon { center + Σ δ_i generators_i : |δ_i| ≤ 1 } of least area, exactly.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ExactZonogon {
    /// An optimal centre.
    pub center: [Rational; 2],
    /// The half-edges of half the boundary, counter-clockwise.
    pub generators: Vec<[Rational; 2]>,
    /// The area.
    pub area: Rational,
}

/// The exact optimum behind an answer. O(h) rational operations for h hull vertices.
pub fn exact_optimum(answer: &MinAreaZonogon) -> ExactZonogon {
    let bisectors = Bisectors::new(&answer.proof.hull, &answer.proof.farthest);
    let optimal_center = answer.proof.optimal_center();
    let sides = bisectors.kernel_problem().signs_at(&bisectors.kernel_point(&optimal_center), &mut ());
    let rounded_center = answer.body.center();
    let boundary = CenteredZonogon::from_sides(
        &answer.proof.hull,
        &answer.proof.farthest,
        rounded_center,
        &optimal_center,
        &sides,
    );
    let center = answer.proof.exact_center();
    let vertices: Vec<[Rational; 2]> =
        boundary.half_boundary().iter().map(|&v| exact_vertex(answer, &center, v)).collect();
    let half = Rational::from_parts(1.into(), 2u8.into());
    let edges = vertices.windows(2).map(|w| [&w[1][0] - &w[0][0], &w[1][1] - &w[0][1]]);
    let generators =
        edges.map(|[x, y]| [x * &half, y * &half]).filter(|g| *g != [Rational::ZERO, Rational::ZERO]).collect();
    let arms: Vec<[Rational; 2]> = vertices.iter().map(|[x, y]| [x - &center[0], y - &center[1]]).collect();
    let area = arms.windows(2).fold(Rational::ZERO, |sum, w| sum + &w[0][0] * &w[1][1] - &w[0][1] * &w[1][0]);
    ExactZonogon { center, generators, area }
}

/// A vertex of the boundary of Z(O) for the exact centre O.
fn exact_vertex(answer: &MinAreaZonogon, center: &[Rational; 2], at: BoundaryVertex) -> [Rational; 2] {
    let point = answer.proof.hull.vertex(at.vertex).map(|v| Dyadic::from_f64(v).to_rational());
    if !at.reflected {
        return point;
    }
    let [x, y] = point;
    [&center[0] + &center[0] - x, &center[1] + &center[1] - y]
}
