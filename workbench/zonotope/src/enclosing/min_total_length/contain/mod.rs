//! Generators in doubles, and the proof in exact arithmetic that they contain every point.
//!
//! For each point there are coefficients δ_i in [−1, 1] with center + Σ δ_i g_i near the point: the search knows them,
//! or the facet that the point's ray meets yields them. The coordinates of the difference are computed exactly, or
//! bounded. Generators along the axes, as long as the largest such coordinate of any point, make the zonotope contain
//! all points. That is why the search above may be in floating point, and why its generators are not changed to fit:
//! the axes add to the length about what the generators miss of the points, which is rounding.

use crate::numeric::dyadic::Dyadic;
use crate::numeric::linear::dot;
use crate::numeric::outward::{at_least, axis_generators};
use crate::numeric::tolerance::UNIT;
use crate::zonotope::Zonotope;

mod coefficients;

use super::box_coordinates::BoxCoordinates;
use super::frame::Frame;
use super::frame_zonotope::FrameZonotope;
use crate::zonotope::ray_exit::{Facet, FacetDescent};
use coefficients::CoefficientRefinement;

/// A generator shorter than this in box coordinates, relative to the longest, is left out: it is rounding noise, which
/// hinders the search for a facet.
const NEGLIGIBLE_LENGTH: f64 = 1e-12;

/// Of up to this many points the facet of each is searched for by itself.
const UNLINKED_POINT_LIMIT: usize = 400;

/// A ray is near another one if the cosine of their angle is above this.
const NEARBY_COSINE: f64 = 0.95;

/// Up to this many products δ_i g_i are computed exactly; the rounding errors of more products are bounded instead,
/// which is faster and costs a little length.
const EXACT_PRODUCTS: usize = 400_000;

/// A zonotope in doubles that contains all points exactly, from a zonotope in the frame, and an upper bound of its
/// total length. `None` if a number leaves the range of doubles.
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
    let exactly = points.len().saturating_mul(generators.len() * D) <= EXACT_PRODUCTS;
    let extents: [f64; D] = std::array::from_fn(|c| generators.iter().map(|g| g[c].abs()).sum());
    let mut lost: [Dyadic; D] = std::array::from_fn(|_| Dyadic::zero());
    if !generators.iter().flatten().chain(&extents).all(|c| c.is_finite()) {
        return None;
    }
    // Coefficients do not depend on coordinates; in box coordinates, where no body is thin, they are found more
    // precisely.
    let refinement = CoefficientRefinement::new(&coordinates, frame.rank(), &used);
    let mut facets = NearbyFacets::new(frame.rank(), &refinement.in_box, points.len());
    let mut witness_of: Vec<Option<&[f64]>> = vec![None; points.len()];
    for (point, deltas) in witnesses {
        witness_of[*point] = Some(deltas);
    }
    for ((point, inside), witness) in points.iter().zip(&frame.points).zip(witness_of) {
        let searched = || {
            let ray = std::array::from_fn(|c| inside[c] - center[c]);
            let scaled = |facet: Facet<D>| {
                let reach = facet.reach.max(1.0);
                facet.coefficients.iter().map(|delta| delta / reach).collect()
            };
            let nearly = facets.facet(&coordinates.vector(&ray)).map_or_else(|| vec![0.0; used.len()], scaled);
            refinement.refined(&ray, nearly)
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
    // The smallest generators may have been rounded to zero.
    generators.retain(|g| g.iter().any(|c| *c != 0.0));
    generators.extend(axis_generators(lost.each_ref().map(at_least)));
    let zonotope = Zonotope::new(outer, generators).ok()?;
    let length = zonotope.total_length();
    length.is_finite().then_some((zonotope, length))
}

/// Searches for the facets that many rays meet: of points in some order along a surface one ray is near the one before,
/// and so are their facets.
struct NearbyFacets<const D: usize> {
    descent: FacetDescent<D>,
    /// Whether there are so many points that the search for one begins where the one before ended.
    is_linked: bool,
    /// The ray before and the normal of its facet.
    last: Option<([f64; D], [f64; D])>,
}

impl<const D: usize> NearbyFacets<D> {
    fn new(rank: usize, generators: &[[f64; D]], points: usize) -> Self {
        let descent = FacetDescent::new(rank, generators);
        Self { descent, is_linked: points > UNLINKED_POINT_LIMIT, last: None }
    }

    fn facet(&mut self, ray: &[f64; D]) -> Option<Facet<D>> {
        let is_near = |last: &[f64; D]| dot(ray, last) > NEARBY_COSINE * (dot(ray, ray) * dot(last, last)).sqrt();
        let near = self.last.filter(|(last, _)| self.is_linked && is_near(last));
        let found = near.and_then(|(_, normal)| self.descent.facet_from(ray, &normal));
        let found = found.or_else(|| self.descent.facet(ray));
        self.last = found.as_ref().map(|facet| (*ray, facet.normal));
        found
    }
}
