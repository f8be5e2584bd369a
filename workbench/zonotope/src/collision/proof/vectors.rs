//! The generators of a query in doubles, with what the proofs in doubles need to know of their rounding.
//!
//! A generator M v is off by less than 4 u |M| |v| in each coordinate, so that vector bounds its rounding and, in the
//! place of |v|, the terms of every product with it. At rest both are exact.

use crate::lad::of_generators::seam::generators::{Part, generator_of};
use crate::lad::of_generators::seam::kernel_query::KernelQuery;
use crate::numeric::double_double::BoundedDoubleDouble;
use crate::numeric::tolerance::{DETERMINANT_OF_IMAGES, DETERMINANT_OF_ROWS};

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
        generator_of(&self.parts, index)
    }

    /// A generator by its index, with its size.
    #[inline(always)]
    pub(crate) fn vector(&self, index: usize) -> Vector {
        let [first, second] = &self.parts;
        match index.checked_sub(first.rows.len()) {
            None => Self::of_row(first, &first.rows.list()[index]),
            Some(index) => Self::of_row(second, &second.rows.list()[index]),
        }
    }

    /// A generator to twice the digits of a double.
    #[inline]
    pub(crate) fn pairs(&self, index: usize) -> [BoundedDoubleDouble; 3] {
        let [first, second] = &self.parts;
        let of =
            |part: &Part<'_>, index: usize| part.pair_image(&part.rows.list()[index].map(BoundedDoubleDouble::exact));
        index.checked_sub(first.rows.len()).map_or_else(|| of(first, index), |index| of(second, index))
    }

    /// All generators with their sizes.
    #[inline(always)]
    pub(crate) fn iter(&self) -> impl Iterator<Item = Vector> {
        self.parts.iter().flat_map(|part| part.rows.list().iter().map(move |v| Self::of_row(part, v)))
    }

    #[inline(always)]
    fn of_row(part: &Part<'_>, v: &[f64; 3]) -> Vector {
        Vector { value: part.image(v), size: part.image_of_sizes(&v.map(f64::abs)) }
    }
}
