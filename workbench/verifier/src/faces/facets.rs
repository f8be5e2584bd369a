//! All facets of a small zonotope with an interior, and how points lie relative to them: the gauge and the depth.
//!
//! The facet that decides is sought in floating point with bounds of its error; only facets that may be the one are
//! gone through exactly.

use std::cell::OnceCell;

use dashu_int::IBig;
use dashu_int::ops::{Abs, BitTest};

use crate::exact::length::Length;
use crate::exact::linear::{Echelon, Vector, dot, is_zero};
use crate::exact::proportion::Proportion;
use crate::exact::subsets::{count_subsets, subsets};
use crate::exact::turns::edges;
use crate::faces::normals::{
    DOT_ERROR, Image, MOST_COORDINATES, UNDERFLOW, image_dot, image_size, images, normals, reach_bounds,
};

/// The number of products of facets and generators that are tried where the certificate does not name the facet.
const MOST_TRIALS: u64 = 3_000_000;

/// A relative bound for what the quotient of two bounds, and the root of a sum of squares, lose by rounding.
const QUOTIENT_ERROR: f64 = 16.0 * f64::EPSILON;

/// A body with an interior, all its facets, one of each pair of opposite ones, and points.
pub(crate) struct Facets {
    generators: Vec<Vector>,
    points: Vec<Vector>,
    facets: Vec<Facet>,
    /// The images of the points, to the same scale as those of the generators, in dimensions that have images.
    point_images: Vec<Image>,
}

struct Facet {
    normal: Vector,
    /// Σ |u · g_i| for the normal u, where it has been needed.
    reach: OnceCell<IBig>,
    /// The normal, and bounds of Σ |u · g_i| to the scale of the images, in dimensions that have images.
    rounded: Option<(Image, [f64; 2])>,
}

impl Facets {
    /// All facets, unless they are too many.
    pub(crate) fn of(dimension: usize, generators: &[Vector], points: &[Vector]) -> Option<Self> {
        let trials = count_subsets(generators.len(), dimension.checked_sub(1)?);
        if dimension != 2 && trials.saturating_mul(generators.len() as u64) > MOST_TRIALS {
            return None;
        }
        let has_images = (3..=MOST_COORDINATES).contains(&dimension);
        let all: Vec<Vector> = generators.iter().chain(points).cloned().collect();
        let all = if has_images { images(&all) } else { Vec::new() };
        let (generator_images, point_images) = all.split_at(if has_images { generators.len() } else { 0 });
        let exactly = |(normal, reach)| Facet { normal, reach: OnceCell::from(reach), rounded: None };
        let facets = match dimension {
            2 => edges(generators.to_vec()).into_iter().map(exactly).collect(),
            _ if has_images => normals(dimension, generators)
                .map(|normal| Facet {
                    rounded: Some((normal.image, reach_bounds(&normal, generator_images))),
                    reach: OnceCell::new(),
                    normal: normal.exact,
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
        Some(Self {
            generators: generators.to_vec(),
            points: points.to_vec(),
            facets,
            point_images: point_images.to_vec(),
        })
    }

    /// The number of facets.
    pub(crate) fn count(&self) -> usize {
        self.facets.len()
    }

    fn reach<'a>(&self, facet: &'a Facet) -> &'a IBig {
        facet.reach.get_or_init(|| reach(&self.generators, &facet.normal))
    }

    /// The largest of |u · p| / Σ |u · g_i| for one of the points.
    pub(crate) fn gauge(&self, point: usize) -> Proportion {
        let p = &self.points[point];
        let mut largest = (IBig::ZERO, IBig::ONE);
        if is_zero(p) {
            return Proportion::new(largest.0, largest.1, 0);
        }
        let bounds = |facet: &Facet| {
            let (normal, [low, high]) = facet.rounded.as_ref()?;
            let (along, doubt) = self.along(normal, point);
            let most = if *low > 0.0 { (along + doubt) / low * (1.0 + QUOTIENT_ERROR) } else { f64::INFINITY };
            Some([(along - doubt).max(0.0) / high * (1.0 - QUOTIENT_ERROR), most])
        };
        let mut rounded = (0.0, 0);
        for facet in self.contenders(|facet| bounds(facet).map(|[low, high]| [-high, -low])) {
            let (along, reach) = (dot(&facet.normal, p).abs(), self.reach(facet));
            let own = rounded_quotient(&along, reach);
            // Products of long numbers take long, and are needed for quotients near each other alone.
            if !is_surely_less(own, rounded) && &along * &largest.1 > &largest.0 * reach {
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
            let (along, doubt) = self.along(normal, point);
            let length = image_dot(normal, normal).sqrt();
            let room = doubt + (high + along) * QUOTIENT_ERROR + UNDERFLOW;
            Some([(low - along - room) / length, (high - along + room) / length])
        };
        let depths = self.contenders(bounds).filter_map(|facet| {
            Length::along(&Proportion::whole(self.reach(facet) - dot(&facet.normal, p).abs(), 0), &facet.normal)
        });
        depths.reduce(|a, b| if b.compare_length(&a).is_lt() { b } else { a })
    }

    /// |u · p| for the image of a normal, and by how much it may be off.
    fn along(&self, normal: &Image, point: usize) -> (f64, f64) {
        let image = &self.point_images[point];
        (image_dot(normal, image).abs(), image_size(normal, image) * DOT_ERROR + UNDERFLOW)
    }

    /// The facets at which a quantity may be least, given bounds of it.
    fn contenders(&self, bounds: impl Fn(&Facet) -> Option<[f64; 2]>) -> impl Iterator<Item = &Facet> {
        let lows: Vec<f64> = self.facets.iter().map(|facet| bounds(facet).map_or(f64::NAN, |[low, _]| low)).collect();
        let highs = self.facets.iter().filter_map(bounds).map(|[_, high]| high);
        let least = highs.filter(|high| !high.is_nan()).fold(f64::INFINITY, f64::min);
        // Whatever does not compare may be the least.
        let may_be = move |low: f64| low.is_nan() || low <= least;
        self.facets.iter().zip(lows).filter(move |(_, low)| may_be(*low)).map(|(facet, _)| facet)
    }
}

/// The quotient of two whole numbers that are not negative as m · 2^e, m within a few roundings and 0 or from 1/4 to 4.
fn rounded_quotient(numerator: &IBig, denominator: &IBig) -> (f64, i64) {
    let leading = |number: &IBig| {
        let dropped = number.bit_len().saturating_sub(64);
        let kept = (number >> dropped).to_f64().value();
        // Long numbers keep 64 bits, short ones are whole.
        let length = number.bit_len() - dropped;
        (kept / 2.0_f64.powi(length as i32), (dropped + length) as i64)
    };
    let ((above, up), (below, down)) = (leading(numerator), leading(denominator));
    (above / below, up - down)
}

/// Whether a quotient is less than another one, beyond all doubt of rounding.
fn is_surely_less(a: (f64, i64), b: (f64, i64)) -> bool {
    let apart = (a.1 - b.1).clamp(-1_000, 1_000) as i32;
    a.0 * 2.0_f64.powi(apart) < b.0 * (1.0 - 64.0 * f64::EPSILON)
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
