//! Zonotopes of few generators, with the normals of their facets stored.
//!
//! The directions span space, and every pair of them has its normal here, so the body is cut out by its normals however
//! short a generator is. Beside the generators the body has a cube: the margin, which takes up all rounding of the fit.
//! A test goes along the facet normals of both bodies, eight at a time; where they do not overlap deeply, along the
//! normals of pairs of long edges of both as well, which makes the test nearly complete.

use fearless_simd::{Simd, dispatch, f64x8, prelude::*};

use super::fitting::{Fitted, fit, refit};
use super::shape::Shaped;
use crate::bvh::frame::{Frame, REACH_LIMIT};
use crate::bvh::volume::{BoundingVolume, expected_overlaps_of_generators};
use crate::numeric::bounded::{Bounded, difference};
use crate::numeric::lanes::level::level_for_few;
use crate::numeric::linear::{cross, dot, euclidean_norm, inverse, sum_norm};
use crate::numeric::tolerance::FITTED_MARGIN;
use crate::zonotope::Zonotope as Body;

/// A fit that misses its points by more than this was none.
const LARGEST_MARGIN: f64 = 0.01;

/// Normals side by side.
const LANES: usize = 8;

/// The generators of each body, the longest ones, whose pairs are the edges that are tried: their normals fill two
/// blocks.
const GENERATORS_OF_EDGES: usize = 4;

/// The depth of an overlap along facets, in terms of the distance of the centres, up to which the normals of edges are
/// tried: of bodies of at most four generators, and of more. These have more facets beside their edges, so that where
/// they overlap deeply along all facets an edge seldom tells more. Both were found by trial.
const SHALLOW: [f64; 2] = [0.3, 0.06];

/// The depth up to which the edges of a body of so many generators are tried.
const fn shallow(generators: usize) -> f64 {
    SHALLOW[(generators > GENERATORS_OF_EDGES) as usize]
}

/// Eight normals: their coordinates, and how far the generators reach along each; as far as doubles go where there is
/// no normal, which a ratio of 0 leaves a number.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Facets {
    normals: [[f64; LANES]; 3],
    reaches: [f64; LANES],
}

impl Facets {
    const NONE: Self = Self { normals: [[0.0; LANES]; 3], reaches: [f64::MAX; LANES] };
}

/// The first generators of a body, the blocks of the normals of their pairs, and up to which share of the distance of
/// the centres bodies may overlap along facets when the normals of edges are tried; 0 where they are not tried.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Used {
    pub(super) generators: usize,
    pub(super) blocks: usize,
    pub(super) shallow: f64,
}

impl Used {
    /// The first vectors, turned; the others are zero.
    #[inline(always)]
    fn turned<const K: usize>(self, vectors: &[[f64; 3]; K], turn: impl Fn(&[f64; 3]) -> [f64; 3]) -> [[f64; 3]; K] {
        let mut turned = [[0.0; 3]; K];
        turned.iter_mut().zip(&vectors[..self.generators]).for_each(|(turned, vector)| *turned = turn(vector));
        turned
    }
}

/// A zonotope of K generators with room for 8 B facet normals, of which each pair of directions has one.
#[derive(Debug, Clone, PartialEq)]
pub struct Zonotope<const K: usize, const B: usize> {
    center: [f64; 3],
    /// Unit vectors, of which as many as the fit has are not zero.
    directions: [[f64; 3]; K],
    generators: [[f64; 3]; K],
    margin: f64,
    facets: [Facets; B],
}

/// A parallelepiped in any position.
pub type Zonotope3 = Zonotope<3, 1>;
/// A zonotope of at most four generators.
pub type Zonotope4 = Zonotope<4, 1>;
/// A zonotope of at most five generators.
pub type Zonotope5 = Zonotope<5, 2>;
/// A zonotope of at most six generators.
pub type Zonotope6 = Zonotope<6, 2>;
/// A zonotope of at most seven generators.
pub type Zonotope7 = Zonotope<7, 3>;
/// A zonotope of at most eight generators.
pub type Zonotope8 = Zonotope<8, 4>;

impl<const K: usize, const B: usize> Zonotope<K, B> {
    /// The body of a fit, its margin as large as the points need.
    ///
    /// The margin of a fit in doubles covers its rounding nearly always. What proves that the points are inside is the
    /// exact test of the body with the margin as three generators of its own.
    pub(super) fn of_fit(fitted: &Fitted, points: &[[f64; 3]]) -> Self {
        const { assert!(K >= 3 && 2 * LANES * B >= K * (K - 1), "each pair of directions has its normal") }
        let mut margin = FITTED_MARGIN;
        while margin < LARGEST_MARGIN {
            let found = Self::with_margin(fitted, margin);
            if found.contains_all(points) {
                return found;
            }
            margin *= 16.0;
        }
        // all points have coordinates of magnitude at most 1
        Self::with_margin(&Fitted::unit_cube(), FITTED_MARGIN)
    }

    fn with_margin(fitted: &Fitted, margin: f64) -> Self {
        let mut directions = [[0.0; 3]; K];
        let mut generators = [[0.0; 3]; K];
        let mut fits: Vec<(&[f64; 3], f64)> =
            fitted.directions.iter().zip(fitted.half_lengths.iter().copied()).collect();
        if fits.len() > GENERATORS_OF_EDGES {
            fits.sort_by(|(_, a), (_, b)| b.total_cmp(a));
        }
        for (k, (direction, half)) in fits.into_iter().enumerate() {
            directions[k] = *direction;
            generators[k] = direction.map(|c| c * half);
        }
        let mut facets = [Facets::NONE; B];
        let pairs = (0..K).flat_map(|j| (0..j).map(move |i| (i, j)));
        let mut at = 0;
        for (i, j) in pairs {
            let normal = cross(&directions[i], &directions[j]);
            let length = euclidean_norm(&normal);
            if length > 0.0 {
                let normal = normal.map(|c| c / length);
                let facets = &mut facets[at / LANES];
                (0..3).for_each(|axis| facets.normals[axis][at % LANES] = normal[axis]);
                facets.reaches[at % LANES] = generators.iter().map(|g| dot(g, &normal).abs()).sum();
                at += 1;
            }
        }
        Self { center: fitted.center, directions, generators, margin, facets }
    }

    /// All generators and normals.
    const ALL: Used = Used { generators: K, blocks: B, shallow: shallow(K) };

    /// The generators and the blocks of normals that are not zero; edges of three generators alone, as those of more
    /// cost a mixed pair more time than they save.
    pub(super) fn used(&self) -> Used {
        let generators = self.directions.iter().filter(|direction| **direction != [0.0; 3]).count();
        let blocks = self.facets.iter().filter(|facets| **facets != Facets::NONE).count();
        Used { generators, blocks, shallow: if generators == 3 { shallow(3) } else { 0.0 } }
    }

    /// The largest gap along the normals that are tried, of bodies of which so much is used, or one that is above
    /// `enough`.
    #[inline]
    pub(super) fn gap_of_used(&self, other: &Self, frame: &Frame, used: [Used; 2], enough: f64) -> f64 {
        dispatch!(level_for_few(), simd => self.gap_in_lanes(simd, other, frame, used, enough))
    }

    /// The body with its margin as three generators along the axes.
    fn body(&self) -> Option<Body<3>> {
        let m = self.margin;
        let margins = [[m, 0.0, 0.0], [0.0, m, 0.0], [0.0, 0.0, m]];
        Body::new(self.center, self.generators.iter().copied().chain(margins).collect()).ok()
    }

    /// Whether the body holds all points, exactly, and reaches no farther than a volume may.
    fn contains_all(&self, points: &[[f64; 3]]) -> bool {
        let Some(body) = self.body() else { return false };
        let reach = body.generators().iter().map(sum_norm).sum::<f64>() + sum_norm(&body.center());
        let inverse = self.inverse_of_three();
        let is_inside = |point: &[f64; 3]| {
            inverse.is_some_and(|inverse| self.holds_but_for_margin(&inverse, point))
                || body.contains(*point) == Ok(true)
        };
        reach <= REACH_LIMIT && points.iter().all(is_inside)
    }

    /// The inverse of the matrix with the generators as columns, rounded, if there are three.
    fn inverse_of_three(&self) -> Option<[[f64; 3]; 3]> {
        let has_others = self.generators.iter().skip(3).any(|g| *g != [0.0; 3]);
        let columns = std::array::from_fn(|axis| std::array::from_fn(|k| self.generators[k][axis]));
        if has_others { None } else { inverse(3, &columns) }
    }

    /// Whether a point is within the margin of a point of the parallelepiped: the one with the nearest coefficients, as
    /// doubles tell it. Of the points of a fit nearly all are, and an exact location takes ten times as long.
    fn holds_but_for_margin(&self, inverse: &[[f64; 3]; 3], point: &[f64; 3]) -> bool {
        let apart = difference(self.center, *point);
        let values = apart.map(|coordinate| coordinate.value);
        let coefficients = inverse.each_ref().map(|row| dot(row, &values).clamp(-1.0, 1.0));
        (0..3).all(|axis| {
            let terms = coefficients.iter().zip(&self.generators);
            let rest = terms.fold(apart[axis], |rest, (c, g)| rest - Bounded::exact(*c) * Bounded::exact(g[axis]));
            rest.magnitude() <= self.margin
        })
    }

    /// The largest gap along the facet normals of one body: `apart` and the generators of the other one as seen from
    /// it, reaches times `ratio`.
    #[inline(always)]
    fn gap_along_facets<S: Simd>(
        &self,
        simd: S,
        blocks: usize,
        apart: &[f64; 3],
        others: &[[f64; 3]],
        ratio: f64,
    ) -> f64 {
        let mut largest = f64x8::splat(simd, f64::NEG_INFINITY);
        for facets in &self.facets[..blocks] {
            let [x, y, z] = [0, 1, 2].map(|axis| f64x8::from_slice(simd, &facets.normals[axis]));
            let mut gap = (x * apart[0] + y * apart[1] + z * apart[2]).abs();
            gap -= f64x8::from_slice(simd, &facets.reaches) * ratio;
            for g in others {
                gap -= (x * g[0] + y * g[1] + z * g[2]).abs();
            }
            largest = largest.max(gap);
        }
        largest_of(&largest)
    }

    /// The largest gap along the normals of an edge of each body.
    #[inline(always)]
    fn gap_along_edges<S: Simd>(
        &self,
        simd: S,
        count: usize,
        apart: &[f64; 3],
        edges: &[[f64; 3]],
        others: &[[f64; 3]],
    ) -> f64 {
        let mut normals = [[0.0; 2 * LANES]; 3];
        let pairs = self.directions[..count.min(GENERATORS_OF_EDGES)]
            .iter()
            .flat_map(|own| edges.iter().map(move |edge| cross(own, edge)));
        for (place, normal) in pairs.take(2 * LANES).enumerate() {
            (0..3).for_each(|axis| normals[axis][place] = normal[axis]);
        }
        // a normal that is 0, as that of a lane without a pair, has the gap 0, which is none
        let mut largest = f64x8::splat(simd, f64::NEG_INFINITY);
        for block in 0..2 {
            let from = block * LANES;
            let [x, y, z] = [0, 1, 2].map(|axis| f64x8::from_slice(simd, &normals[axis][from..from + LANES]));
            let mut gap = (x * apart[0] + y * apart[1] + z * apart[2]).abs();
            for g in self.generators[..count].iter().chain(others) {
                gap -= (x * g[0] + y * g[1] + z * g[2]).abs();
            }
            largest = largest.max(gap);
        }
        largest_of(&largest)
    }

    /// The largest gap of two bodies along the normals that are tried, or one that is above `enough`.
    #[inline(always)]
    fn gap_in_lanes<S: Simd>(&self, simd: S, other: &Self, frame: &Frame, used: [Used; 2], enough: f64) -> f64 {
        let [own, others] = used;
        let image = frame.image(&other.center);
        let apart = std::array::from_fn(|k| image[k] - self.center[k]);
        // a cube of half-length m reaches at most √3 m along a unit vector
        let margins = 2.0 * (self.margin + other.margin);
        let theirs = others.turned(&other.generators, |g| frame.turned(g));
        let theirs = &theirs[..others.generators];
        let gap = self.gap_along_facets(simd, own.blocks, &apart, theirs, 1.0);
        if gap - margins > enough {
            return gap - margins;
        }
        let ours = own.turned(&self.generators, |g| frame.turned_back(g));
        let (ours, turned) = (&ours[..own.generators], frame.turned_back(&apart));
        let gap = gap.max(other.gap_along_facets(simd, others.blocks, &turned, ours, frame.ratio));
        let shallow = own.shallow.min(others.shallow);
        if shallow == 0.0 || gap > margins {
            return gap - margins;
        }
        if gap < 0.0 && gap * gap > shallow * shallow * dot(&apart, &apart) {
            return gap - margins;
        }
        let edges = others.turned(&other.directions, |d| {
            let [a, b, c] = &frame.inverse_rotation;
            [0, 1, 2].map(|k| a[k] * d[0] + b[k] * d[1] + c[k] * d[2])
        });
        let edges = &edges[..others.generators.min(GENERATORS_OF_EDGES)];
        gap.max(self.gap_along_edges(simd, own.generators, &apart, edges, theirs)) - margins
    }
}

#[inline(always)]
fn largest_of<S: Simd>(lanes: &f64x8<S>) -> f64 {
    lanes.as_slice().iter().fold(f64::NEG_INFINITY, |largest, &gap| if gap > largest { gap } else { largest })
}

impl<const K: usize, const B: usize> Shaped for Zonotope<K, B> {
    fn shape(&self) -> Body<3> {
        let generators = self.generators.iter().copied().filter(|g| *g != [0.0; 3]).collect();
        Body::new(self.center, generators).expect("a volume of finite points is finite")
    }

    fn margin(&self) -> f64 {
        self.margin
    }
}

impl<const K: usize, const B: usize> BoundingVolume for Zonotope<K, B> {
    const NAME: &'static str = match K {
        3 => "zonotope, K = 3",
        4 => "zonotope, K = 4",
        5 => "zonotope, K = 5",
        6 => "zonotope, K = 6",
        7 => "zonotope, K = 7",
        _ => "zonotope, K = 8",
    };
    const IS_FITTED_TO_HULL: bool = true;
    type Prepared = Frame;

    fn around(points: &[[f64; 3]], effort: usize) -> Self {
        Self::of_fit(&fit(points, K, effort), points)
    }

    fn refitted(&self, points: &[[f64; 3]]) -> Self {
        Self::of_fit(&refit(points, &self.directions), points)
    }

    fn prepared(frame: &Frame) -> Frame {
        *frame
    }

    #[inline]
    fn gap(&self, other: &Self, frame: &Frame) -> f64 {
        self.gap_of_used(other, frame, [Self::ALL; 2], f64::INFINITY)
    }

    #[inline]
    fn is_apart(&self, other: &Self, frame: &Frame, least: f64) -> bool {
        self.gap_of_used(other, frame, [Self::ALL; 2], least) > least
    }

    fn contains(&self, point: &[f64; 3]) -> bool {
        self.body().is_some_and(|body| body.contains(*point) == Ok(true))
    }

    fn as_zonotope(&self) -> Body<3> {
        self.body().expect("a volume of finite points is finite")
    }

    fn expected_overlaps(&self) -> f64 {
        expected_overlaps_of_generators(&self.generators)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use rand::{RngExt, SeedableRng};
    use rand_pcg::Pcg64;

    /// Corners and points near them, in flat bodies as well: what the quick test holds, the exact location holds.
    #[test]
    fn a_point_that_is_held_but_for_the_margin_lies_in_the_body() {
        let mut random = Pcg64::seed_from_u64(7);
        let (mut held, mut outside) = (0, 0);
        for case in 0..60 {
            let directions: Vec<[f64; 3]> = (0..3)
                .map(|_| [0; 3].map(|_| random.random_range(-1.0..1.0)))
                .map(|v: [f64; 3]| v.map(|c| c / euclidean_norm(&v)))
                .collect();
            let half_lengths = vec![1.0, [1.0, 1e-3, 1e-9][case % 3], 0.5];
            let center = [0; 3].map(|_| random.random_range(-0.1..0.1));
            let found = Zonotope3::with_margin(&Fitted { center, directions, half_lengths }, FITTED_MARGIN);
            let body = found.body().expect("it is finite");
            let inverse = found.inverse_of_three().expect("the generators span space");
            for beside in [0.0, 0.5, 4.0] {
                let shares = [0; 3].map(|_| [-1.0, 0.5, 1.0][random.random_range(0..3)]);
                let point = std::array::from_fn(|axis| {
                    let at: f64 = (0..3).map(|k| shares[k] * found.generators[k][axis]).sum();
                    center[axis] + at + beside * found.margin * random.random_range(-1.0..1.0)
                });
                let is_inside = body.contains(point) == Ok(true);
                assert!(is_inside || !found.holds_but_for_margin(&inverse, &point), "{found:?} {point:?}");
                held += usize::from(found.holds_but_for_margin(&inverse, &point));
                outside += usize::from(!is_inside);
            }
        }
        assert!(held >= 120 && outside >= 20, "{held} held, {outside} outside");
    }
}
