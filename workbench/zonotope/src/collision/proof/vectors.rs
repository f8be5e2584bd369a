//! The generators of a query in doubles and in pairs of them, with bounds of what rounding makes of images.

use crate::lad::of_generators::seam::generators::{KernelQuery, Part, bounded_generator_of, generator_of};
use crate::numeric::bounded::BoundedVector;
use crate::numeric::double_double::BoundedDoubleDouble;

/// The generators of a query, in the order of their indices.
pub(crate) struct Vectors<'a> {
    pub(crate) parts: [Part<'a>; 2],
}

impl<'a> Vectors<'a> {
    /// The generators of a query; none where entries of a matrix are too large or small for products of doubles.
    #[inline]
    pub(crate) fn of(query: &'a dyn KernelQuery) -> Option<Self> {
        let parts = query.parts();
        let is_moderate = parts.iter().filter_map(|part| part.frame).all(|frame| frame.is_moderate());
        is_moderate.then_some(Self { parts })
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

    /// A generator by its index, with a bound of each coordinate's error.
    #[inline(always)]
    pub(crate) fn bounded(&self, index: usize) -> BoundedVector {
        bounded_generator_of(&self.parts, index)
    }

    /// A generator to twice the digits of a double.
    #[inline]
    pub(crate) fn pairs(&self, index: usize) -> [BoundedDoubleDouble; 3] {
        let [first, second] = &self.parts;
        let of =
            |part: &Part<'_>, index: usize| part.pair_image(&part.rows.list()[index].map(BoundedDoubleDouble::exact));
        index.checked_sub(first.rows.len()).map_or_else(|| of(first, index), |index| of(second, index))
    }

    /// All generators with bounds of their errors.
    #[inline(always)]
    pub(crate) fn iter(&self) -> impl Iterator<Item = BoundedVector> {
        self.parts.iter().flat_map(|part| part.rows.list().iter().map(|v| part.bounded_image(v)))
    }
}
