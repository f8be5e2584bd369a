//! The generators of a query in doubles, with what the proofs in doubles need to know of their rounding and of that of
//! their sums, and the coefficients of three of them that make up for what all others leave. Bounds are in terms of
//! coordinates.
//!
//! A generator M v is off by less than 4 u |M| |v| in each coordinate, so that vector bounds its rounding and, in the
//! place of |v|, the terms of every product with it. At rest both are exact.

use crate::lad::of_generators::seam::generators::{Part, of_row};
use crate::lad::of_generators::seam::kernel_query::KernelQuery;
use crate::numeric::bounded::BoundedVector;
use crate::numeric::double_double::BoundedDoubleDouble;
use crate::numeric::linear::{cyclic_cross_products, dot};
use crate::numeric::tolerance::{
    CUBABLE_SIZES, DETERMINANT_OF_IMAGES, DETERMINANT_OF_ROWS, LONG_SUM, PRODUCT_UNDERFLOW, THIRTY_ROUNDINGS, UNIT,
};

/// The generators of a query, in the order of their indices.
pub(crate) struct Vectors<'a> {
    pub(crate) parts: [Part<'a>; 2],
    /// A determinant of three generators is off by less than this part of the sum of the magnitudes of its terms.
    pub(crate) determinant_error: f64,
}

/// A generator in doubles.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Vector {
    pub(crate) value: [f64; 3],
    /// At least |v|, coordinate by coordinate; of an image, |M| |v|.
    pub(crate) size: [f64; 3],
}

impl<'a> Vectors<'a> {
    /// The generators of a query; none where entries of a matrix are too large or small for products of doubles.
    #[inline]
    pub(crate) fn of(query: &'a dyn KernelQuery) -> Option<Self> {
        let parts = query.parts();
        if parts[0].frame.is_none() && parts[1].frame.is_none() {
            return Some(Self { parts, determinant_error: DETERMINANT_OF_ROWS });
        }
        let is_moderate = parts.iter().filter_map(|part| part.frame).all(|frame| frame.is_moderate());
        is_moderate.then_some(Self { parts, determinant_error: DETERMINANT_OF_IMAGES })
    }

    #[inline(always)]
    pub(crate) fn len(&self) -> usize {
        self.parts[0].rows.len() + self.parts[1].rows.len()
    }

    /// A generator by its index.
    #[inline(always)]
    pub(crate) fn value(&self, index: usize) -> [f64; 3] {
        of_row(&self.parts, index, Part::image)
    }

    /// A generator by its index, with its size.
    #[inline(always)]
    pub(crate) fn vector(&self, index: usize) -> Vector {
        of_row(&self.parts, index, Vector::of)
    }

    /// A generator to twice the digits of a double.
    #[inline]
    pub(crate) fn pairs(&self, index: usize) -> [BoundedDoubleDouble; 3] {
        of_row(&self.parts, index, Part::image_in_pairs)
    }

    /// All generators with their sizes.
    #[inline(always)]
    pub(crate) fn iter(&self) -> impl Iterator<Item = Vector> {
        self.parts.iter().flat_map(|part| part.rows.list().iter().map(move |v| Vector::of(part, v)))
    }

    /// The coefficients with which three generators make up a rest whose coordinates are off by at most `errors`: those
    /// that are certainly within (−1, 1). `None` if the three may be dependent.
    #[inline]
    pub(crate) fn coefficients(
        &self,
        basis: [usize; 3],
        rest: &[f64; 3],
        errors: &[f64; 3],
    ) -> Option<[Option<f64>; 3]> {
        let [a, b, c] = &basis.map(|i| self.vector(i));
        let normals = cyclic_cross_products(&a.value, &b.value, &c.value);
        let areas = [cross_terms(b, c), cross_terms(c, a), cross_terms(a, b)];
        let determinant = dot(&c.value, &normals[2]);
        let least = determinant.abs() - self.determinant_error * dot(&c.size, &areas[2]) - PRODUCT_UNDERFLOW;
        // false for NaN as well
        let is_spanning = least > CUBABLE_SIZES.start * CUBABLE_SIZES.start * CUBABLE_SIZES.start;
        if !is_spanning {
            return None;
        }
        // each term of the product of the rest with a normal goes through seven roundings, and images bring eight more
        let off = [0, 1, 2].map(|k| errors[k] + 16.0 * UNIT * rest[k].abs());
        let coefficient = |k: usize| {
            let numerator = dot(rest, &normals[k]);
            let error = dot(&off, &areas[k]) * LONG_SUM + PRODUCT_UNDERFLOW;
            let is_within = (numerator.abs() + error) * THIRTY_ROUNDINGS < least;
            is_within.then_some(numerator / determinant)
        };
        Some([coefficient(0), coefficient(1), coefficient(2)])
    }
}

impl Vector {
    #[inline(always)]
    fn of(part: &Part<'_>, v: &[f64; 3]) -> Self {
        Self { value: part.image(v), size: part.image_of_sizes(&v.map(f64::abs)) }
    }
}

/// A sum less a multiple of a vector.
#[inline]
pub(crate) fn minus(sum: [f64; 3], factor: f64, v: &[f64; 3]) -> [f64; 3] {
    [sum[0] - factor * v[0], sum[1] - factor * v[1], sum[2] - factor * v[2]]
}

/// The sums of the magnitudes of the terms of a cross product, with room for what underflows.
#[inline]
pub(crate) fn cross_terms(Vector { size: a, .. }: &Vector, Vector { size: b, .. }: &Vector) -> [f64; 3] {
    let terms = |i: usize, j: usize| a[i] * b[j] + a[j] * b[i] + PRODUCT_UNDERFLOW;
    [terms(1, 2), terms(2, 0), terms(0, 1)]
}

/// The first place of the largest value, if one is positive.
#[inline]
pub(crate) fn first_of_largest(values: impl Iterator<Item = (f64, usize)>) -> Option<usize> {
    let (largest, place) = values.fold((0.0, 0), |best, own| if own.0 > best.0 { own } else { best });
    (largest > 0.0).then_some(place)
}

/// The error in doubles of a sum of generators with coefficients in [−1, 1] that is taken from p.
pub(crate) struct SumErrors<'a> {
    pub(crate) p: &'a BoundedVector,
    /// Σ |v| + |p|, coordinate by coordinate.
    pub(crate) sizes: [f64; 3],
    /// The number of generators.
    pub(crate) count: usize,
}

impl SumErrors<'_> {
    /// The bound for each coordinate of a sum of the pass from which so many generators, beside a few, were taken off
    /// one by one, or to which they were put back: each of these is one more addition for every term before it.
    pub(crate) fn after(&self, additions: usize) -> [f64; 3] {
        let roundings = UNIT * (self.count / 2 + 32 + additions) as f64;
        let lost = (self.count + additions) as f64 * PRODUCT_UNDERFLOW;
        [0, 1, 2].map(|k| (self.p[k].error + roundings * self.sizes[k]) * LONG_SUM + lost)
    }
}
