//! All facets of a small zonotope with an interior, and how points lie relative to them: the gauge and the depth.
//!
//! The facet that decides is sought in floating point with bounds of its error; only facets that may be the one are
//! gone through exactly.

use std::cell::OnceCell;

use dashu_int::IBig;
use dashu_int::ops::Abs;

use super::wide_vector::WideVector;
use crate::exact::length::Length;
use crate::exact::linear::{Echelon, Vector, dot, is_zero};
use crate::exact::proportion::Proportion;
use crate::exact::subsets::{count_subsets, subsets};
use crate::exact::turns::edges;
use crate::exact::wide::Wide;
use crate::faces::normals::{MOST_COORDINATES, normals};

/// Limit of the products of facets and generators that are tried where the certificate does not name the facet: in
/// dimensions in which floating point passes over what is clear, and in others.
const MOST_TRIALS: u64 = 12_000_000;
const MOST_EXACT_TRIALS: u64 = 3_000_000;

/// A relative bound for what the quotient of two bounds, and the root of a sum of squares, lose by rounding.
const QUOTIENT_ERROR: f64 = 64.0 * f64::EPSILON;

/// A body with an interior, all its facets, one of each pair of opposite ones, and points.
pub(crate) struct Facets {
    generators: Vec<Vector>,
    points: Vec<Vector>,
    facets: Vec<Facet>,
    /// The points in floating point.
    point_images: Vec<WideVector>,
}

struct Facet {
    normal: Vector,
    /// Σ |u · g_i| for the normal u, where it has been needed.
    reach: OnceCell<IBig>,
    /// The normal in floating point and bounds of Σ |u · g_i|, in dimensions in which facets are many.
    rounded: Option<(WideVector, [Wide; 2])>,
}

impl Facets {
    /// All facets, unless they are too many.
    pub(crate) fn of(dimension: usize, generators: &[Vector], points: &[Vector]) -> Option<Self> {
        let trials = count_subsets(generators.len(), dimension.checked_sub(1)?);
        let has_images = (3..=MOST_COORDINATES).contains(&dimension);
        let most = if has_images { MOST_TRIALS } else { MOST_EXACT_TRIALS };
        if dimension != 2 && trials.saturating_mul(generators.len() as u64) > most {
            return None;
        }
        let images = |list: &[Vector]| if has_images { list.iter().map(WideVector::of).collect() } else { Vec::new() };
        let (generator_images, point_images) = (images(generators), images(points));
        let exactly = |(normal, reach)| Facet { normal, reach: OnceCell::from(reach), rounded: None };
        let facets = match dimension {
            2 => edges(generators.to_vec()).into_iter().map(exactly).collect(),
            _ if has_images => normals(dimension, generators)
                .map(|normal| {
                    let image = WideVector::of(&normal.exact);
                    let reach = image.reach(&generator_images, &normal.subset);
                    Facet { rounded: Some((image, reach)), reach: OnceCell::new(), normal: normal.exact }
                })
                .collect(),
            _ => subsets(generators.len(), dimension - 1)
                .filter_map(|facet| {
                    let span = Echelon::spanned(dimension, facet.iter().map(|&index| &generators[index]));
                    let [u] = <[Vector; 1]>::try_from(span.complement(dimension)).ok()?;
                    let reach = reach(generators, &u);
                    Some(exactly((u, reach)))
                })
                .collect(),
        };
        Some(Self { generators: generators.to_vec(), points: points.to_vec(), facets, point_images })
    }

    /// The number of facets.
    pub(crate) fn count(&self) -> usize {
        self.facets.len()
    }

    fn reach<'a>(&self, facet: &'a Facet) -> &'a IBig {
        facet.reach.get_or_init(|| reach(&self.generators, &facet.normal))
    }

    /// Bounds of |u · p| / Σ |u · g_i| for a facet and one of the points, where the facet is known in floating point.
    fn quotient(&self, facet: &Facet, point: usize) -> Option<[Wide; 2]> {
        let (normal, [low, high]) = facet.rounded.as_ref()?;
        let [least, most] = normal.along(&self.point_images[point]);
        Some([least.over(*high)?.moved(-QUOTIENT_ERROR), most.over(*low)?.moved(QUOTIENT_ERROR)])
    }

    /// Bounds of the gauge of one of the points, where floating point has any.
    pub(crate) fn gauge_bounds(&self, point: usize) -> Option<[Proportion; 2]> {
        let mut largest = [Wide::ZERO; 2];
        for facet in &self.facets {
            let own = self.quotient(facet, point)?;
            for (bound, own) in largest.iter_mut().zip(own) {
                if own.compare(*bound).is_gt() {
                    *bound = own;
                }
            }
        }
        Some(largest.map(Wide::exactly))
    }

    /// The largest of |u · p| / Σ |u · g_i| for one of the points.
    pub(crate) fn gauge(&self, point: usize) -> Proportion {
        let p = &self.points[point];
        let mut largest = (IBig::ZERO, IBig::ONE);
        if is_zero(p) {
            return Proportion::new(largest.0, largest.1, 0);
        }
        let bounds = |facet: &Facet| self.quotient(facet, point).map(|[low, high]| [high.negated(), low.negated()]);
        let mut rounded = Wide::ZERO;
        for facet in self.contenders(bounds) {
            let (along, reach) = (dot(&facet.normal, p).abs(), self.reach(facet));
            let Some(own) = Wide::of_whole(&along).over(Wide::of_whole(reach)) else { continue };
            // Products of long numbers take long, and are needed for quotients near each other alone.
            let is_less = own.moved(QUOTIENT_ERROR).compare(rounded).is_lt();
            if !is_less && &along * &largest.1 > &largest.0 * reach {
                largest = (along, reach.clone());
                rounded = own;
            }
        }
        Proportion::new(largest.0, largest.1, 0)
    }

    /// The least of (Σ |u · g_i| − |u · p|) / |u| for one of the points, which lies in the body; `None` without any
    /// facet.
    pub(crate) fn depth(&self, point: usize) -> Option<Length> {
        let p = &self.points[point];
        let bounds = |facet: &Facet| {
            let (normal, [low, high]) = facet.rounded.as_ref()?;
            let [least, most] = normal.along(&self.point_images[point]);
            let [shortest, longest] = normal.along(normal).map(Wide::root);
            // A difference is off by a part of the larger number, so that both are moved before.
            let [down, up] = [-QUOTIENT_ERROR, QUOTIENT_ERROR];
            let nearest = low.moved(down).minus(most.moved(up));
            let farthest = high.moved(up).minus(least.moved(down));
            let [by_low, by_high] = if nearest.mantissa() < 0.0 { [shortest, shortest] } else { [longest, shortest] };
            Some([nearest.over(by_low)?.moved(-QUOTIENT_ERROR), farthest.over(by_high)?.moved(QUOTIENT_ERROR)])
        };
        let depths = self.contenders(bounds).filter_map(|facet| {
            Length::along(&Proportion::whole(self.reach(facet) - dot(&facet.normal, p).abs(), 0), &facet.normal)
        });
        depths.reduce(|a, b| if b.compare_length(&a).is_lt() { b } else { a })
    }

    /// The facets at which a quantity may be least, given bounds of it.
    fn contenders(&self, bounds: impl Fn(&Facet) -> Option<[Wide; 2]>) -> impl Iterator<Item = &Facet> {
        let bounds: Vec<Option<[Wide; 2]>> = self.facets.iter().map(bounds).collect();
        let highs = bounds.iter().flatten().map(|[_, high]| *high);
        let least = highs.reduce(|a, b| if b.compare(a).is_lt() { b } else { a });
        // A facet without bounds may have the least.
        let may_be = move |bounds: Option<[Wide; 2]>| match (bounds, least) {
            (Some([low, _]), Some(least)) => low.compare(least).is_le(),
            _ => true,
        };
        self.facets.iter().zip(bounds).filter(move |(_, bounds)| may_be(*bounds)).map(|(facet, _)| facet)
    }
}

/// The support function Σ |u · g_i|.
pub(crate) fn reach(generators: &[Vector], u: &[IBig]) -> IBig {
    generators.iter().map(|generator| dot(u, generator).abs()).sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn vectors(rows: &[&[i64]]) -> Vec<Vector> {
        rows.iter().map(|row| row.iter().copied().map(IBig::from).collect()).collect()
    }

    #[test]
    fn gauges_and_depths_by_hand() {
        for extra in [0, 1_i64 << 60] {
            // a box of the sides 4, 6 and 8 or more
            let generators = vectors(&[&[2, 0, 0], &[0, 3, 0], &[0, 0, 4 + extra]]);
            let facets = Facets::of(3, &generators, &vectors(&[&[1, -2, 0], &[0, 0, 0], &[3, 3, 1]])).expect("few");
            let gauges = [0, 1, 2].map(|point| facets.gauge(point).nearest());
            assert_eq!((facets.count(), gauges), (3, [2.0 / 3.0, 0.0, 1.5]));
            assert_eq!(
                [0, 1].map(|point| facets.depth(point).map(|depth| depth.rounded_at(0))),
                [Some(1.0), Some(2.0)]
            );
        }
        let flat = Facets::of(1, &vectors(&[&[-2], &[1]]), &vectors(&[&[2]])).expect("few");
        assert_eq!((flat.gauge(0).nearest(), flat.depth(0).map(|depth| depth.rounded_at(0))), (2.0 / 3.0, Some(1.0)));
        assert!(Facets::of(0, &[], &[]).is_none());
    }

    /// The manual names this size.
    #[test]
    fn facets_are_gone_through_up_to_the_stated_size() {
        let trials = |count: usize| count_subsets(count, 2) * count as u64;
        assert!(trials(280) <= MOST_TRIALS && trials(300) > MOST_TRIALS);
    }

    /// Numbers of thousands of bits leave their images empty: whatever these do not decide is decided exactly.
    #[test]
    fn gauges_of_wide_numbers_are_exact() {
        let wide = |[x, y, z]: [i64; 3]| vec![IBig::from(x) << 3000, IBig::from(y) << 1500, IBig::from(z)];
        let generators = [[2, 0, 0], [0, 2, 0], [0, 0, 2], [1, 1, 1]].map(wide);
        let facets = Facets::of(3, &generators, &[[3, 0, 0], [0, 0, 1], [0, 6, 0]].map(wide)).expect("few");
        let brute = |p: &Vector| {
            let all = normals(3, &generators)
                .map(|n| Proportion::new(dot(&n.exact, p).abs(), reach(&generators, &n.exact), 0));
            all.reduce(|a, b| if b.compare(&a).is_gt() { b } else { a }).expect("there are facets")
        };
        for point in 0..3 {
            assert!(facets.gauge(point).compare(&brute(&facets.points[point])).is_eq(), "{point}");
        }
    }
}
