//! Makes generators in doubles contain every point, exactly.
//!
//! For each point coefficients δ in [−1, 1] come from the facet that its ray meets. What Σ δ_i g_i misses of the point is bounded in each coordinate; generators along the
//! axes, as long as the most that any point misses, make up for it.

use crate::enclosing::fixed_directions::{FacetDescent, dot};
use crate::enclosing::outward::rounded_towards;
use crate::numeric::dyadic::{Dyadic, binary_exponent, scale_by_power_of_two};
use crate::numeric::tolerance::UNIT;
use crate::zonotope::Zonotope;

use super::even::Even;
use super::finish::Inner;
use super::frame::Frame;

/// A generator shorter than this, beside the longest, is left out: noise in every search for a facet.
const NOISE: f64 = 1e-12;

/// Up to this many products are taken exactly; beyond that their rounding errors are bounded.
const EXACT_PRODUCTS: usize = 400_000;

/// Bodies thinner than this, beside their length, are not told from flat ones by the search that made the generators.
const THIN: f64 = 1e-7;

/// A zonotope around all points like one in the frame, and an upper bound of its total length; `None` beyond the range of doubles.
pub(super) fn around<const D: usize>(
    points: &[[f64; D]],
    frame: &Frame<D>,
    inner: &Inner<D>,
) -> Option<(Zonotope<D>, f64)> {
    let found = repaired(points, frame, inner.center, &inner.generators, &inner.witnesses);
    let wanted: f64 = inner.generators.iter().map(|g| dot(g, g).sqrt()).sum();
    let wanted = scale_by_power_of_two(wanted, frame.exponent);
    if found.as_ref().is_some_and(|(_, length)| *length <= wanted * (1.0 + THIN)) {
        return found;
    }
    // A point that generators miss across a thin body is missed along it as well: with what it takes across, none is missed.
    let across = (0..frame.rank()).filter_map(|axis| {
        let width =
            |axis: usize| frame.points.iter().fold(0.0, |max: f64, p| max.max((p[axis] - inner.center[axis]).abs()));
        let widest = (0..frame.rank()).map(width).fold(0.0, f64::max);
        let mut generator = [0.0; D];
        generator[axis] = width(axis) + inner.generators.iter().map(|g| g[axis].abs()).sum::<f64>();
        (width(axis) <= THIN * widest).then_some(generator)
    });
    let thick: Vec<[f64; D]> = inner.generators.iter().copied().chain(across).collect();
    let other = repaired(points, frame, inner.center, &thick, &[]);
    [found, other].into_iter().flatten().min_by(|a, b| a.1.total_cmp(&b.1))
}

/// The generators rounded, and along the axes what they miss of any point.
fn repaired<const D: usize>(
    points: &[[f64; D]],
    frame: &Frame<D>,
    center: [f64; D],
    inner: &[[f64; D]],
    witnesses: &[(usize, Vec<f64>)],
) -> Option<(Zonotope<D>, f64)> {
    let longest = inner.iter().map(|g| dot(g, g)).fold(0.0, f64::max).sqrt();
    let is_across = |g: &[f64; D]| g.iter().filter(|c| **c != 0.0).count() == 1;
    let is_noise = |g: &[f64; D]| dot(g, g).sqrt() <= NOISE * longest && !is_across(g);
    let used: Vec<[f64; D]> = inner.iter().copied().filter(|g| !is_noise(g)).collect();
    let mut generators: Vec<[f64; D]> = used.iter().map(|g| frame.vector(g)).collect();
    let outer = frame.point(&center);
    let exactly = points.len() * generators.len() * D <= EXACT_PRODUCTS;
    let extents: [f64; D] = std::array::from_fn(|c| generators.iter().map(|g| g[c].abs()).sum());
    let mut lost: [Dyadic; D] = std::array::from_fn(|_| Dyadic::zero());
    if !generators.iter().flatten().chain(&extents).all(|c| c.is_finite()) {
        return None;
    }
    // Being inside does not depend on the units of the axes; thin bodies are easier to search where they are not thin.
    let rays = || frame.points.iter().map(|inside| -> [f64; D] { std::array::from_fn(|c| inside[c] - center[c]) });
    let widths: [f64; D] = std::array::from_fn(|c| rays().fold(0.0, |max: f64, ray| max.max(ray[c].abs())));
    let widths = widths.map(|width| binary_exponent(width).map_or(0, i64::from));
    let widened = |v: &[f64; D]| -> [f64; D] { std::array::from_fn(|c| scale_by_power_of_two(v[c], -widths[c])) };
    let wide: Vec<[f64; D]> = used.iter().map(widened).collect();
    let mut descent = FacetDescent::new(frame.rank(), &wide);
    // Where rounding ends one search it seldom ends another in other coordinates.
    let even = Even::of(frame);
    let in_even: Vec<[f64; D]> = used.iter().map(|g| even.vector(g)).collect();
    let mut other = FacetDescent::new(frame.rank(), &in_even);
    let mut witness_of: Vec<Option<&[f64]>> = vec![None; points.len()];
    for (point, deltas) in witnesses {
        witness_of[*point] = Some(deltas);
    }
    for ((point, ray), witness) in points.iter().zip(rays()).zip(witness_of) {
        let searched = || {
            let facet = descent.facet(&widened(&ray)).or_else(|| other.facet(&even.vector(&ray)));
            facet.map_or_else(
                || vec![0.0; used.len()],
                |facet| {
                    let reach = facet.gauge.max(1.0);
                    facet.coefficients.iter().map(|delta| delta / reach).collect()
                },
            )
        };
        let deltas = witness.map_or_else(searched, |deltas| {
            deltas.iter().zip(inner).filter(|(_, g)| !is_noise(g)).map(|(delta, _)| *delta).collect()
        });
        for (c, lost) in lost.iter_mut().enumerate() {
            let missed = if exactly {
                let difference = Dyadic::from_f64(point[c]) - Dyadic::from_f64(outer[c]);
                let terms = generators.iter().zip(&deltas);
                let rest = terms
                    .fold(difference, |rest, (g, &delta)| rest - &Dyadic::from_f64(g[c]) * &Dyadic::from_f64(delta));
                rest.abs()
            } else {
                let sum: f64 = generators.iter().zip(&deltas).map(|(g, delta)| g[c] * delta).sum();
                let difference = point[c] / 2.0 - outer[c] / 2.0;
                let rounding = (generators.len() + 8) as f64 * UNIT * (extents[c] / 2.0 + difference.abs());
                // A product of small numbers may lose half the least denormal number.
                let underflow = (generators.len() + 8) as f64 * f64::from_bits(1);
                Dyadic::from_f64((difference - sum / 2.0).abs() * (1.0 + 4.0 * UNIT) + rounding + underflow).scaled(1)
            };
            if missed > *lost {
                *lost = missed;
            }
        }
    }
    for (axis, lost) in lost.iter().enumerate().filter(|(_, lost)| !lost.is_zero()) {
        let mut generator = [0.0; D];
        generator[axis] = rounded_towards(lost, f64::INFINITY);
        generators.push(generator);
    }
    let length = length_above(&generators);
    let zonotope = Zonotope::new(outer, generators).ok()?;
    length.is_finite().then_some((zonotope, length))
}

/// Σ |g_i|, rounded up.
pub(super) fn length_above<const D: usize>(generators: &[[f64; D]]) -> f64 {
    let lengths = generators.iter().map(|g| {
        let largest = g.iter().fold(0.0, |max: f64, c| max.max(c.abs()));
        let axes = g.iter().filter(|c| **c != 0.0).count();
        if axes <= 1 {
            return Dyadic::from_f64(largest);
        }
        let unit = g.map(|c| c / largest);
        let factor = dot(&unit, &unit).sqrt() * (1.0 + 8.0 * D as f64 * UNIT);
        // As a double the product might be denormal, with few bits.
        &Dyadic::from_f64(largest) * &Dyadic::from_f64(factor)
    });
    rounded_towards(&lengths.fold(Dyadic::zero(), |sum, length| sum + length), f64::INFINITY)
}
