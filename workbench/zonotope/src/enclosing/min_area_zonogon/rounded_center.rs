//! The optimal centre rounded to doubles, and an upper bound of the area that this costs.
//!
//! With the coefficients δ_t of the certificate, f(O) exceeds its minimum by exactly ½ Σ (|v_t(O)| − δ_t v_t(O)). A
//! term vanishes where δ_t is the sign of v_t(O), so only the lines between O and the optimum count, and those of the
//! basis, whose δ_t need not be a sign.

use crate::enclosing::bisectors::{Bisectors, Frame, NearestCenter};
use crate::enclosing::centered_zonogon::{CenteredZonogon, homogeneous};
use crate::enclosing::half_turn::HalfTurn;
use crate::enclosing::outward::{Outward, round_outward};
use crate::hull::ConvexHull;
use crate::hull::antipodal::FarthestVertex;
use crate::lad::{LadCertificate, LadOptimum, LadProblem, LineIndex, Minimizer};
use crate::numeric::double_double::BoundedDoubleDouble;
use crate::numeric::dyadic::Dyadic;
use crate::numeric::outward::{at_most, certain_at_most};

/// A centre in doubles near the optimal one.
#[derive(Debug)]
pub(super) struct RoundedCenter {
    point: [f64; 2],
    /// The side of each ℓ_t on which the point lies.
    sides: Vec<i8>,
    gap: Gap,
}

/// An upper bound of the excess of the area f at a centre over its minimum.
#[derive(Debug)]
enum Gap {
    /// The bound within an error, for a centre that is the kernel point of these exact pairs.
    Near { gap: BoundedDoubleDouble, kernel_point: [BoundedDoubleDouble; 2] },
    /// The bound.
    Exact(Dyadic),
}

/// The solved kernel problem of a hull.
#[derive(Debug)]
pub(super) struct Kernel<'a, 'h> {
    pub(super) bisectors: &'a Bisectors<'h>,
    pub(super) problem: &'a LadProblem<'h>,
    pub(super) optimum: &'a LadOptimum,
}

impl Kernel<'_, '_> {
    /// The doubles nearest to the optimal centre.
    fn rounded_center(&self) -> [f64; 2] {
        let [x, y, w] = &self.bisectors.frame.center_of(&self.optimum.point_in(self.problem));
        // The centre lies between doubles, but rounding may take it beyond the largest one.
        [x.rounded_ratio(w), y.rounded_ratio(w)].map(|coordinate| coordinate.clamp(-f64::MAX, f64::MAX))
    }

    /// The gap at a kernel point, given the side of each line on which it lies.
    fn exact_gap(&self, sides: &[i8], kernel_point: &[Dyadic; 3]) -> Dyadic {
        let unlike = unlike_certificate(sides, &self.optimum.certificate).filter(|&line| sides[line] != 0);
        let values = unlike.map(|line| self.problem.exact_scaled_value(line, kernel_point).abs());
        self.unscaled(values.fold(Dyadic::zero(), |gap, value| gap + value))
    }

    /// A sum of the kernel's line values as an area in units of the input.
    fn unscaled(&self, gap: Dyadic) -> Dyadic {
        self.bisectors.frame.unscaled_area(gap)
    }
}

/// The number of doubles on either side of the nearest one that are tried in each coordinate.
const NEIGHBOURS: usize = 2;

/// If at most this many lines pass between the candidates, each line is evaluated exactly at each candidate.
const NEARBY_LINE_LIMIT: usize = 1 << 12;

impl RoundedCenter {
    /// The doubles nearest to the optimal centre.
    pub(super) fn nearest(kernel: &Kernel) -> Self {
        Self::nearest_by_pairs(kernel).unwrap_or_else(|| Self::nearest_exactly(kernel))
    }

    /// The same by pairs of doubles, unless they leave open which doubles are nearest, or that these are not the
    /// optimal centre itself.
    fn nearest_by_pairs(kernel: &Kernel) -> Option<Self> {
        let Kernel { bisectors, problem, optimum } = kernel;
        let Minimizer::Vertex(first, second) = optimum.minimizer else { return None };
        let lines = [first, second].map(LineIndex::position);
        let NearestCenter { point, kernel_point, is_optimal } = bisectors.nearest_center(lines, &optimum.place?)?;
        if is_optimal {
            return Some(Self { point, sides: optimum.signs(), gap: Gap::Exact(Dyadic::zero()) });
        }
        let sides = optimum.signs_beside(problem, kernel_point);
        let unlike = unlike_certificate(&sides, &optimum.certificate).filter(|&line| sides[line] != 0);
        let gap = unlike
            .map(|line| problem.exact.value_near(line, &kernel_point))
            .try_fold(BoundedDoubleDouble::exact(0.0), |gap, value| Some(gap + value?.abs()))?;
        let gap = Gap::Near { gap: bisectors.frame.unscaled_pair(gap), kernel_point };
        Some(Self { point, sides, gap })
    }

    fn nearest_exactly(kernel: &Kernel) -> Self {
        let point = kernel.rounded_center();
        let kernel_point = kernel.bisectors.kernel_point(&homogeneous(point));
        let sides = kernel.optimum.signs_at(kernel.problem, &kernel_point);
        if kernel.optimum.is_at(kernel.problem, &kernel_point) {
            return Self { point, sides, gap: Gap::Exact(Dyadic::zero()) };
        }
        let gap = Gap::Exact(kernel.exact_gap(&sides, &kernel_point));
        Self { point, sides, gap }
    }

    /// The greatest double that is not above an area less the gap.
    pub(super) fn less_gap(&self, kernel: &Kernel, area: f64) -> f64 {
        match &self.gap {
            Gap::Near { gap, kernel_point } => {
                let least = BoundedDoubleDouble::exact(area) - *gap;
                certain_at_most(&least).unwrap_or_else(|| {
                    let [x, y] = kernel_point.map(|pair| pair.to_dyadic());
                    at_most(&(Dyadic::from_f64(area) - kernel.exact_gap(&self.sides, &[x, y, Dyadic::one()])))
                })
            }
            Gap::Exact(gap) => at_most(&(Dyadic::from_f64(area) - gap.clone())),
        }
    }

    /// The greatest double that is not above the area of Z(O) less the gap, for an area that doubles do not hold: the
    /// gap may leave their range as well.
    pub(super) fn exact_area_less_gap(&self, kernel: &Kernel, hull: &ConvexHull, farthest: &[FarthestVertex]) -> f64 {
        let area = CenteredZonogon::new(hull, farthest, self.point, &mut ()).exact_area();
        let gap = match &self.gap {
            Gap::Near { kernel_point, .. } => {
                let [x, y] = kernel_point.map(|pair| pair.to_dyadic());
                kernel.exact_gap(&self.sides, &[x, y, Dyadic::one()])
            }
            Gap::Exact(gap) => gap.clone(),
        };
        at_most(&(area - gap))
    }

    /// The best of the nearest doubles and their neighbours; `None` where too many lines pass between them to be worth
    /// it. O(h).
    pub(super) fn best_nearby(kernel: &Kernel) -> Option<Self> {
        let Kernel { bisectors, problem, optimum, .. } = kernel;
        let certificate = &optimum.certificate;
        let [x, y] = kernel.rounded_center().map(neighbours);
        let points: Vec<[f64; 2]> = x.iter().flat_map(|&x| y.iter().map(move |&y| [x, y])).collect();
        let kernel_points: Vec<[Dyadic; 3]> =
            points.iter().map(|&point| bisectors.kernel_point(&homogeneous(point))).collect();
        let (near, mut sides) = problem.sides_around(&kernel_points);
        if near.len() > NEARBY_LINE_LIMIT {
            return None;
        }
        let basis = certificate.basis_fractions(problem);
        let mut lines: Vec<usize> = near.iter().map(|&line| line as usize).collect();
        // The sides of the lines nearby are zero so far.
        lines.extend(unlike_certificate(&sides, certificate).filter(|&line| sides[line] != 0));
        let gap_at = |kernel_point: &[Dyadic; 3]| {
            lines.iter().fold(Dyadic::zero(), |gap, &line| {
                let value = problem.exact_scaled_value(line, kernel_point);
                let side = value.sign() as i8;
                let coefficient =
                    certificate.basis.iter().position(|l| l.position() == line).and_then(|k| basis.get(k));
                match coefficient {
                    _ if side == 0 || side == certificate.signs[line] => gap,
                    Some(delta) => gap + basis_term(&value, delta),
                    None => gap + value.abs(),
                }
            })
        };
        let gaps = kernel_points.iter().map(gap_at).enumerate();
        let (best, gap) = gaps.min_by(|a, b| a.1.cmp(&b.1)).expect("the nearest doubles are among the candidates");
        for &line in &near {
            sides[line as usize] = problem.exact_scaled_value(line as usize, &kernel_points[best]).sign() as i8;
        }
        Some(Self { point: points[best], sides, gap: Gap::Exact(kernel.unscaled(gap)) })
    }

    /// Z(O) at the centre, rounded outward.
    pub(super) fn outward(&self, hull: &ConvexHull, farthest: &[FarthestVertex], frame: &Frame) -> Outward {
        round_outward(&HalfTurn::new(hull, farthest, self.point, &homogeneous(self.point), &self.sides), frame)
    }
}

/// The lines whose side is not their sign in the certificate.
fn unlike_certificate<'a>(sides: &'a [i8], certificate: &'a LadCertificate) -> impl Iterator<Item = usize> + 'a {
    let blocks = sides.chunks(BLOCK).zip(certificate.signs.chunks(BLOCK)).enumerate();
    blocks.filter(|(_, (sides, signs))| sides != signs).flat_map(|(block, (sides, signs))| {
        let unlike = (0..sides.len()).filter(|&i| sides[i] != signs[i]);
        unlike.map(move |i| block * BLOCK + i)
    })
}

/// The number of lines whose sides are compared at once.
const BLOCK: usize = 64;

/// An upper bound of ½ (|value| − δ value) for δ = numerator / denominator, not above |value|.
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

/// A double and the finite doubles next to it on both sides.
fn neighbours(value: f64) -> Vec<f64> {
    let below = std::iter::successors(Some(value), |v| Some(v.next_down())).skip(1).take(NEIGHBOURS);
    let above = std::iter::successors(Some(value), |v| Some(v.next_up())).skip(1).take(NEIGHBOURS);
    std::iter::once(value).chain(below).chain(above).filter(|v| v.is_finite()).collect()
}
