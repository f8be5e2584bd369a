//! The Hausdorff distance of two zonotopes, at the vertices of each: exactly, for bodies of few of them.
//!
//! # Statement
//! Input: two zonotopes A, B in R^D. Output: their Hausdorff distance, or for one side the largest distance of a point
//! of A from B: the double nearest to it, the least one that is not below it, and a direction of doubles with the
//! greatest double that is not above the difference of the support functions along it. `None` if the bodies have too
//! many vertices for that ([`VERTEX_PRODUCT_LIMIT`]), or too many that are nearly equally far. Flat bodies, zero and
//! parallel generators, equal and nearly equal bodies are ordinary input.
//!
//! # Source
//! Not in the paper. The distance from a convex body is a convex function, so on a polytope it is largest at a vertex.
//!
//! # Method
//! 1. Leave out what both bodies have (`ExactDifference`): the difference of the support functions is that of the
//!    two bodies that are left, and so is its maximum.
//! 2. List the vertices of the one body by the signs of its generators, exactly. Of vertices opposite to each other one
//!    is enough if both bodies have the same centre.
//! 3. Find the nearest point of the other body to each vertex in doubles (`NearestPoint`): as any of its points is,
//!    it is an upper bound on the vertex's distance, up to rounding.
//! 4. Beginning with the vertex of the greatest bound, find the nearest point anew in pairs of doubles, which makes the
//!    bound far tighter where the bodies are nearly equal, and where it still is the greatest in rationals; until no
//!    bound of the vertices left exceeds the largest distance met. Then the same the other way round.
//!
//! # Complexity
//! v vertices of n generators in all, rank r: O(n^r) exact operations to list them and O(v n) products a step of the
//! searches, of which a vertex takes some more than there are coefficients that change. Only the few vertices that are
//! about as far as the farthest are looked at in pairs of doubles, of bodies that differ by as little as rounding all;
//! in rationals only those that pairs of doubles cannot tell from the farthest. The operations in rationals are counted
//! and limited ([`EXACT_OPERATION_LIMIT`]).
//!
//! # Shapes
//! `generators`: half-segments, any order.
//!
//! # Numerics
//! The square of the distance is a fraction, and its root is rounded once. The lower bound is below it by what rounding
//! the direction costs: nothing if its whole numbers are doubles, some units in the last place in general, and much of
//! it where the bodies differ by no more than rounding themselves.
//!
//! # Checked by
//! [`brute_force`](super::brute_force).
//!
//! # Example
//! ```
//! use zonotope::{Zonotope, reduction::hausdorff::by_vertices::hausdorff_at_vertices};
//! let square = Zonotope::new([0.0, 0.0], vec![[1.0, 0.0], [0.0, 1.0]])?;
//! let point = Zonotope::new([4.0, 5.0], vec![])?;
//! // the corner (−1, −1) is (5, 6) from the point
//! let distance = hausdorff_at_vertices(&square, &point).expect("they have five vertices");
//! assert_eq!(distance.value, 61f64.sqrt());
//! assert!(distance.lower < distance.upper && distance.lower.next_up() == distance.upper);
//! # Ok::<(), zonotope::ZonotopeError>(())
//! ```

use std::array;
use std::cmp::Ordering;
use std::collections::BinaryHeap;

use dashu_int::IBig;

use super::answer::Distance;
use super::exact_difference::ExactDifference;
use super::nearest_point::{Coefficient, NearestPoint};
use super::vertex::{Vertex, is_positive, pair, vertex};
use crate::numeric::Rational;
use crate::numeric::double_double::DoubleDouble;
use crate::numeric::dyadic::{Dyadic, remove_common_factor};
use crate::numeric::exact_linear::root::Root;
use crate::numeric::exact_linear::{Span, rational};
use crate::numeric::linear::sum_of_products;
use crate::numeric::tolerance::{LONG_SUM, PRODUCT_UNDERFLOW, SUM_OF_PAIRS, THIRTY_ROUNDINGS, UNIT};
use crate::zonotope::Zonotope;
use crate::zonotope::faces::by_recursion::vertices_of;

/// Pairs of a vertex of one body and a generator of either, of both sides, up to which this method answers: those of
/// bodies of some hundred facets.
pub const VERTEX_PRODUCT_LIMIT: u64 = 1 << 15;

/// Operations in rationals of some hundred bits up to which this method answers: more of them are needed only where
/// many vertices are equally far, or coordinates of many sizes.
pub const EXACT_OPERATION_LIMIT: u64 = 1 << 18;

/// The bits of a coordinate for which an operation in rationals counts once more.
const BITS_PER_OPERATION: i64 = 128;

/// Roundings of the farthest vertex's direction that are tried: generators of which the exact one is orthogonal to some
/// hide a distance as small as what rounding moves it by.
const ROUNDED_DIRECTIONS: u32 = 64;

/// The part of the distance that a direction proves with which no other one is tried.
const GOOD_DIRECTION: f64 = 1.0 - 1e-6;

/// Roundings of a sum beside one for each term.
const FURTHER_ROUNDINGS: f64 = 32.0;

/// The Hausdorff distance; `None` if the bodies have too many vertices, or too many that are equally far.
#[inline(never)]
pub fn hausdorff_at_vertices<const D: usize>(a: &Zonotope<D>, b: &Zonotope<D>) -> Option<Distance<D>> {
    farthest(&ExactDifference::new(a, b), &[0, 1])
}

/// The largest distance of a point of `body` from `other`; `None` in the same cases.
pub fn excess_at_vertices<const D: usize>(body: &Zonotope<D>, other: &Zonotope<D>) -> Option<Distance<D>> {
    farthest(&ExactDifference::new(body, other), &[0])
}

/// The largest distance of a vertex of one side, or of either, from the other body.
pub(super) fn farthest<const D: usize>(difference: &ExactDifference<D>, sides: &[usize]) -> Option<Distance<D>> {
    let products = sides.iter().map(|&side| vertex_products(difference, side));
    if products.fold(0, u64::saturating_add) > VERTEX_PRODUCT_LIMIT {
        return None;
    }
    let numbers = Numbers::new(difference);
    let mut farthest = Farthest { square: Rational::ZERO, vector: array::from_fn(|_| Rational::ZERO) };
    let mut left = EXACT_OPERATION_LIMIT;
    for &side in sides {
        numbers.look_at_vertices(&difference.generators[side], side, &mut farthest, &mut left)?;
    }
    Some(numbers.distance(&farthest))
}

/// A bound on the number of vertices of one side times that of generators, and on the products of a normal and a
/// generator that it takes to list them.
fn vertex_products<const D: usize>(difference: &ExactDifference<D>, side: usize) -> u64 {
    let [own, others] = [side, 1 - side].map(|side| difference.generators[side].len() as u64);
    let rank = Span::of(difference.generators[side].iter().cloned(), D).rank() as u64;
    // 2 Σ C(n − 1, k) for k < r
    let (mut vertices, mut term) = (0u64, 2u64);
    for k in 0..rank {
        vertices = vertices.saturating_add(term);
        term = term.saturating_mul((own - 1).saturating_sub(k)) / (k + 1);
    }
    vertices.max(1).saturating_mul(own + others)
}

/// Both bodies in doubles of ordinary size and in whole numbers.
struct Numbers<const D: usize> {
    rounded: [Vec<[f64; D]>; 2],
    rounded_displacement: [f64; D],
    pairs: [Vec<[DoubleDouble; D]>; 2],
    displacement_in_pairs: [DoubleDouble; D],
    whole: [Vec<[Rational; D]>; 2],
    whole_displacement: [Rational; D],
    is_concentric: bool,
    /// The exponent of the unit of the whole numbers, and that of the doubles.
    unit: i64,
    scale: i64,
    /// A bound on the errors of a distance from a point of given coefficients in doubles, and in pairs of them.
    error: f64,
    error_of_pairs: f64,
    /// The count of one operation in rationals.
    weight: u64,
}

/// The vertex that is farthest away among those looked at.
struct Farthest<const D: usize> {
    square: Rational,
    /// From the nearest point to the vertex.
    vector: [Rational; D],
}

impl<const D: usize> Numbers<D> {
    fn new(difference: &ExactDifference<D>) -> Self {
        let scale = difference.binary_exponent().unwrap_or(0);
        let all = difference.generators.iter().flatten().flatten().chain(&difference.displacement);
        let unit = all.filter(|c| !c.is_zero()).map(Dyadic::exponent).min().unwrap_or(0);
        let in_pairs = |v: &[Dyadic; D]| v.each_ref().map(|c| pair(&c.clone().scaled(-scale)));
        let rounded = |v: &[Dyadic; D]| v.each_ref().map(|c| c.clone().scaled(-scale).to_f64());
        let whole = |v: &[Dyadic; D]| v.each_ref().map(|c| Rational::from(c.units(unit)));
        let rounded_lists = difference.generators.each_ref().map(|list| list.iter().map(rounded).collect());
        let rounded_displacement = rounded(&difference.displacement);
        let size: f64 =
            rounded_lists.iter().flatten().flatten().chain(&rounded_displacement).map(|c: &f64| c.abs()).sum();
        let terms: usize = rounded_lists.iter().map(Vec::len).sum();
        let terms = (terms * D) as f64;
        Self {
            rounded: rounded_lists,
            rounded_displacement,
            pairs: difference.generators.each_ref().map(|list| list.iter().map(in_pairs).collect()),
            displacement_in_pairs: in_pairs(&difference.displacement),
            whole: difference.generators.each_ref().map(|list| list.iter().map(whole).collect()),
            whole_displacement: whole(&difference.displacement),
            is_concentric: difference.is_concentric(),
            unit,
            scale,
            error: UNIT * (terms + FURTHER_ROUNDINGS) * size * LONG_SUM + (terms + 1.0) * PRODUCT_UNDERFLOW,
            error_of_pairs: SUM_OF_PAIRS * (terms + FURTHER_ROUNDINGS) * size * LONG_SUM
                + (terms + 1.0) * PRODUCT_UNDERFLOW,
            weight: 1 + ((scale - unit) / BITS_PER_OPERATION) as u64,
        }
    }

    /// Looks for a farther vertex on one side; none where that takes more than what is left of the operations in
    /// rationals.
    fn look_at_vertices(
        &self,
        generators: &[[Dyadic; D]],
        side: usize,
        farthest: &mut Farthest<D>,
        left: &mut u64,
    ) -> Option<()> {
        let is_one_of_two = |signs: &Vec<Ordering>| signs.first().is_none_or(|sign| sign.is_gt());
        let all = vertices_of(generators).into_iter();
        let listed = all.filter(|signs| !self.is_concentric || is_one_of_two(signs));
        let mut start: Vec<Coefficient<f64>> = vec![Coefficient::AtEnd(true); self.rounded[1 - side].len()];
        let mut vertices: BinaryHeap<Vertex> = BinaryHeap::new();
        for signs in listed {
            let point = vertex(&self.rounded[side], &self.rounded_displacement, side, &signs);
            let mut search = NearestPoint::new(&point, &self.rounded[1 - side], start);
            search.run();
            let (near, vector) = (search.coefficients(), search.vector());
            let upper = (sum_of_products(&vector, &vector).sqrt() + self.error) * THIRTY_ROUNDINGS;
            start = near.clone();
            vertices.push(Vertex { signs, near, upper, is_refined: false });
        }
        let mut least = self.in_scale(&farthest.square);
        while let Some(candidate) = vertices.pop() {
            if candidate.upper < least {
                break;
            }
            if !candidate.is_refined {
                vertices.push(self.refined(side, candidate));
                continue;
            }
            let vector = self.exact_vector(side, &candidate, left)?;
            let square = sum_of_products(&vector, &vector);
            if square > farthest.square {
                *farthest = Farthest { square, vector };
                least = self.in_scale(&farthest.square);
            }
        }
        Some(())
    }

    /// The vertex with its near point in pairs of doubles.
    fn refined(&self, side: usize, candidate: Vertex) -> Vertex {
        let point = vertex(&self.pairs[side], &self.displacement_in_pairs, side, &candidate.signs);
        let inside = |coefficient: &Coefficient<f64>| match coefficient {
            Coefficient::Free(value) if value.abs() < 1.0 => Coefficient::Free(DoubleDouble::from(*value)),
            other => Coefficient::AtEnd(is_positive(other)),
        };
        let mut search = NearestPoint::new(&point, &self.pairs[1 - side], candidate.near.iter().map(inside).collect());
        search.run();
        let vector = search.vector();
        let length = sum_of_products(&vector, &vector).sqrt().high;
        let upper = (length + self.error_of_pairs) * THIRTY_ROUNDINGS;
        let near = search.coefficients().into_iter().map(|coefficient| match coefficient {
            Coefficient::Free(value) => Coefficient::Free(value.high),
            Coefficient::AtEnd(is_positive) => Coefficient::AtEnd(is_positive),
        });
        // a search that ended at a singular system may be farther off than the one in doubles
        match upper < candidate.upper {
            true => Vertex { signs: candidate.signs, near: near.collect(), upper, is_refined: true },
            false => Vertex { is_refined: true, ..candidate },
        }
    }

    /// A length, not above it, in the scale of the doubles.
    fn in_scale(&self, square: &Rational) -> f64 {
        Root::of(square, self.unit - self.scale).below
    }

    /// From the nearest point of the other body to a vertex, exactly; none where that takes more than what is left of
    /// the operations in rationals.
    fn exact_vector(&self, side: usize, candidate: &Vertex, left: &mut u64) -> Option<[Rational; D]> {
        let others = &self.whole[1 - side];
        let point = vertex(&self.whole[side], &self.whole_displacement, side, &candidate.signs);
        // a round takes a product with each generator and a linear system
        let round = (others.len() as u64 * D as u64 + (D as u64).pow(3)).saturating_mul(self.weight);
        let mut begin_with = |start| {
            let mut search = NearestPoint::new(&point, others, start);
            let vector = search.run_within(usize::try_from(*left / round).unwrap_or(usize::MAX));
            *left = left.saturating_sub(round.saturating_mul(search.rounds() as u64));
            vector
        };
        let inside = |coefficient: &Coefficient<f64>| match coefficient {
            Coefficient::Free(value) if value.abs() < 1.0 => Coefficient::Free(rational(*value)),
            other => Coefficient::AtEnd(is_positive(other)),
        };
        let at_end = |coefficient: &Coefficient<f64>| Coefficient::AtEnd(is_positive(coefficient));
        begin_with(candidate.near.iter().map(inside).collect())
            .or_else(|| begin_with(candidate.near.iter().map(at_end).collect()))
    }
}

impl<const D: usize> Numbers<D> {
    /// The distance of the farthest vertex. The lower bound is what a direction of doubles proves: of several
    /// roundings of the vector the first that is as good as can be, or else the best.
    fn distance(&self, farthest: &Farthest<D>) -> Distance<D> {
        let exact = Root::of(&farthest.square, self.unit);
        let whole = farthest.whole_direction();
        let mut best = (0.0, array::from_fn(|k| if k == 0 { 1.0 } else { 0.0 }));
        for step in 0..ROUNDED_DIRECTIONS {
            let Some(direction) = rounded(&whole, step) else { break };
            let proved = self.proved_by(&direction).min(exact.below);
            if proved > best.0 {
                best = (proved, direction);
            }
            if best.0 >= exact.below * GOOD_DIRECTION {
                break;
            }
        }
        Distance { value: exact.nearest, lower: best.0, upper: exact.above, direction: best.1 }
    }

    /// The greatest double not above the difference of the support functions along a direction.
    fn proved_by(&self, direction: &[f64; D]) -> f64 {
        let u = direction.map(Dyadic::from_f64);
        let unit = u.iter().filter(|c| !c.is_zero()).map(Dyadic::exponent).min().unwrap_or(0);
        let u = u.map(|c| Rational::from(c.units(unit)));
        let magnitude = |v: &[Rational; D]| {
            let product = sum_of_products(v, &u);
            if product < Rational::ZERO { -product } else { product }
        };
        let reach = |list: &[[Rational; D]]| list.iter().map(magnitude).fold(Rational::ZERO, |sum, term| sum + term);
        let [own, others] = self.whole.each_ref().map(|list| reach(list));
        let apart = if own > others { own - others } else { others - own };
        let along = apart + magnitude(&self.whole_displacement);
        Root::of(&(&along * &along / sum_of_products(&u, &u)), self.unit).below
    }
}

/// A direction of whole numbers in doubles, of a length about 1: exactly where they are doubles. Each `step` rounds
/// another multiple of it.
fn rounded<const D: usize>(whole: &[Dyadic; D], step: u32) -> Option<[f64; D]> {
    let exponent = whole.iter().filter_map(Dyadic::binary_exponent).max()?;
    let factor = Dyadic::from_f64(1.0 + f64::from(step) / f64::from(ROUNDED_DIRECTIONS));
    Some(whole.each_ref().map(|c| (c * &factor).scaled(-exponent).to_f64()))
}

impl<const D: usize> Farthest<D> {
    /// The direction of the vector in the least whole numbers.
    fn whole_direction(&self) -> [Dyadic; D] {
        let common = self.vector.iter().fold(IBig::ONE, |product, c| {
            let denominator = IBig::from(c.denominator().clone());
            if (&product % &denominator).is_zero() { product } else { product * denominator }
        });
        let common = Rational::from(common);
        let mut whole: [Dyadic; D] =
            array::from_fn(|k| Dyadic::new((&self.vector[k] * &common).numerator().clone(), 0));
        remove_common_factor(&mut whole);
        whole
    }
}
