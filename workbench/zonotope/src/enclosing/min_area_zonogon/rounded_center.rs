//! The optimal centre in doubles, and at most how much area that costs.
//!
//! With the coefficients δ_t of the certificate, f(O) exceeds its minimum by exactly ½ Σ (|v_t(O)| − δ_t v_t(O)). A term vanishes
//! where δ_t is the sign of v_t(O), so only the lines between O and the optimum count, and those of the basis, whose δ_t need not be a sign.

use crate::enclosing::bisectors::Bisectors;
use crate::enclosing::centered_zonogon::{CenteredZonogon, homogeneous};
use crate::hull::ConvexHull;
use crate::hull::antipodal::FarthestVertex;
use crate::lad::{LadCertificate, LadProblem};
use crate::numeric::dyadic::Dyadic;

/// A centre in doubles.
#[derive(Debug)]
pub(super) struct RoundedCenter {
    point: [f64; 2],
    /// On which side of each ℓ_t it lies.
    sides: Vec<i8>,
    /// At least what f exceeds its minimum by there.
    pub(super) gap: Dyadic,
}

/// The solved kernel problem of a hull.
#[derive(Debug)]
pub(super) struct Kernel<'a, 'h> {
    pub(super) bisectors: &'a Bisectors<'h>,
    pub(super) problem: &'a LadProblem<'h>,
    pub(super) certificate: &'a LadCertificate,
    /// The optimal centre in homogeneous coordinates.
    pub(super) center: &'a [Dyadic; 3],
}

impl Kernel<'_, '_> {
    fn rounded_center(&self) -> [f64; 2] {
        let [x, y, w] = self.center;
        // The centre lies between doubles, but rounding may take it beyond the largest one.
        [x.rounded_ratio(w), y.rounded_ratio(w)].map(|coordinate| coordinate.clamp(-f64::MAX, f64::MAX))
    }
}

/// How many doubles on either side of the nearest one are looked at in each coordinate.
const NEIGHBOURS: usize = 2;

impl RoundedCenter {
    /// The doubles nearest to the optimal centre.
    pub(super) fn nearest(kernel: &Kernel) -> Self {
        Self::at(kernel.rounded_center(), kernel, &[])
    }

    /// The best of the nearest doubles and their neighbours. O(h) exact operations for h edges.
    pub(super) fn best_nearby(kernel: &Kernel) -> Self {
        let basis = kernel.certificate.basis_fractions(kernel.problem);
        let [x, y] = kernel.rounded_center().map(neighbours);
        let candidates = x.iter().flat_map(|&x| y.iter().map(move |&y| [x, y]));
        let centers = candidates.map(|point| Self::at(point, kernel, &basis));
        centers.min_by(|a, b| a.gap.cmp(&b.gap)).expect("the nearest doubles are among the candidates")
    }

    /// Z(O) at the centre.
    pub(super) fn boundary<'h>(&self, hull: &'h ConvexHull, farthest: &[FarthestVertex]) -> CenteredZonogon<'h> {
        CenteredZonogon::from_sides(hull, farthest, self.point, &homogeneous(self.point), &self.sides)
    }

    /// A centre with its gap, sharply if the coefficients of the basis are given.
    fn at(point: [f64; 2], kernel: &Kernel, basis: &[[Dyadic; 2]]) -> Self {
        let Kernel { bisectors, problem, certificate, .. } = kernel;
        let kernel_point = bisectors.kernel_point(&homogeneous(point));
        let sides = problem.signs_at(&kernel_point);
        let mut gap = Dyadic::zero();
        let blocks = sides.chunks(BLOCK).zip(certificate.signs.chunks(BLOCK)).enumerate();
        for (block, (sides, signs)) in blocks.filter(|(_, (sides, signs))| sides != signs) {
            for i in (0..sides.len()).filter(|&i| sides[i] != 0 && sides[i] != signs[i]) {
                let line = block * BLOCK + i;
                let value = problem.exact_scaled_value(line, &kernel_point);
                let coefficient =
                    certificate.basis.iter().position(|l| l.position() == line).and_then(|k| basis.get(k));
                gap = gap + coefficient.map_or_else(|| value.clone().abs(), |delta| basis_term(&value, delta));
            }
        }
        Self { point, sides, gap: gap.scaled(2 * bisectors.frame.scale) }
    }
}

/// Edges whose signs are compared at once.
const BLOCK: usize = 64;

/// At least ½ (|value| − δ value), δ = numerator / denominator, and at most |value|.
fn basis_term(value: &Dyadic, [numerator, denominator]: &[Dyadic; 2]) -> Dyadic {
    let size = value.clone().abs();
    let product = numerator * value;
    let opposite = denominator.sign().is_lt();
    let product = if opposite { -product } else { product };
    let denominator = denominator.clone().abs();
    let exact = &size * &denominator - product;
    let share = exact.ratio(&(&size * &denominator)) / 2.0;
    if exact.is_zero() {
        Dyadic::zero()
    } else if share > 1e-200 && share < 1.0 {
        &size * &Dyadic::from_f64((share * (1.0 + 64.0 * f64::EPSILON)).min(1.0))
    } else {
        size
    }
}

/// A double with those next to it on both sides, as far as they are finite.
fn neighbours(value: f64) -> Vec<f64> {
    let below = std::iter::successors(Some(value), |v| Some(v.next_down())).skip(1).take(NEIGHBOURS);
    let above = std::iter::successors(Some(value), |v| Some(v.next_up())).skip(1).take(NEIGHBOURS);
    std::iter::once(value).chain(below).chain(above).filter(|v| v.is_finite()).collect()
}
