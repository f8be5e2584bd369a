//! Whether a zonotope lies within a distance of another one: every vertex of it has a point of the other that near.
//!
//! The distance from a convex body is a convex function, so nowhere on a zonotope is it larger than at its farthest
//! vertex. A vertex has the signs of a direction in general position; next to the normal u of a facet these are the
//! signs of u · g_i, and any signs for the generators of the facet itself: those that belong to no vertex belong to
//! points of the zonotope, which may be looked at as well. Coefficients of a near point of the other zonotope are
//! sought in floating point; the point that they name, and its distance, are exact. Where none is found, the direction
//! in which the search ended may prove that the vertex is farther away.

use std::cmp::Ordering;
use std::collections::BTreeSet;

use dashu_int::IBig;
use dashu_int::ops::BitTest;

use crate::RELATIVE_ERROR;
use crate::exact::fraction::Fraction;
use crate::exact::length::root;
use crate::exact::linear::{Echelon, Vector, dot};
use crate::exact::proportion::Proportion;
use crate::exact::subsets::count_subsets;
use crate::exact::whole_direction;
use crate::faces::facets::reach;
use crate::faces::normals::{Image, MOST_COORDINATES, image_dot, images, normals, side};
use crate::verdict::Stop;

/// So many pairs of a facet and a generator are gone through for the vertices of a zonotope.
const MOST_PAIRS: u64 = 3_000_000;

/// So many pairs of a vertex and a generator of the other zonotope are gone through.
const MOST_PRODUCTS: usize = 3_000_000;

/// Of a facet of more generators not all signs are tried.
const MOST_IN_A_FACET: usize = 8;

/// The search for a near point ends after so many rounds over all coefficients.
const MOST_ROUNDS: usize = 400;

/// Coefficients are whole multiples of 2^-COEFFICIENT_BITS.
const COEFFICIENT_BITS: usize = 45;

/// Two zonotopes in whole numbers of a unit, the first to lie within a distance of the second.
pub(super) struct Within<'a> {
    /// From the centre of the second to that of the first.
    pub(super) offset: &'a Vector,
    pub(super) first: &'a [Vector],
    pub(super) second: &'a [Vector],
    /// The exponent of the unit.
    pub(super) exponent: i32,
}

impl Within<'_> {
    /// Proves that every point of the first zonotope is at most so far from the second, up to rounding.
    pub(super) fn check(&self, distance: f64) -> Result<(), Stop> {
        if distance == f64::INFINITY {
            return Ok(());
        }
        let vertices = self.vertices().ok_or_else(|| Stop::Unchecked("too many vertices to try".to_owned()))?;
        if vertices.len().saturating_mul(self.second.len()) > MOST_PRODUCTS {
            return Err(Stop::Unchecked("too many vertices to try".to_owned()));
        }
        let allowed = Proportion::of_double(distance).times(&Proportion::of_double(1.0 + RELATIVE_ERROR));
        let points: Vec<Vector> = vertices.iter().map(|signs| self.point(signs)).collect();
        let all: Vec<Vector> = points.iter().chain(self.second).cloned().collect();
        let largest = all.iter().flatten().map(|c| c.bit_len()).max().unwrap_or(0);
        let all = images(&all);
        let (point_images, generators) = all.split_at(points.len());
        // Images are in units of the power of two above all components.
        let unit = Proportion::whole(IBig::ONE, -self.exponent - largest as i32);
        let limit = Limit { rounded: allowed.times(&unit).nearest(), exact: allowed };
        points
            .iter()
            .zip(point_images)
            .try_for_each(|(point, image)| self.check_point(point, image, generators, &limit))
    }

    /// The signs of all vertices, and perhaps of more points; `None` if they are too many. Opposite ones count once
    /// where both zonotopes have the same centre.
    fn vertices(&self) -> Option<BTreeSet<Vec<i8>>> {
        let dimension = self.offset.len();
        let span = Echelon::spanned(dimension, self.first);
        let (rank, pivots) = (span.rank(), span.pivots());
        if rank == 0 {
            return Some(BTreeSet::from([vec![1; self.first.len()]]));
        }
        let count = self.first.len();
        if dimension > MOST_COORDINATES || count_subsets(count, rank - 1).saturating_mul(count as u64) > MOST_PAIRS {
            return None;
        }
        let seen: Vec<Vector> =
            self.first.iter().map(|v| pivots.iter().map(|&axis| v[axis].clone()).collect()).collect();
        let seen_images = images(&seen);
        let opposites: &[i8] = if self.offset.iter().all(|c| *c == IBig::ZERO) { &[1] } else { &[1, -1] };
        let mut vertices = BTreeSet::new();
        for normal in normals(rank, &seen) {
            let sides: Vec<i8> =
                seen.iter().zip(&seen_images).map(|(exact, image)| side(&normal, exact, image)).collect();
            let open: Vec<usize> = (0..count).filter(|&index| sides[index] == 0).collect();
            if open.len() > MOST_IN_A_FACET {
                return None;
            }
            for choice in 0..1_usize << open.len() {
                for &opposite in opposites {
                    let mut signs: Vec<i8> = sides.iter().map(|side| side * opposite).collect();
                    for (place, &index) in open.iter().enumerate() {
                        signs[index] = if choice >> place & 1 == 1 { 1 } else { -1 };
                    }
                    vertices.insert(signs);
                    if vertices.len().saturating_mul(self.second.len()) > MOST_PRODUCTS {
                        return None;
                    }
                }
            }
        }
        Some(vertices)
    }

    /// The point of the first zonotope with these signs, relative to the centre of the second.
    fn point(&self, signs: &[i8]) -> Vector {
        let mut point = self.offset.clone();
        for (generator, &sign) in self.first.iter().zip(signs) {
            for (sum, c) in point.iter_mut().zip(generator) {
                if sign > 0 { *sum += c } else { *sum -= c }
            }
        }
        point
    }

    /// Proves that the second zonotope has a point near enough to one of the first.
    fn check_point(&self, point: &Vector, image: &Image, generators: &[Image], limit: &Limit) -> Result<(), Stop> {
        let mut search = Nearest::new(*image, generators);
        for round in 0..MOST_ROUNDS {
            let gained = search.round();
            let is_last = !gained || round + 1 == MOST_ROUNDS;
            let length = image_dot(&search.rest, &search.rest).sqrt();
            let may_be_near = is_last || length <= limit.rounded;
            if may_be_near && self.is_near(point, &search.coefficients, &limit.exact) {
                return Ok(());
            }
            let may_be_far = is_last || round.is_power_of_two() && search.gap(image) > limit.rounded * length;
            if may_be_far && self.is_far(point, &search.rest, &limit.exact) {
                return Err("the bodies are farther apart than the upper bound".into());
            }
            if is_last {
                break;
            }
        }
        Err(Stop::Unchecked("no near point is found for a vertex".to_owned()))
    }

    /// Whether the point of the second zonotope with these coefficients, rounded, is at most so far away.
    fn is_near(&self, point: &Vector, coefficients: &[f64], allowed: &Proportion) -> bool {
        let one = (1_u64 << COEFFICIENT_BITS) as f64;
        let mut rest: Vector = point.iter().map(|c| c << COEFFICIENT_BITS).collect();
        for (generator, coefficient) in self.second.iter().zip(coefficients) {
            let whole = IBig::from((coefficient * one).round() as i64);
            for (rest, c) in rest.iter_mut().zip(generator) {
                *rest -= &whole * c;
            }
        }
        let exponent = self.exponent - COEFFICIENT_BITS as i32;
        let [_, length] = root(&dot(&rest, &rest));
        length.times(&Proportion::whole(IBig::ONE, exponent)).compare(allowed) != Ordering::Greater
    }

    /// Whether a plane orthogonal to a direction proves that the point is farther away.
    fn is_far(&self, point: &Vector, direction: &Image, allowed: &Proportion) -> bool {
        let exact: Option<Vec<Fraction>> = direction[..point.len()].iter().map(|&c| Fraction::of_double(c)).collect();
        let u = whole_direction(&exact.unwrap_or_default());
        let [_, length] = root(&dot(&u, &u));
        let gap = dot(&u, point) - reach(self.second, &u);
        let unit = Proportion::whole(IBig::ONE, self.exponent);
        let proved = Proportion::whole(gap, 0).times(&unit).over(&length);
        proved.is_some_and(|proved| proved.compare(allowed) == Ordering::Greater)
    }
}

/// The largest distance that is allowed.
struct Limit {
    exact: Proportion,
    /// The same in the units of images.
    rounded: f64,
}

/// The search for the point Σ δ_i g_i, |δ_i| ≤ 1, that is nearest to a point: one coefficient after the other.
struct Nearest<'a> {
    generators: &'a [Image],
    squares: Vec<f64>,
    coefficients: Vec<f64>,
    /// The point without Σ δ_i g_i.
    rest: Image,
}

impl<'a> Nearest<'a> {
    /// Begins with the vertex that lies farthest towards the point.
    fn new(point: Image, generators: &'a [Image]) -> Self {
        let towards = |g: &Image| if image_dot(g, &point) < 0.0 { -1.0 } else { 1.0 };
        let coefficients: Vec<f64> = generators.iter().map(towards).collect();
        let squares = generators.iter().map(|g| image_dot(g, g)).collect();
        let mut rest = point;
        for (g, coefficient) in generators.iter().zip(&coefficients) {
            subtract(&mut rest, *coefficient, g);
        }
        Self { generators, squares, coefficients, rest }
    }

    /// By how much the point is beyond all Σ δ_i g_i along what is left of it, times the length of that.
    fn gap(&self, point: &Image) -> f64 {
        let reach: f64 = self.generators.iter().map(|g| image_dot(g, &self.rest).abs()).sum();
        image_dot(point, &self.rest) - reach
    }

    /// Improves each coefficient once; whether one of them changed.
    fn round(&mut self) -> bool {
        let mut has_changed = false;
        for ((g, square), coefficient) in self.generators.iter().zip(&self.squares).zip(&mut self.coefficients) {
            if *square == 0.0 {
                continue;
            }
            let better = (*coefficient + image_dot(g, &self.rest) / square).clamp(-1.0, 1.0);
            if better != *coefficient {
                subtract(&mut self.rest, better - *coefficient, g);
                *coefficient = better;
                has_changed = true;
            }
        }
        has_changed
    }
}

fn subtract(from: &mut Image, factor: f64, vector: &Image) {
    for (slot, c) in from.iter_mut().zip(vector) {
        *slot -= factor * c;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn vectors(rows: &[&[i64]]) -> Vec<Vector> {
        rows.iter().map(|row| row.iter().copied().map(IBig::from).collect()).collect()
    }

    fn check(offset: &[i64], first: &[&[i64]], second: &[&[i64]], distance: f64) -> Result<(), Stop> {
        let (offset, first, second) = (vectors(&[offset]).remove(0), vectors(first), vectors(second));
        Within { offset: &offset, first: &first, second: &second, exponent: 0 }.check(distance)
    }

    fn is_wrong(outcome: Result<(), Stop>) -> bool {
        matches!(outcome, Err(Stop::Wrong(_)))
    }

    #[test]
    fn squares_and_cubes_by_hand() {
        let [small, large]: [[&[i64]; 2]; 2] = [[&[1, 0], &[0, 1]], [&[2, 0], &[0, 2]]];
        let root = 2.0_f64.sqrt();
        assert!(check(&[0, 0], &large, &small, root).is_ok());
        assert!(is_wrong(check(&[0, 0], &large, &small, root * (1.0 - 1e-10))));
        assert!(check(&[0, 0], &small, &large, 0.0).is_ok(), "it is inside");
        assert!(check(&[3, 0], &small, &large, 2.0).is_ok());
        assert!(is_wrong(check(&[3, 0], &small, &large, 1.9)));
        let cube: [&[i64]; 3] = [&[1, 0, 0], &[0, 1, 0], &[0, 0, 1]];
        assert!(check(&[0, 0, 0], &cube, &[], 3.0_f64.sqrt()).is_ok(), "a corner of the cube");
        assert!(is_wrong(check(&[0, 0, 0], &cube, &[], 1.73)));
        assert!(check(&[0, 0, 0], &cube, &cube, 0.0).is_ok());
        assert!(check(&[0, 0, 0], &cube, &[], f64::INFINITY).is_ok());
    }

    #[test]
    fn facets_of_several_generators_and_flat_bodies() {
        // a hexagonal prism around its axis: the corners of the hexagon are at (2, 2), (2, 0), (0, 2), …
        let prism: [&[i64]; 4] = [&[1, 0, 0], &[0, 1, 0], &[1, 1, 0], &[0, 0, 5]];
        let axis: [&[i64]; 1] = [&[0, 0, 5]];
        assert!(check(&[0, 0, 0], &prism, &axis, 8.0_f64.sqrt()).is_ok());
        assert!(is_wrong(check(&[0, 0, 0], &prism, &axis, 2.8)));
        let segment: [&[i64]; 2] = [&[1, 1, 0], &[2, 2, 0]];
        assert!(check(&[0, 0, 1], &segment, &segment, 1.0).is_ok());
        assert!(is_wrong(check(&[0, 0, 1], &segment, &segment, 0.99)));
        assert!(check(&[0, 3], &[], &[&[0, 1]], 2.0).is_ok());
    }

    #[test]
    fn what_takes_too_long_is_left_open() {
        let many: Vec<Vector> = (0..3000).map(|i| vec![IBig::from(i), IBig::from(i * i), IBig::ONE]).collect();
        let offset = vec![IBig::ZERO; 3];
        let within = Within { offset: &offset, first: &many, second: &many, exponent: 0 };
        assert!(matches!(within.check(1.0), Err(Stop::Unchecked(_))));
    }
}
