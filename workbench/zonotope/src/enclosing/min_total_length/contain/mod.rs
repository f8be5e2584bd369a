//! Makes generators in doubles contain every point, exactly.
//!
//! For each point coefficients δ in [−1, 1] are known, or come from the facet that its ray meets. What Σ δ_i g_i misses
//! of the point is bounded in each coordinate; generators along the axes, as long as the most that any point misses,
//! make up for it.

use crate::enclosing::outward::rounded_towards;
use crate::numeric::dyadic::Dyadic;
use crate::numeric::tolerance::UNIT;
use crate::zonotope::Zonotope;

mod coefficients;

use super::box_coordinates::BoxCoordinates;
use super::frame::Frame;
use super::frame_zonotope::FrameZonotope;
use crate::zonotope::ray_exit::{Facet, FacetDescent, dot};
use coefficients::Settling;

/// A generator shorter than this, beside the longest and in box coordinates, is left out: noise in every search for a
/// facet.
const NEGLIGIBLE_LENGTH: f64 = 1e-12;

/// Up to this many products are taken exactly; beyond that their rounding errors are bounded.
const EXACT_PRODUCTS: usize = 400_000;

/// A zonotope around all points like one in the frame, and an upper bound of its total length: the generators rounded,
/// and along the axes what they miss of any point. `None` beyond the range of doubles.
pub(super) fn around<const D: usize>(
    points: &[[f64; D]],
    frame: &Frame<D>,
    inner: &FrameZonotope<D>,
) -> Option<(Zonotope<D>, f64)> {
    let FrameZonotope { center, generators: inner, witnesses, .. } = inner;
    let coordinates = BoxCoordinates::of(frame);
    let longest = inner.iter().map(|g| coordinates.size(g)).fold(0.0, f64::max);
    let is_noise = |g: &[f64; D]| coordinates.size(g) <= NEGLIGIBLE_LENGTH * longest;
    let used: Vec<[f64; D]> = inner.iter().copied().filter(|g| !is_noise(g)).collect();
    let mut generators: Vec<[f64; D]> = used.iter().map(|g| frame.vector(g)).collect();
    let outer = frame.point(center);
    let exactly = points.len() * generators.len() * D <= EXACT_PRODUCTS;
    let extents: [f64; D] = std::array::from_fn(|c| generators.iter().map(|g| g[c].abs()).sum());
    let mut lost: [Dyadic; D] = std::array::from_fn(|_| Dyadic::zero());
    if !generators.iter().flatten().chain(&extents).all(|c| c.is_finite()) {
        return None;
    }
    // Being inside does not depend on coordinates; thin bodies are easier to search where they are not thin.
    let settling = Settling::new(&coordinates, frame.rank(), &used);
    let mut descent = FacetDescent::new(frame.rank(), &settling.in_box);
    let mut witness_of: Vec<Option<&[f64]>> = vec![None; points.len()];
    for (point, deltas) in witnesses {
        witness_of[*point] = Some(deltas);
    }
    for ((point, inside), witness) in points.iter().zip(&frame.points).zip(witness_of) {
        let searched = || {
            let ray = std::array::from_fn(|c| inside[c] - center[c]);
            let scaled = |facet: Facet<D>| {
                let reach = facet.gauge.max(1.0);
                facet.coefficients.iter().map(|delta| delta / reach).collect()
            };
            let nearly = descent.facet(&coordinates.vector(&ray)).map_or_else(|| vec![0.0; used.len()], scaled);
            settling.settled(&ray, nearly)
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
    let length = rounded_towards(&lengths.fold(Dyadic::zero(), |sum, length| sum + length), f64::INFINITY);
    if length < f64::MIN_POSITIVE { tiny_length_above(generators) } else { length }
}

/// The same for lengths among the least doubles: these are so far apart that a factor above 1 may cost a whole step, so roots are taken of the
/// exact squares.
fn tiny_length_above<const D: usize>(generators: &[[f64; D]]) -> f64 {
    let square = |g: &[f64; D]| g.iter().map(|c| Dyadic::from_f64(*c)).fold(Dyadic::zero(), |sum, c| sum + &c * &c);
    let length = generators.iter().map(|g| square(g).root_above()).fold(Dyadic::zero(), |sum, length| sum + length);
    rounded_towards(&length, f64::INFINITY)
}
