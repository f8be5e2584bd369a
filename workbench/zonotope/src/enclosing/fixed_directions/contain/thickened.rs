//! Coefficients for points near the boundary of a zonotope that may be flat, or nearly so.
//!
//! If a point is off the plane of a flat zonotope by no more than rounding, its ray leaves the zonotope at the centre,
//! although coefficients reach the point but for that rounding. So where a ray leaves before its point, the search is
//! repeated with the shortest generators of a basis lengthened, step by step. The coefficients found are used with the
//! zonotope as it is.

use crate::numeric::linear::dot;
use crate::zonotope::ray_exit::{Facet, FacetDescent};

/// A zonotope and thickened versions of it, each with its own search for facets.
pub(crate) struct Thickened<'a, const D: usize> {
    rank: usize,
    generators: &'a [[f64; D]],
    /// The generators that are thickened, as vectors of length 1.
    basis: Vec<(usize, [f64; D])>,
    /// For each step the least length of a generator of the basis; zero for the first.
    least: Vec<f64>,
    descents: Vec<FacetDescent<D>>,
}

/// The first least length that is tried, relative to the longest generator.
const FIRST_RELATIVE_LENGTH: f64 = 1e-13;

/// The factor by which each least length exceeds the one before.
const LENGTH_GROWTH: f64 = 16.0;

/// No least length above this is tried, relative to the longest generator.
const LAST_RELATIVE_LENGTH: f64 = 1e-3;

impl<'a, const D: usize> Thickened<'a, D> {
    /// The zonotope of generators, thickened along a basis: generators' indices with vectors along them, which the
    /// generators of length zero take their directions from.
    pub(crate) fn new(rank: usize, generators: &'a [[f64; D]], basis: impl Iterator<Item = (usize, [f64; D])>) -> Self {
        let length = |v: &[f64; D]| dot(v, v).sqrt();
        let longest = generators.iter().map(length).fold(0.0, f64::max);
        let unit = |v: [f64; D]| {
            let l = length(&v);
            v.map(|c| c / l)
        };
        let basis: Vec<(usize, [f64; D])> = basis.map(|(b, v)| (b, unit(v))).collect();
        let shortest = basis.iter().map(|(b, _)| length(&generators[*b])).fold(f64::INFINITY, f64::min);
        let factors = std::iter::successors(Some(FIRST_RELATIVE_LENGTH), |f| Some(f * LENGTH_GROWTH))
            .take_while(|f| *f <= LAST_RELATIVE_LENGTH);
        let least = std::iter::once(0.0).chain(factors.map(|f| f * longest).filter(|l| shortest < *l)).collect();
        Self { rank, generators, basis, least, descents: Vec::new() }
    }

    /// The number of zonotopes, the given one and the thickened ones.
    pub(crate) fn steps(&self) -> usize {
        self.least.len()
    }

    /// What [`FacetDescent::facet`] finds for one of the zonotopes, of which the first is the given one.
    pub(crate) fn facet(&mut self, step: usize, point: &[f64; D]) -> Option<Facet<D>> {
        while self.descents.len() <= step {
            let least = self.least[self.descents.len()];
            let mut generators = self.generators.to_vec();
            for (b, unit) in &self.basis {
                let generator = &mut generators[*b];
                if dot(generator, generator).sqrt() < least {
                    *generator = unit.map(|c| c * least);
                }
            }
            self.descents.push(FacetDescent::new(self.rank, &generators));
        }
        self.descents[step].facet(point)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_point_that_leaves_the_plane_of_a_square_by_rounding() {
        let generators = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0; 3]];
        let basis = [(0, [1.0, 0.0, 0.0]), (1, [0.0, 1.0, 0.0]), (2, [0.0, 0.0, 2.0])];
        let mut thickened = Thickened::new(3, &generators, basis.into_iter());
        let point = [0.5, 0.5, 1e-16];
        assert!(thickened.facet(0, &point).is_none_or(|facet| facet.reach < 1e-3));
        let facet = thickened.facet(1, &point).expect("they span");
        assert!((facet.reach - 2.0).abs() < 1e-12);
        assert!(facet.coefficients[..2].iter().all(|c| (c - 1.0).abs() < 1e-12));
        assert_eq!(Thickened::new(3, &basis.map(|(_, v)| v), basis.into_iter()).steps(), 1);
    }
}
