//! A centre in doubles from which zonotopes along the directions can contain the points.
//!
//! The centre must lie in the affine span of the points. If the directions span less than the whole space, few points
//! of doubles do. If they nearly do, the nearest point of doubles may be far in another measure: by how much it makes
//! the coefficients larger. So among the points of a grid in the affine span the nearest in that measure is sought, by
//! lattice reduction.

mod lattice;

use dashu_int::IBig;
use dashu_int::ops::BitTest;

use super::basis::{exact_inverse, long_basis};
use super::body::generators;
use crate::enclosing::fixed_directions::problem::FixedDirections;
use crate::enclosing::fixed_directions::scaled::{Scaled, Setting};
use crate::numeric::Rational;
use crate::numeric::dyadic::Dyadic;
use crate::numeric::exact_linear::{Span, rational, sum_of_products};
use crate::numeric::scaling::binary_exponent;

/// The grid of a small coordinate has at most this many bits below the last bit of the largest coordinate.
const EXTRA_BIT_LIMIT: i64 = 60;

/// At most this many grids are tried, each coarser than the one before, until the nearest point is one of doubles.
const GRID_LIMIT: usize = 8;

/// At most this many points of the problem are tried as the centre.
const TRIED_POINT_LIMIT: usize = 64;

/// The cost of a miss along a direction of weight zero, relative to the least positive weight of the basis.
const FREE_DIRECTION_SHARE: f64 = 1e-6;

/// The place that a centre should have in the affine span of the points, and the cost of missing it.
struct Target<'a, const D: usize> {
    problem: &'a FixedDirections<'a, D>,
    span: &'a Span,
    /// The place in the pivot coordinates of the span.
    place: Vec<Rational>,
    /// The independent rows of a linear map of the pivot coordinates. The cost of a miss is the length of its image.
    cost: Vec<Vec<Rational>>,
}

/// The first point, moved by a vector in scaled coordinates and rounded to the nearest doubles in its pivot
/// coordinates. If the directions do not span the space, it need not lie in the affine span of the points.
pub(in crate::enclosing::fixed_directions) fn nearest_doubles<const D: usize>(
    problem: &FixedDirections<'_, D>,
    scaled: &Scaled<D>,
    guess: &[f64; D],
) -> [f64; D] {
    let mut center = problem.points()[0];
    for (i, &c) in scaled.coordinates.iter().enumerate() {
        let shift = if guess[i].is_finite() { guess[i] } else { 0.0 };
        let exact = Dyadic::from_f64(center[c]) + Dyadic::from_f64(shift).scaled(scaled.exponent);
        center[c] = exact.to_f64().clamp(-f64::MAX, f64::MAX);
    }
    center
}

/// A point of doubles in the affine span of the points that costs little to take in place of an exact centre:
/// coefficients of a basis with long generators, enlarged by the difference, cost nearly the least.
pub(in crate::enclosing::fixed_directions) fn cheapest_center<const D: usize>(
    Setting { problem, scaled, span }: Setting<'_, D>,
    exact: &[Rational; D],
    coefficients: &[f64],
) -> [f64; D] {
    let basis = long_basis(problem, scaled, &generators(scaled, coefficients));
    let weights = basis.iter().map(|&b| rational(problem.weights()[scaled.directions[b].index]));
    let weights: Vec<Rational> = weights.collect();
    // A miss along a direction of weight zero costs little, but it costs something, so that the norm has no kernel.
    let least = weights.iter().filter(|w| !w.is_zero()).min();
    let free = least.map_or(Rational::ONE, |least| least * rational(FREE_DIRECTION_SHARE));
    let mut cost = exact_inverse(problem, scaled, &basis);
    for (row, weight) in cost.iter_mut().zip(&weights) {
        let weight = if weight.is_zero() { &free } else { weight };
        row.iter_mut().for_each(|entry| *entry *= weight);
    }
    let place = scaled.coordinates.iter().map(|&c| exact[c].clone()).collect();
    Target { problem, span, place, cost }.center()
}

impl<const D: usize> Target<'_, D> {
    /// The cheapest candidate for the centre: the point of the grid, or one of the first points of the problem.
    fn center(&self) -> [f64; D] {
        let miss = |center: &[f64; D]| {
            let image = self.image(&self.span.pivots().map(|c| rational(center[c])).collect::<Vec<_>>());
            let target = self.image(&self.place);
            image.iter().zip(&target).fold(Rational::ZERO, |sum, (a, b)| sum + (a - b) * (a - b))
        };
        let own = self.problem.points().iter().copied().take(TRIED_POINT_LIMIT);
        if let Some(exact) = self.exactly() {
            return exact;
        }
        let candidates = self.on_a_grid().into_iter().chain(own).map(|center| (miss(&center), center));
        let least = candidates.reduce(|a, b| if b.0 < a.0 { b } else { a });
        least.map_or(self.problem.points()[0], |(_, center)| center)
    }

    /// The image of a vector in pivot coordinates under the cost's linear map.
    fn image(&self, coordinates: &[Rational]) -> Vec<Rational> {
        self.cost.iter().map(|row| sum_of_products(row, coordinates)).collect()
    }

    /// The place itself, if it is a point of doubles.
    fn exactly(&self) -> Option<[f64; D]> {
        let exact = self.exact_place();
        let rounded: [f64; D] = std::array::from_fn(|c| exact[c].to_f64_fast());
        let is_double = |c: usize| rounded[c].is_finite() && rational(rounded[c]) == exact[c];
        (0..D).all(is_double).then_some(rounded)
    }

    /// The place in the coordinates of space.
    fn exact_place(&self) -> [Rational; D] {
        let first = self.problem.points()[0].map(rational);
        let shift: Vec<Rational> = self.place.iter().zip(self.span.pivots()).map(|(p, c)| p - &first[c]).collect();
        let lifted = self.span.member(&shift);
        std::array::from_fn(|c| &first[c] + &lifted[c])
    }

    /// The point nearest to the place, of the finest grid for which it is a point of doubles.
    fn on_a_grid(&self) -> Option<[f64; D]> {
        let first = self.problem.points()[0].map(rational);
        let exact = self.exact_place();
        let exponents: [i64; D] = std::array::from_fn(|c| {
            let place = exact[c].to_f64_fast();
            binary_exponent(place.clamp(-f64::MAX, f64::MAX)).map_or(LEAST_EXPONENT, i64::from)
        });
        let top = exponents.into_iter().max().unwrap_or(LEAST_EXPONENT);
        let mut exponents = exponents.map(|e| (e.max(top - EXTRA_BIT_LIMIT) - 52).max(LEAST_EXPONENT));
        let zeros = self.span.annihilators();
        for _ in 0..GRID_LIMIT {
            let units = exponents.map(|e| Dyadic::new(IBig::ONE, e).to_rational());
            let rows = zeros.iter().map(|zero| {
                let right = -sum_of_products(zero, &first);
                whole([zero.iter().zip(&units).map(|(a, unit)| a * unit).chain([right]).collect()]).swap_remove(0)
            });
            let cost =
                self.cost.iter().map(|row| row.iter().zip(self.span.pivots()).map(|(a, c)| a * &units[c]).collect());
            // The cost and the target are made whole together, by the same multiple.
            let mut cost: Vec<Vec<IBig>> = whole(cost.chain([self.image(&self.place)]));
            let target = cost.pop()?;
            let image = |x: &[IBig]| {
                let entry = |row: &Vec<IBig>| {
                    row.iter().zip(self.span.pivots()).fold(IBig::ZERO, |sum, (a, c)| sum + a * &x[c])
                };
                cost.iter().map(entry).collect()
            };
            let found = lattice::near(D, &rows.collect::<Vec<_>>(), image, &target)?;
            let exact: [Dyadic; D] = std::array::from_fn(|c| Dyadic::new(found[c].clone(), exponents[c]));
            let rounded: [f64; D] = std::array::from_fn(|c| exact[c].to_f64());
            let is_double = |c: usize| rounded[c].is_finite() && rational(rounded[c]) == exact[c].to_rational();
            if (0..D).all(is_double) {
                return Some(rounded);
            }
            for c in (0..D).filter(|&c| !is_double(c)) {
                exponents[c] += (found[c].bit_len() as i64 - 53).max(1);
            }
        }
        None
    }
}

/// The exponent of the least denormal number.
const LEAST_EXPONENT: i64 = -1074;

/// All numbers times the least common multiple of their denominators.
fn whole(rows: impl IntoIterator<Item = Vec<Rational>>) -> Vec<Vec<IBig>> {
    let rows: Vec<Vec<Rational>> = rows.into_iter().collect();
    let multiple = rows.iter().flatten().fold(Rational::ONE, |multiple, v| {
        let denominator = (v * &multiple).denominator().clone();
        multiple * Rational::from(denominator)
    });
    let whole = |v: &Rational| (v * &multiple).into_parts().0;
    rows.iter().map(|row| row.iter().map(whole).collect()).collect()
}
