//! The fallback of the methods in floating point: small problems whose bounds do not meet are solved in rationals.
//!
//! The program is solved for an active set of points. Its optimum proves a lower bound; rounded, and enlarged until it
//! contains all points, it is a candidate for the answer. The points for which the candidate was enlarged join the
//! active set, and the program is solved again. Points that are no more than the unknowns of the program are all active
//! from the beginning: a point adds a height for each unknown, and a second solution costs as much as the first.

use std::cell::Cell;

use crate::enclosing::fixed_directions::answer::{DirectedZonotope, ExactOptimum, Multiplier, TIGHT_RELATIVE_GAP};
use crate::enclosing::fixed_directions::contain::contain;
use crate::enclosing::fixed_directions::contain::flat_center::cheapest_center;
use crate::enclosing::fixed_directions::problem::{FixedDirections, FixedDirectionsError};
use crate::enclosing::fixed_directions::rational::optimum_within;
use crate::enclosing::fixed_directions::scaled::Setting;
use crate::numeric::Rational;
use crate::numeric::dyadic::Dyadic;
use crate::numeric::outward::fraction_at_most;
use crate::zonotope::ray_exit::FacetMap;

/// The rational program is solved for at most this many facet normals, up to sign.
const RATIONAL_NORMAL_LIMIT: usize = 130;

/// The rational program is solved for at most this many points.
const RATIONAL_POINT_LIMIT: usize = 80;

/// Improves an answer until its bounds are tight, the problem is too large, or no work is left for exact numbers. The
/// active set begins with `active`, at least one point.
///
/// # Errors
/// When a coefficient exceeds the largest double.
pub(in crate::enclosing::fixed_directions) fn refine<const D: usize>(
    setting: Setting<'_, D>,
    mut active: Vec<usize>,
    map: &mut FacetMap<D>,
    exact_work: &Cell<u64>,
    answer: &mut DirectedZonotope<D>,
) -> Result<(), FixedDirectionsError> {
    let Setting { problem, scaled, .. } = setting;
    let kept = &scaled.directions;
    let normals = normal_count(kept.len(), scaled.rank);
    if normals > RATIONAL_NORMAL_LIMIT {
        return Ok(());
    }
    let count = problem.points().len();
    if count <= (2 * normals).min(RATIONAL_POINT_LIMIT) {
        active.extend(0..count);
    }
    let directions: Vec<[f64; D]> = kept.iter().map(|d| problem.directions()[d.index]).collect();
    let weights: Vec<f64> = kept.iter().map(|d| problem.weights()[d.index]).collect();
    loop {
        active.sort_unstable();
        active.dedup();
        if active.len() > RATIONAL_POINT_LIMIT {
            return Ok(());
        }
        let points: Vec<[f64; D]> = active.iter().map(|&j| problem.points()[j]).collect();
        let part = FixedDirections::new(&points, &directions, &weights)?;
        let mut work = exact_work.get();
        let optimum = optimum_within(&part, &mut work);
        exact_work.set(work);
        let Some(optimum) = optimum else { return Ok(()) };
        let lower_bound = fraction_at_most(&optimum.value);
        let (centers, coefficients) = candidates(setting, &optimum);
        answer.effort.exact = true;
        if lower_bound >= answer.lower_bound {
            answer.lower_bound = lower_bound;
            let multipliers = optimum.multipliers.into_iter();
            answer.multipliers =
                multipliers.map(|(point, vector)| Multiplier { point: active[point], vector }).collect();
        }
        let known = active.len();
        for center in centers {
            let Ok(candidate) = contain(problem, scaled, center, &coefficients, map, exact_work) else { continue };
            let zonotope = candidate.zonotope;
            let is_tight = zonotope.value - lower_bound <= TIGHT_RELATIVE_GAP * lower_bound;
            if zonotope.value < answer.value {
                (answer.center, answer.coefficients, answer.value) =
                    (zonotope.center, zonotope.coefficients, zonotope.value);
            }
            if is_tight {
                return Ok(());
            }
            let missed = candidate.enlarged_for.into_iter().filter(|point| !active[..known].contains(point));
            active.extend(missed.collect::<Vec<usize>>());
        }
        if active.len() == known || exact_work.get() == 0 {
            return Ok(());
        }
    }
}

/// Candidates for the centre in doubles, the most promising first, and the coefficients in scaled units, rounded, for
/// an exact optimum.
///
/// If the optimum is zero, directions of weight zero reach all points. Then the coefficients are doubled and the first
/// point is the centre: from there they reach all points as well, and rounding the centre costs nothing.
fn candidates<const D: usize>(setting: Setting<'_, D>, optimum: &ExactOptimum<D>) -> (Vec<[f64; D]>, Vec<f64>) {
    let Setting { problem, scaled, .. } = setting;
    let is_free = optimum.value.is_zero();
    let rounded = |exact: &Rational, exponent: i64| {
        let unit = Dyadic::new(1.into(), -exponent).to_rational();
        (exact * unit).to_f64_fast()
    };
    let doubled = i64::from(is_free);
    let kept = scaled.directions.iter().zip(&optimum.coefficients);
    let coefficients: Vec<f64> = kept.map(|(d, c)| rounded(c, scaled.exponent - d.exponent - doubled)).collect();
    if is_free {
        return (vec![problem.points()[0]], coefficients);
    }
    let nearest = optimum.center.clone().map(|c| c.to_f64_fast().clamp(-f64::MAX, f64::MAX));
    let cheapest = cheapest_center(setting, &optimum.center, &coefficients);
    let centers = if scaled.rank == D && nearest != cheapest { vec![nearest, cheapest] } else { vec![cheapest] };
    (centers, coefficients)
}

/// The number C(k, rank − 1) of facet normals up to sign of k directions in general position, or the largest number if
/// that overflows.
fn normal_count(k: usize, rank: usize) -> usize {
    let size = rank.saturating_sub(1);
    if size > k {
        return 0;
    }
    (0..size).fold(1, |count: usize, i| count.saturating_mul(k - i) / (i + 1))
}
